#include "hexoderm/io/calibration_json.h"

#include "hexoderm/base/file.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/io/json_complaints.h"
#include "tests/support/paths.h"
#include "tests/support/random_session.h"
#include "tests/support/result_builder.h"
#include "tests/support/session_matchers.h"
#include "tests/support/solvers.h"
#include "tests/support/temporary_folder.h"

namespace hexoderm {
namespace {

using test::TemporaryFolder;

Matrix6d someCovariance() {
  Matrix6d A;
  for (int k = 0; k < 36; ++k) A(k / 6, k % 6) = 1e-3 / (k + 1.7);
  return A * A.transpose();
}

/// A solved skin in which every key that a calibration can have occurs.
Reconstruction richCalibration() {
  const Session session = readSessionJson(std::filesystem::path(HEXODERM_TEST_DATA) / "three_cells.session.json");
  Reconstruction result = *reconstruct(*session.snapshot());
  result.options.centring = Centring::On;
  result.options.support_axes = SupportAxes::Off;
  result.options.weights = LinkWeights::Residual;
  result.options.class_threshold = 0.75;
  result.options.max_bend_rad = 1.1;
  result.options.gap_model = GapModel::Arc;
  result.options.max_misfit = 4.5;
  result.options.max_opening = 20;
  result.options.goal = {1.5e-3, 0.02};
  result.options.left_out = {CellId(5), CellId(2)};
  PatchReconstruction& patch = result.patches.at(0);
  patch.gap_share = {1.0 / 3, 0.123456789};
  patch.lot = {{0.03, -1.0 / 7, 1e-9}, {0.002, 1.0 / 300, 0}, 0.9 + 1.0 / 9, 1.0 / 700};
  patch.cells.at(1).placed_by = PlacedBy::Links;
  patch.cells.at(1).cov_t_r = someCovariance();
  patch.cells.at(1).accel_offset_g = {0.06, -1.0 / 3, 1e-9};
  patch.cells.at(1).accel_scale = {1.02, 0.98, 2.0 / 3};
  patch.cells.at(2).cov_t_r.reset();
  patch.cells.at(2).accel_offset_g.reset();
  patch.cells.at(2).accel_scale.reset();
  patch.cells.at(2).sensors.push_back({"force 1", "force", {expSO3({0.1, -0.7, 2}), {0.1, 1.0 / 3, -2e-9}}});
  LinkEstimate& link = patch.links.at(1);
  link.used = false;
  link.muted_by = FindingCode::LinkNotRigid;
  link.in_tree = false;
  link.centred = true;
  link.supported = true;
  link.quality = EdgeQuality::Over;
  link.yaw_rad = -0.1234567890123;
  result.layout = computeFlatLayout(*result.model, result.patches);
  result.poses.at(0).new_by_rad = 0.9;
  result.poses.at(0).residual_rad = 0.01;
  result.findings.push_back(makeFinding(FindingCode::LinkNotRigid, Message::verbatim("Odd."), {CellId(2), CellId(5)},
                                        {PortNumber(2), PortNumber(3)}, {PoseId(5)}));
  result.findings.back().severity = Severity::Error;
  result.assessment = {.level = VerdictLevel::NotEnough,
                       .reason = Message::verbatim("Because."),
                       .position_95_m = 0.00123456789,
                       .orientation_95_rad = 0.0333,
                       .limit = Limit::Readings,
                       .limiting_cells = {CellId(2)},
                       .remedy = Remedy::RetakePoses,
                       .next_action = Message::verbatim("Do this."),
                       .retake = {PoseId(5)}};
  result.robot = RobotDescription{"robots/arm.urdf", "00ff", {{"arm", "/opt/arm"}}};
  result.placements = {test::placementWithEverything(patch.origin)};
  return result;
}

nlohmann::json richJson() { return nlohmann::json::parse(calibrationToJson(richCalibration())); }

TEST(CalibrationJson, HoldsWherePatchesAreOnTheRobot) {
  const Reconstruction result = richCalibration();
  const auto back = parseCalibrationJson(calibrationToJson(result), "c.json");
  EXPECT_EQ(back->robot, result.robot);
  ASSERT_EQ(back->placements.size(), 1U);
  test::expectSamePlacement(back->placements[0], result.placements[0]);

  nlohmann::json older = richJson();
  older.erase("robot");
  older.erase("placements");
  EXPECT_FALSE(parseCalibrationJson(older.dump(), "c.json")->robot);
  EXPECT_TRUE(parseCalibrationJson(older.dump(), "c.json")->placements.empty());

  const nlohmann::json package = {{"name", "arm"}, {"folder", "/opt/arm"}};
  test::expectComplaints(
      richJson(),
      {
          {"/placements/0/origin_cell", 77, {"placements[0]", "origin"}},
          {"/placements/0/link", "", {"placements[0]", "a place of this patch on its link"}},
          {"/placements/0/distances/0/to_cell", result.placements[0].origin.value(), {"placements[0]", "two cells"}},
          {"/placements/0/place/cov_t_r/0", -1, {"placements[0].place.cov_t_r"}},
          {"/robot/packages",
           nlohmann::json::array({package, package}),
           {"robot.packages[1].name", "each package once"}},
      },
      [](const std::string& text) { parseCalibrationJson(text, "c.json"); });
}

TEST(CalibrationJson, ComesBackAsItWas) {
  const nlohmann::json before = richJson().flatten();
  const auto back = parseCalibrationJson(richJson().dump(), "c.json");
  const nlohmann::json after = nlohmann::json::parse(calibrationToJson(*back)).flatten();
  EXPECT_EQ(after.size(), before.size());
  for (const auto& [place, value] : before.items()) {
    ASSERT_TRUE(after.contains(place)) << place;
    const auto is_in = [&place = place](const char* unit) { return place.find(unit) != std::string::npos; };
    if (value.is_number_float() && is_in("wxyz")) {
      EXPECT_NEAR(after[place].get<double>(), value.get<double>(), 1e-14) << place;
    } else if (value.is_number_float() && (is_in("deg") || is_in("mm"))) {
      EXPECT_DOUBLE_EQ(after[place].get<double>(), value.get<double>()) << place;
    } else {
      EXPECT_EQ(after[place], value) << place;
    }
  }
  for (const CellPlacement& cell : back->patches.at(0).cells) {
    if (cell.cov_t_r) {
      EXPECT_EQ(*cell.cov_t_r, cell.cov_t_r->transpose()) << "the upper triangle is what is stated";
    }
  }
}

TEST(CalibrationJson, OfARandomSessionIsReadAgain) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Session session = test::RandomSession(seed).draw();
    const auto result = reconstruct(*session.snapshot(), test::by(seed % 2 == 0 ? Solver::Tree : Solver::Global));
    const auto back = parseCalibrationJson(calibrationToJson(*result), "c.json");
    EXPECT_EQ(back->cellCount(), result->cellCount());
    EXPECT_EQ(back->linkCount(), result->linkCount());
    EXPECT_EQ(back->findings, result->findings);
    for (std::size_t patch = 0; patch < result->patches.size(); ++patch) {
      for (std::size_t cell = 0; cell < result->patches[patch].cells.size(); ++cell) {
        const CellPlacement& was = result->patches[patch].cells[cell];
        const CellPlacement& is = back->patches.at(patch).cells.at(cell);
        EXPECT_EQ(is.cell, was.cell);
        EXPECT_EQ(is.T_o_u.t, was.T_o_u.t);
        EXPECT_LT((is.T_o_u.R - was.T_o_u.R).norm(), 1e-15);
        EXPECT_EQ(is.cov_t_r.has_value(), was.cov_t_r.has_value());
      }
    }
  }
}

TEST(CalibrationJson, IsDrawnAsBefore) {
  const Reconstruction result = richCalibration();
  const auto back = parseCalibrationJson(calibrationToJson(result), "c.json");
  ASSERT_EQ(back->layout.cells.size(), 3U);
  ASSERT_EQ(back->layout.links.size(), result.layout.links.size());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back->layout.cells[k].cell, result.layout.cells[k].cell);
    EXPECT_EQ(back->layout.cells[k].center, result.layout.cells[k].center);
  }
}

TEST(CalibrationJson, StatesUnitsAsItsKeysSay) {
  const Reconstruction result = richCalibration();
  const nlohmann::json json = richJson();
  const nlohmann::json& cell = json["patches"][0]["cells"][1];
  ASSERT_EQ(cell["cov_t_r"].size(), 21U);
  const Matrix6d cov = someCovariance();
  EXPECT_EQ(cell["cov_t_r"][1], cov(0, 1));
  EXPECT_EQ(cell["cov_t_r"][6], cov(1, 1));
  EXPECT_EQ(cell["cov_t_r"][20], cov(5, 5));
  EXPECT_DOUBLE_EQ(cell["sigma_t_m"][2].get<double>(), std::sqrt(cov(2, 2)));
  EXPECT_DOUBLE_EQ(cell["sigma_r_rad"][0].get<double>(), std::sqrt(cov(3, 3)));
  EXPECT_DOUBLE_EQ(json["patches"][0]["links"][1]["yaw_deg"].get<double>(), -0.1234567890123 / kDegree);
  EXPECT_DOUBLE_EQ(json["verdict"]["position_95_mm"].get<double>(), 1.23456789);
  EXPECT_EQ(json["options"]["max-yaw-deg"], 40.0);
  EXPECT_EQ(nlohmann::json::parse(
                calibrationToJson(*reconstruct(*Session(*result.model, {}).snapshot())))["options"]["max-bend-deg"],
            60.0);
}

TEST(CalibrationJson, ReadsTheWholePathsOfVersionOne) {
  nlohmann::json json = richJson();
  json["version"] = 1;
  nlohmann::json& cells = json["patches"][0]["cells"];
  for (nlohmann::json& cell : cells) {
    cell.erase("predecessor");
    cell["path"] = cell["id"] == 2 ? nlohmann::json::array({2}) : nlohmann::json::array({2, cell["id"]});
  }
  const auto back = parseCalibrationJson(json.dump(), "old");
  EXPECT_THAT(back->patches[0].pathTo(CellId(5)), testing::ElementsAre(CellId(2), CellId(5)));
  EXPECT_THAT(back->patches[0].pathTo(CellId(2)), testing::ElementsAre(CellId(2)));

  cells[0]["path"] = {2, 5};
  EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(json.dump(), "old"); }),
              saysAll("patches[0].cells[0].path: expected cells"));
  cells[0]["path"] = {99, 1};
  EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(json.dump(), "old"); }),
              saysAll("patches[0].cells[0].path: expected cells"));
}

TEST(CalibrationJson, LeavesOutWhatIsNotKnown) {
  Reconstruction result = richCalibration();
  result.assessment.position_95_m.reset();
  result.assessment.orientation_95_rad.reset();
  const nlohmann::json json = nlohmann::json::parse(calibrationToJson(result));
  const nlohmann::json& cell = json["patches"][0]["cells"][2];
  EXPECT_FALSE(cell.contains("cov_t_r"));
  EXPECT_FALSE(cell.contains("sigma_t_m"));
  EXPECT_FALSE(cell.contains("sigma_r_rad"));
  EXPECT_FALSE(cell.contains("accel_offset_g"));
  EXPECT_FALSE(cell.contains("accel_scale"));
  EXPECT_FALSE(json["patches"][0]["cells"][1].contains("predecessor")) << "the origin";
  EXPECT_TRUE(json["verdict"]["position_95_mm"].is_null());
  const auto back = parseCalibrationJson(json.dump(), "c.json");
  EXPECT_FALSE(back->assessment.position_95_m.has_value());
  EXPECT_FALSE(back->assessment.orientation_95_rad.has_value());
}

TEST(CalibrationJson, KeepsEveryGapModelOfTheGlobalSolver) {
  for (const auto& [model, name] :
       {std::pair(GapModel::Fit, "fit"), {GapModel::Arc, "arc"}, {GapModel::Pivot, "pivot"}}) {
    Reconstruction result = richCalibration();
    result.options.gap_model = model;
    const std::string text = calibrationToJson(result);
    EXPECT_EQ(nlohmann::json::parse(text)["gap_model"], name);
    const auto back = parseCalibrationJson(text, "c.json");
    EXPECT_EQ(back->options.gap_model, model);
    EXPECT_EQ(back->options.solver, Solver::Global);
  }
}

TEST(CalibrationJson, KeepsTheGapModelOfATreeWhichHasNoGapShare) {
  const Session session = readSessionJson(std::filesystem::path(HEXODERM_TEST_DATA) / "three_cells.session.json");
  const std::string text = calibrationToJson(*reconstruct(*session.snapshot(), test::by(Solver::Tree, GapModel::Arc)));
  const nlohmann::json json = nlohmann::json::parse(text);
  EXPECT_EQ(json["solver"], "tree");
  EXPECT_EQ(json["gap_model"], "arc");
  EXPECT_FALSE(json.contains("gap_s"));
  EXPECT_FALSE(json["patches"][0].contains("gap_s"));
  EXPECT_FALSE(json["patches"][0]["cells"][0].contains("accel_offset_g"));
  const auto back = parseCalibrationJson(text, "c.json");
  EXPECT_EQ(back->solver, "tree");
  EXPECT_EQ(back->options.solver, Solver::Tree);
  EXPECT_FALSE(back->patches[0].gap_share.has_value());
}

TEST(CalibrationJson, StatesTheGapShareOfTheLargestPatch) {
  Reconstruction result = richCalibration();
  PatchReconstruction other = test::ResultBuilder().patch(9).cell(9).build().patches[0];
  other.id = PatchId(1);
  other.gap_share = {0.75, 0.25};
  result.patches.insert(result.patches.begin(), other);
  const std::string text = calibrationToJson(result);
  EXPECT_EQ(nlohmann::json::parse(text)["gap_s"], 1.0 / 3);
  const auto back = parseCalibrationJson(text, "c.json");
  EXPECT_EQ(back->patches[0].gap_share.value().share, 0.75);
  EXPECT_EQ(back->patches[1].gap_share.value().share, 1.0 / 3);
  result.patches[1].gap_share.reset();
  EXPECT_FALSE(nlohmann::json::parse(calibrationToJson(result)).contains("gap_s"));
}

TEST(CalibrationJson, ReadsFilesWithoutWhatWeAdd) {
  nlohmann::json json = richJson();
  for (const char* key : {"poses", "gap_model", "gap_s"}) json.erase(key);
  for (const char* key : {"gap_s", "gap_s_sigma", "lot"}) json["patches"][0].erase(key);
  json["verdict"].erase("position_95_mm");
  for (nlohmann::json& link : json["patches"][0]["links"]) {
    for (const char* key : {"centred", "supported", "in_tree", "pose_residual_deg"}) link.erase(key);
  }
  for (nlohmann::json& cell : json["patches"][0]["cells"]) {
    for (nlohmann::json& sensor : cell["sensors"]) sensor.erase("type");
    for (const char* key : {"accel_offset_g", "accel_scale"}) cell.erase(key);
  }
  const auto back = parseCalibrationJson(json.dump(), "c.json");
  EXPECT_EQ(back->options.gap_model, GapModel::Fit) << "the default";
  EXPECT_FALSE(back->patches[0].gap_share.has_value());
  EXPECT_FALSE(back->patches[0].lot.has_value());
  EXPECT_FALSE(back->patches[0].cells[1].accel_offset_g.has_value());
  EXPECT_FALSE(back->patches[0].cells[1].accel_scale.has_value());
  ASSERT_EQ(back->poses.size(), 2U) << "those that the gravity directions name";
  EXPECT_EQ(back->poses[0].pose, PoseId(1));
  EXPECT_EQ(back->poses[1].pose, PoseId(5));
  EXPECT_EQ(back->patches[0].links[0].pose_residual_rad.size(), 2U);
}

TEST(CalibrationJson, SortsCellsThatAnotherProgramLeftUnsorted) {
  nlohmann::json json = richJson();
  nlohmann::json& cells = json["patches"][0]["cells"];
  std::swap(cells[0], cells[2]);
  const auto back = parseCalibrationJson(json.dump(), "c.json");
  EXPECT_EQ(back->patches[0].cells[0].cell, CellId(1));
  EXPECT_NE(back->find(CellId(5)).cell, nullptr);
}

TEST(CalibrationJson, TakesAnEmptySkin) {
  const Session empty(builtInCellModel("hex-bma150"), {});
  const auto back = parseCalibrationJson(calibrationToJson(*reconstruct(*empty.snapshot())), "c.json");
  EXPECT_EQ(back->cellCount(), 0U);
}

TEST(CalibrationJson, NamesTheKeyPathOfWhatIsWrong) {
  test::expectComplaints(
      richJson(),
      {
          {"/solver", "magic", {"c.json: solver: expected", "found \"magic\""}},
          {"/gap_model", "rubber", {"c.json: gap_model", "fit, arc or pivot", "rubber"}},
          {"/options/centre", "maybe", {"c.json: options.centre", "maybe"}},
          {"/patches/0/origin", 99, {"c.json: patches[0].origin: expected a cell of this patch"}},
          {"/patches/0/cells/1/R_o_u/4", 0.5, {"patches[0].cells[1].R_o_u: expected a rotation"}},
          {"/patches/0/cells/1/q_o_u_wxyz",
           {0, 1, 0, 0},
           {"patches[0].cells[1].q_o_u_wxyz: expected the same rotation as R_o_u"}},
          {"/patches/0/cells/1/cov_t_r/20", -1, {"patches[0].cells[1].cov_t_r", "at least 0"}},
          {"/patches/0/cells/1/cov_t_r/1", 1, {"patches[0].cells[1].cov_t_r", "semidefinite"}},
          {"/patches/0/cells/1/id", 1, {"patches[0].cells[1].id: expected each cell once"}},
          {"/patches/0/cells/0/predecessor", 99, {"patches[0].cells[0].predecessor: expected a cell"}},
          {"/patches/0/cells/0/predecessor", 1, {"patches[0].cells[0].predecessor: expected a cell"}},
          {"/patches/0/gravity/0/g_o", {0, 0, 2}, {"patches[0].gravity[0].g_o", "unit vector"}},
          {"/patches/0/links/0/source_port", 9, {"patches[0].links[0].source_port", "hex-bma150"}},
          {"/patches/0/links/0/target", 1, {"patches[0].links[0].source: expected two cells"}},
          {"/patches/0/links/0/target", 99, {"patches[0].links[0].target"}},
          {"/patches/0/links/0/quality", "great", {"patches[0].links[0].quality", "partially"}},
          {"/patches/0/links/1/muted_by", "mood", {"patches[0].links[1].muted_by"}},
          {"/patches/0/links/1/pose_residual_deg", {1}, {"links[1].pose_residual_deg", "3 poses"}},
          {"/findings/0/code", "mood", {"findings[0].code"}},
          {"/verdict/level", "splendid", {"verdict.level"}},
          {"/version", 3, {"c.json: version", "version 3", "up to version 2"}},
          {"/format", "hexoderm-session", {"c.json: format"}},
      },
      [](const std::string& text) { parseCalibrationJson(text, "c.json"); });
  nlohmann::json origin_with_predecessor = richJson();
  origin_with_predecessor["patches"][0]["cells"][1]["predecessor"] = 1;
  EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(origin_with_predecessor.dump(), "c.json"); }),
              saysAll("patches[0].cells[1].predecessor: expected a cell"));
}

TEST(CalibrationJson, WithAnyValueInAnyPlaceIsReadOrRefused) {
  test::expectReadAgainOrRefused(calibrationToJson(richCalibration()), "c.json", [](const std::string& changed) {
    return calibrationToJson(*parseCalibrationJson(changed, "c.json"));
  });
}

TEST(CalibrationJson, IsRefusedWhereverItIsCutOff) {
  const std::string text = calibrationToJson(richCalibration());
  constexpr std::size_t kStep = 7;
  expectRefusedWhereverCutOff(
      text, text.find_last_of('}'), "c.json: ", [](const std::string& cut) { parseCalibrationJson(cut, "c.json"); },
      kStep);
}

TEST(CalibrationJson, IsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "out.calibration.json";
  Reconstruction result = richCalibration();
  writeCalibrationJson(result, path);
  const std::string before = readFile(path);
  EXPECT_EQ(before, calibrationToJson(result));
  EXPECT_EQ(readCalibrationJson(path)->cellCount(), 3U);

  result.patches[0].cells[0].T_o_u.t.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(writeCalibrationJson(result, path), InvalidArgument);
  EXPECT_EQ(readFile(path), before) << "the earlier file is intact";
  EXPECT_THROW(writeCalibrationJson(richCalibration(), folder.path()), StorageError);
  EXPECT_EQ(folder.entryCount(), 1U);
}

}  // namespace
}  // namespace hexoderm
