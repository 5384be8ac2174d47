// `hexoderm-cli parts`: which patches of a simulated robot move together.

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

class CliParts : public Cli {
 protected:
  /// Two patches on the upper arm and one on the forearm, between which an elbow moves. Cells are numbered mount by
  /// mount.
  void takePoses(int poses, const std::string& options = "") const {
    const Outcome outcome =
        run("simulate --robot demo --mount upper_arm:0,0.05,0.1 --mount upper_arm:0,-0.05,0.2 --mount "
            "forearm:0,0.05,0.1 --seed 1 --poses " +
            std::to_string(poses) + " " + options + " -o arm.session.json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  /// Of a cell on its link.
  [[nodiscard]] Eigen::Matrix3d trueRotation(int id) const {
    for (const auto& patch : nlohmann::json::parse(readFile(path("arm.truth.json"))).at("patches")) {
      for (const auto& cell : patch.at("cells")) {
        if (cell.at("id") == id) return matrixOf(cell.at("R"));
      }
    }
    throw std::logic_error("no such cell in the truth");
  }
};

TEST_F(CliParts, GroupsThePatchesOfALinkAndFindsTheElbow) {
  takePoses(8);
  EXPECT_THAT(outputOf("parts arm.session.json"),
              AllOf(HasSubstr("Part 1, in the frame of cell "), HasSubstr("Part 2, in the frame of cell "),
                    HasSubstr("together"), HasSubstr("apart"), HasSubstr("axis (")));

  const auto json = jsonOf("parts arm.session.json --json");
  ASSERT_EQ(json.at("parts").size(), 2U);
  EXPECT_EQ(json.at("pairs").size(), 3U);
  EXPECT_THAT(json.at("not_compared"), IsEmpty());
  const auto& upper_arm = json.at("parts").at(0);
  ASSERT_EQ(upper_arm.at("patches").size(), 2U);
  for (const auto& patch : upper_arm.at("patches")) EXPECT_LE(patch.at("origin").get<int>(), 2 * 17);
  const auto& second = upper_arm.at("patches").at(1);
  const auto q = second.at("q_part_o_wxyz").get<std::array<double, 4>>();
  const Eigen::Matrix3d R_part_o = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  const Eigen::Matrix3d off =
      trueRotation(upper_arm.at("frame_of_cell")) * R_part_o * trueRotation(second.at("origin")).transpose();
  const double sigma_deg = second.at("sigma_deg").get<double>();
  EXPECT_LT(sigma_deg, 10);
  EXPECT_LT(rotationAngle(off), 3 * sigma_deg * kDegree);
  ASSERT_EQ(json.at("relations").size(), 1U);
  EXPECT_EQ(json.at("relations").at(0).at("movement"), "apart");
  EXPECT_EQ(json.at("relations").at(0).at("hinge").at("knowledge"), "found");
}

TEST_F(CliParts, TooFewPosesCantTellAndSayWhatWould) {
  takePoses(1);
  EXPECT_THAT(outputOf("parts arm.session.json", 1), HasSubstr("Next: "));
  const auto json = nlohmann::json::parse(run("parts arm.session.json --json").out);
  for (const auto& relation : json.at("relations")) {
    EXPECT_EQ(relation.at("movement"), "cant_tell");
    EXPECT_THAT(relation.at("what_would_tell").get<std::string>(), Not(IsEmpty()));
    EXPECT_TRUE(relation.at("hinge").is_null());
  }
}

TEST_F(CliParts, ASkinOfOnePatchIsOnePart) {
  ASSERT_EQ(run("simulate --poses 3 -o arm.session.json").exit_code, 0);
  const auto json = jsonOf("parts arm.session.json --json");
  EXPECT_EQ(json.at("parts").size(), 1U);
  EXPECT_THAT(json.at("relations"), IsEmpty());
}

TEST_F(CliParts, WrongFilesGetOneLine) {
  ASSERT_EQ(run("simulate --poses 3 -o arm.session.json").exit_code, 0);
  ASSERT_EQ(run("solve arm.session.json -o arm.calibration.json").exit_code, 0);
  EXPECT_THAT(complaint("parts arm.calibration.json", 3), HasSubstr("this is a calibration"));
  EXPECT_THAT(complaint("parts none.session.json", 3), HasSubstr("none.session.json"));
}

}  // namespace
}  // namespace hexoderm
