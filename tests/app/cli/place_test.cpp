// `hexoderm-cli place`, `links` and `parts`: on which link of a robot patches are and where, and which move together.

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
    outputOf("simulate --robot demo --mount forearm:0.08,0,0.12,0,0,1.5708 --poses 4 --seed 3 -o arm.session.json");
    outputOf("solve arm.session.json -o arm.calibration.json");
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

class CliLinks : public Cli {
 protected:
  /// Patches on the upper arm and the forearm of the demo robot.
  void takePoses(int poses) const {
    outputOf("simulate --robot demo --seed 1 --poses " + std::to_string(poses) + " -o arm.session.json");
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

class CliParts : public Cli {
 protected:
  /// Two patches on the upper arm and one on the forearm, between which an elbow moves. Cells are numbered mount by
  /// mount.
  void takePoses(int poses) const {
    outputOf(
        "simulate --robot demo --mount upper_arm:0,0.05,0.1 --mount upper_arm:0,-0.05,0.2 --mount "
        "forearm:0,0.05,0.1 --seed 1 -o arm.session.json --poses " +
        std::to_string(poses));
  }
  /// Of a cell on its link.
  [[nodiscard]] Eigen::Matrix3d trueRotation(int id) const {
    const auto truth = nlohmann::json::parse(readFile(path("arm.truth.json")));
    for (const auto& patch : truth.at("patches")) {
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
