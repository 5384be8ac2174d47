// `hexoderm-cli links`: on which link of a simulated robot a patch is.

#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

class CliLinks : public Cli {
 protected:
  /// Patches on the upper arm and the forearm of the demo robot.
  void takePoses(int poses) const {
    const Outcome outcome =
        run("simulate --robot demo --seed 1 --poses " + std::to_string(poses) + " -o arm.session.json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  [[nodiscard]] nlohmann::json links(const std::string& options = "") const {
    return nlohmann::json::parse(run("links arm.session.json --robot demo --json " + options).out);
  }
};

TEST_F(CliLinks, PutsPatchesOnTheirLinks) {
  takePoses(8);
  EXPECT_THAT(outputOf("links arm.session.json --robot demo"),
              AllOf(HasSubstr("is on link upper_arm"), HasSubstr("is on link forearm"),
                    HasSubstr("All together: misfit"), HasSubstr("joint shoulder_roll: zero")));

  const nlohmann::json json = links();
  ASSERT_EQ(json.at("patches").size(), 2U);
  for (const auto& patch : json.at("patches")) {
    EXPECT_EQ(patch.at("placed").at("q_l_o_wxyz").size(), 4U);
    EXPECT_EQ(patch.at("residuals").size(), 8U);
  }
  const auto& robot = json.at("robot");
  EXPECT_EQ(robot.at("covariance_rad2").size(), 2 * 3 + robot.at("zeros").size() + 3);

  // The same angles from a file.
  EXPECT_EQ(links("--joints arm.joints.csv").at("patches"), json.at("patches"));
}

TEST_F(CliLinks, SaysWhatIsLeftOpenAndTakesTheOperatorsWord) {
  takePoses(1);
  EXPECT_THAT(outputOf("links arm.session.json --robot demo", 1), HasSubstr("can't be told from one pose"));
  const nlohmann::json put = links("--put 1=upper_arm");
  EXPECT_EQ(put.at("patches").at(0).at("placed").at("link"), "upper_arm");
  EXPECT_TRUE(put.at("patches").at(0).at("chosen"));
}

TEST_F(CliLinks, BadInputIsRefused) {
  takePoses(2);
  EXPECT_EQ(run("links arm.session.json").exit_code, 2) << "no robot";
  EXPECT_EQ(run("links arm.session.json --robot no.urdf").exit_code, 3);
  EXPECT_EQ(run("links no.session.json --robot demo").exit_code, 3);
  EXPECT_THAT(complaint("links arm.session.json --robot demo --put 1=upperarm", 2), HasSubstr("upper_arm"))
      << "what may have been meant";
  EXPECT_EQ(run("links arm.session.json --robot demo --put upper_arm").exit_code, 2);
  EXPECT_EQ(run("links arm.session.json --robot demo --up 0,0,0").exit_code, 2);
  writeFileAtomically(path("joints.csv"), "pose,elbow\n1,30\n");
  EXPECT_THAT(complaint("links arm.session.json --robot demo --joints joints.csv", 3), HasSubstr("joints.csv"));
}

}  // namespace
}  // namespace hexoderm
