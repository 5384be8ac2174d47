// `hexoderm-cli parts`: which patches of a simulated robot move together.

#include "tests/app/cli/cli_program.h"
#include "tests/app/cli/robot_truth.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/units.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hexoderm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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
};

/// The angle between the rotation that a part states for a patch and the true one, and what is stated for it.
struct RotationError {
  double angle_deg = 0;
  double sigma_deg = 0;
};

RotationError rotationErrorOf(const nlohmann::json& part, const nlohmann::json& truth) {
  const auto& patch = part.at("patches").at(1);
  const Eigen::Matrix3d R_l_first = trueRotation(truth, part.at("frame_of_cell"));
  const Eigen::Matrix3d R_l_o = trueRotation(truth, patch.at("origin"));
  const Eigen::Matrix3d off = rotationOf(patch.at("q_part_o_wxyz")).transpose() * R_l_first.transpose() * R_l_o;
  return {toDegrees(Eigen::AngleAxisd(off).angle()), patch.at("sigma_deg").get<double>()};
}

TEST_F(CliParts, GroupsThePatchesOfALinkAndFindsTheElbow) {
  takePoses(8);
  EXPECT_THAT(outputOf("parts arm.session.json"),
              AllOf(HasSubstr("Part 1, in the frame of cell "), HasSubstr("Part 2, in the frame of cell "),
                    HasSubstr("together"), HasSubstr("apart"), HasSubstr("axis (")));

  const auto json = nlohmann::json::parse(run("parts arm.session.json --json").out);
  const auto truth = nlohmann::json::parse(readFile(path("arm.truth.json")));
  ASSERT_EQ(json.at("parts").size(), 2U);
  EXPECT_EQ(json.at("pairs").size(), 3U);
  EXPECT_THAT(json.at("not_compared"), IsEmpty());
  const auto& upper_arm = json.at("parts").at(0);
  ASSERT_EQ(upper_arm.at("patches").size(), 2U);
  for (const auto& patch : upper_arm.at("patches")) EXPECT_LE(patch.at("origin").get<int>(), 2 * 17);
  const RotationError error = rotationErrorOf(upper_arm, truth);
  EXPECT_LT(error.angle_deg, 3 * error.sigma_deg);
  EXPECT_LT(error.sigma_deg, 10);

  ASSERT_EQ(json.at("relations").size(), 1U);
  const auto& elbow = json.at("relations").at(0);
  EXPECT_EQ(elbow.at("movement"), "apart");
  ASSERT_EQ(elbow.at("hinge").at("knowledge"), "found");
  // The elbow turns about y of either link.
  for (const std::string side : {"a", "b"}) {
    const auto& axis = elbow.at("hinge").at("axis_" + side);
    const auto& part = json.at("parts").at(elbow.at(side).get<std::size_t>());
    const auto u = axis.at("u").get<std::vector<double>>();
    const Eigen::Vector3d u_l =
        trueRotation(truth, part.at("frame_of_cell")) * Eigen::Vector3d(u.at(0), u.at(1), u.at(2));
    const double off_deg = toDegrees(std::acos(std::min(1.0, std::abs(u_l.y()))));
    EXPECT_LT(off_deg, 3 * axis.at("sigma_deg").get<double>()) << side;
  }
}

TEST_F(CliParts, TooFewPosesCantTellAndSayWhatWould) {
  takePoses(1);
  EXPECT_THAT(outputOf("parts arm.session.json", 1), HasSubstr("Next: "));
  const auto json = nlohmann::json::parse(run("parts arm.session.json --json").out);
  for (const auto& relation : json.at("relations")) {
    EXPECT_EQ(relation.at("movement"), "cant_tell");
    EXPECT_THAT(relation.at("what_would_tell").get<std::string>(), ::testing::Not(IsEmpty()));
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
