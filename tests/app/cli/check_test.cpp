// `hexoderm-cli check`: an old calibration against poses of today.

#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

class CliCheck : public Cli {
 protected:
  CliCheck() {
    EXPECT_EQ(run("simulate --poses 4 --seed 1 -o arm.session.json").exit_code, 0);
    EXPECT_EQ(run("solve arm.session.json -o arm.calibration.json").exit_code, 0);
    before_ = readFile(path("arm.calibration.json"));
  }
  void TearDown() override { EXPECT_EQ(readFile(path("arm.calibration.json")), before_); }

 private:
  std::string before_;
};

TEST_F(CliCheck, SaysThatACalibrationHolds) {
  ASSERT_EQ(run("simulate --poses 2 --seed 1 -o today.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("check arm.calibration.json today.session.json"),
              AllOf(HasSubstr("2 poses against the calibration of 17 cells"),
                    HasSubstr("All 17 cells are as calibrated"), Not(HasSubstr("turned by"))));
}

TEST_F(CliCheck, NamesWhatChangedAndEndsWithOne) {
  ASSERT_EQ(run("simulate --poses 2 --seed 1 --fault yawed:5 --fault dead:7 -o today.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("check arm.calibration.json today.session.json", 1),
              AllOf(HasSubstr("turned by "), HasSubstr("dead: it reads no gravity"),
                    HasSubstr("Not as calibrated: cells 5 and 7."), HasSubstr("came loose"),
                    HasSubstr("Check the sensor, plug and cable")));
  const auto json = jsonOf("check arm.calibration.json today.session.json --json", 1);
  EXPECT_EQ(json.at("changed"), true);
  EXPECT_THAT(json.at("advice").get<std::string>(), HasSubstr("came loose"));
  ASSERT_EQ(json.at("cells").size(), 17);
  const auto& turned = json.at("cells").at(4);
  EXPECT_EQ(turned.at("cell"), 5);
  EXPECT_EQ(turned.at("change"), "turned");
  EXPECT_NEAR(turned.at("turn_deg").get<double>(), 20, 1);
  EXPECT_LT(turned.at("turn_sigma_deg").get<double>(), 1);
  EXPECT_TRUE(turned.at("offset_drift_mg").is_null());
  EXPECT_EQ(json.at("cells").at(6).at("change"), "broken");
  EXPECT_EQ(json.at("cells").at(0).at("change"), "none");
}

TEST_F(CliCheck, TakesPosesLiveAndKeepsThemOnRequest) {
  EXPECT_THAT(outputOf("check arm.calibration.json --source 'sim:x17?seed=1&speed=max' --auto --poses 2 --timeout 600 "
                       "-o today.hexo"),
              HasSubstr("All 17 cells are as calibrated"));
  EXPECT_EQ(run("check arm.calibration.json today.hexo").exit_code, 0);
  // Another skin's sensors have other offsets, and its cells lie otherwise.
  EXPECT_THAT(
      outputOf("check arm.calibration.json --source 'sim:x17?seed=2&speed=max' --auto --timeout 600 --quiet", 1),
      Not(HasSubstr("  as calibrated")));
}

TEST_F(CliCheck, WrongFilesGetOneLine) {
  ASSERT_EQ(run("simulate --poses 2 --patch ring8 -o ring.session.json").exit_code, 0);
  ASSERT_EQ(run("simulate --poses 0 -o none.session.json").exit_code, 0);
  EXPECT_THAT(complaint("check arm.session.json arm.session.json", 3), HasSubstr("this is a session"));
  EXPECT_THAT(complaint("check arm.calibration.json arm.calibration.json", 3), HasSubstr("this is a calibration"));
  EXPECT_THAT(complaint("check arm.calibration.json ring.session.json", 3),
              AllOf(HasSubstr("arm.calibration.json: "), HasSubstr("another skin"), HasSubstr("link ")));
  EXPECT_THAT(complaint("check arm.calibration.json none.session.json", 3), HasSubstr("no pose"));
  EXPECT_THAT(complaint("check arm.calibration.json", 2), HasSubstr("--source"));
  EXPECT_THAT(complaint("check arm.calibration.json arm.session.json --source sim:x17", 2), HasSubstr("either"));
}

}  // namespace
}  // namespace hexoderm
