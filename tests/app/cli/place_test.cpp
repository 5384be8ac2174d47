// `hexoderm-cli place`: where on a link a patch lies, and what export makes of it.

#include "hexoderm/base/se3.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

Eigen::Vector3d vectorOf(const nlohmann::json& numbers) {
  const auto t = numbers.get<std::vector<double>>();
  return {t.at(0), t.at(1), t.at(2)};
}

/// The demo robot with a patch on its forearm.
class CliPlace : public Cli {
 protected:
  CliPlace() {
    EXPECT_EQ(run("simulate --robot demo --mount forearm:0.08,0,0.12,0,0,1.5708 --poses 4 --seed 3 -o arm.session.json")
                  .exit_code,
              0);
    EXPECT_EQ(run("solve arm.session.json -o arm.calibration.json").exit_code, 0);
    const auto calibration = nlohmann::json::parse(readFile(path("arm.calibration.json")));
    origin_ = calibration["patches"][0]["origin"].get<int>();
    const auto truth = nlohmann::json::parse(readFile(path("arm.truth.json")));
    for (const auto& cell : truth["patches"][0]["cells"]) {
      if (cell["id"] != origin_) continue;
      T_l_o_ = {matrixOf(cell["R"]), vectorOf(cell["t_m"])};
    }
  }
  /// --rotation of the truth.
  [[nodiscard]] std::string rotation() const {
    const Eigen::Vector3d rpy = rpyFromRotation(T_l_o_.R) / kDegree;
    return " --rotation " + formatFixed(rpy.x(), 4) + "," + formatFixed(rpy.y(), 4) + "," + formatFixed(rpy.z(), 4);
  }
  /// --point of the origin's true place.
  [[nodiscard]] std::string point() const {
    return " --point " + std::to_string(origin_) + ":" + formatFixed(T_l_o_.t.x(), 6) + "," +
           formatFixed(T_l_o_.t.y(), 6) + "," + formatFixed(T_l_o_.t.z(), 6);
  }

  int origin_ = 0;
  SE3 T_l_o_;
};

TEST_F(CliPlace, PlacesAPatchThatExportPutsOnTheLink) {
  for (const std::string input : {"arm.session.json", "arm.calibration.json"}) {
    EXPECT_THAT(
        outputOf("place " + input + " --robot demo --link forearm" + rotation() + point() + " -o placements.json"),
        AllOf(HasSubstr("one place on link forearm fits, certain to"), HasSubstr("Place 1: misfit"),
              HasSubstr("Place 1 is written to placements.json")));
    const auto file = nlohmann::json::parse(readFile(path("placements.json")));
    EXPECT_LT((vectorOf(file["placements"][0]["t_m"]) - T_l_o_.t).norm(), 0.004);
    EXPECT_EQ(file["placements"][0]["origin_cell"], origin_);
  }
  EXPECT_EQ(run("export arm.calibration.json --to urdf --placements placements.json -o arm.urdf").exit_code, 0);
  EXPECT_THAT(readFile(path("arm.urdf")), HasSubstr("\"forearm\""));
}

TEST_F(CliPlace, ExportTakesThePlacesThatTheCalibrationHolds) {
  auto session = nlohmann::json::parse(readFile(path("arm.session.json")));
  nlohmann::json place = {{"R", nlohmann::json::array()}, {"t_m", nlohmann::json::array()}};
  for (Eigen::Index k = 0; k < 9; ++k) place["R"].push_back(T_l_o_.R(k / 3, k % 3));
  for (Eigen::Index k = 0; k < 3; ++k) place["t_m"].push_back(T_l_o_.t[k]);
  session["placements"] =
      nlohmann::json::array({{{"origin_cell", origin_}, {"link", "forearm"}, {"by_surface", true}, {"place", place}}});
  writeFileAtomically(path("placed.session.json"), session.dump());
  EXPECT_EQ(run("solve placed.session.json -o placed.calibration.json").exit_code, 0);
  EXPECT_EQ(run("export placed.calibration.json --to urdf -o placed.urdf").exit_code, 0);
  EXPECT_THAT(readFile(path("placed.urdf")), HasSubstr("\"forearm\""));
  // What is said on the command line counts instead.
  EXPECT_EQ(run("export placed.calibration.json --to urdf --place hand:0,0,0.1,0,0,0 -o hand.urdf").exit_code, 0);
  EXPECT_THAT(readFile(path("hand.urdf")), AllOf(HasSubstr("\"hand\""), Not(HasSubstr("\"forearm\""))));
}

TEST_F(CliPlace, PrintsEveryCellInTheFrameOfTheLinkAsJson) {
  const Outcome outcome = run("place arm.session.json --robot demo --link forearm --json" + rotation());
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(json["candidates"].empty()) << outcome.out;
  const auto& patch = json["candidates"][0]["patches"][0];
  EXPECT_EQ(patch["cells"].size(), 17U);
  EXPECT_EQ(patch["cells"][0]["cov_t_r"].size(), 21U);
  EXPECT_EQ(patch["link"], "forearm");
  EXPECT_EQ(outcome.exit_code, json["verdict"] == "placed" ? 0 : 1);
}

/// From gravity and joint angles: R_l_o with its covariance goes from links to place.
TEST_F(CliPlace, TakesTheRotationThatLinksFinds) {
  const std::string place = "place arm.session.json --robot demo --link forearm --json";
  const Outcome outcome = run(place + " --rotation links" + point());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(json["candidates"].empty()) << outcome.out;
  EXPECT_LT((vectorOf(json["candidates"][0]["patches"][0]["t_m"]) - T_l_o_.t).norm(), 0.004);

  // By a point alone the place is turned exactly as links says, and as certainly.
  const auto links = nlohmann::json::parse(
      run("links arm.session.json --robot demo --put " + std::to_string(origin_) + "=forearm --json").out);
  const auto& turn = links["patches"][0]["placed"];
  const auto q = turn["q_l_o_wxyz"].get<std::vector<double>>();
  const Eigen::Matrix3d R_links = Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3)).toRotationMatrix();
  EXPECT_LT(rotationAngle(R_links.transpose() * T_l_o_.R), 4 * turn["sigma_deg"].get<double>() * kDegree);
  const auto by_point = nlohmann::json::parse(run(place + " --rotation links --no-surface" + point()).out);
  const auto& alone = by_point["candidates"][0]["patches"][0];
  EXPECT_LT(rotationAngle(R_links.transpose() * matrixOf(alone["R"])), 1e-4);
  // The 21 numbers above the diagonal, row by row: those of the rotation begin at 15.
  EXPECT_NEAR(alone["cov_t_r"][15].get<double>(), turn["covariance_rad2"][0][0].get<double>(),
              0.05 * turn["covariance_rad2"][0][0].get<double>());

  // The same angles from a table.
  EXPECT_EQ(run(place + " --rotation links --joints arm.joints.csv" + point()).out, outcome.out);
}

TEST_F(CliPlace, SaysWhereGravityGivesNoRotation) {
  EXPECT_THAT(complaint("place arm.calibration.json --robot demo --link forearm --rotation links", 3),
              HasSubstr("arm.calibration.json"));
  EXPECT_THAT(complaint("place arm.session.json --robot demo --link forearm --joints arm.joints.csv", 2),
              HasSubstr("go with --rotation links"));
  EXPECT_THAT(errorOf("place arm.session.json --robot demo --link hand --rotation links", 1), HasSubstr("link hand"));
  auto session = nlohmann::json::parse(readFile(path("arm.session.json")));
  for (auto& pose : session["poses"]) pose.erase("joint_angles");
  writeFileAtomically(path("bare.session.json"), session.dump());
  EXPECT_THAT(complaint("place bare.session.json --robot demo --link forearm --rotation links", 3),
              AllOf(HasSubstr("no pose has joint angles"), HasSubstr("--joints")));
}

TEST_F(CliPlace, RefusesWhatMakesNoSense) {
  const auto says = [this](const std::string& arguments, int code) {
    return complaint("place arm.calibration.json --robot demo " + arguments, code);
  };
  EXPECT_THAT(says("--link fourarm", 2), HasSubstr("has no link fourarm"));
  EXPECT_THAT(says("--link forearm --point 1:0,0", 2), HasSubstr("--point: expected CELL:x,y,z[:sigma]"));
  EXPECT_THAT(says("--link forearm --point 99:0,0,0", 2), HasSubstr("no patch holds a cell 99"));
  EXPECT_THAT(says("--link forearm --rotation 1,2", 2),
              HasSubstr("--rotation: expected [CELL@]roll,pitch,yaw[:sigma]"));
  EXPECT_THAT(says("--link forearm --distance 1:2:0.1", 2), HasSubstr("cells 1 and 2 are of one patch"));
  EXPECT_THAT(says("--link forearm --no-surface", 2), HasSubstr("nothing says where on the link the patch lies"));
}

TEST_F(CliPlace, WritesNoPlaceThatDoesNotFit) {
  EXPECT_THAT(outputOf("place arm.calibration.json --robot demo --link upper_arm -o placements.json" + rotation(), 1),
              AllOf(HasSubstr("no place on link upper_arm fits"), HasSubstr("Place 1 (does not fit)")));
  EXPECT_FALSE(exists("placements.json"));
}

}  // namespace
}  // namespace hexoderm
