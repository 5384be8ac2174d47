#include "hexoderm/io/calibration_json.h"

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/units.h"
#include "tests/support/error_matchers.h"
#include "tests/support/json_mutations.h"
#include "tests/support/paths.h"
#include "tests/support/result_builder.h"
#include "tests/support/rich_calibration.h"
#include "tests/support/session_matchers.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace hexoderm {
namespace {

using test::messageOf;
using test::richCalibration;
using test::saysAll;
using test::TemporaryFolder;

nlohmann::json richJson() { return nlohmann::json::parse(calibrationToJson(richCalibration())); }

std::string calibrationComplaint(const std::string& pointer, const nlohmann::json& value) {
  nlohmann::json json = richJson();
  json.at(nlohmann::json::json_pointer(pointer)) = value;
  return messageOf<FormatError>([&] { parseCalibrationJson(json.dump(), "c.json"); });
}

void expectSamePlacement(const CellPlacement& a, const CellPlacement& b) {
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.body_part, b.body_part);
  EXPECT_EQ(a.placed_by, b.placed_by);
  EXPECT_EQ(a.T_o_u.R, b.T_o_u.R);
  EXPECT_EQ(a.T_o_u.t, b.T_o_u.t);
  ASSERT_EQ(a.cov_t_r.has_value(), b.cov_t_r.has_value());
  if (a.cov_t_r) {
    // The upper triangle is what is stated.
    const Matrix6d upper_a = a.cov_t_r->triangularView<Eigen::Upper>();
    const Matrix6d upper_b = b.cov_t_r->triangularView<Eigen::Upper>();
    EXPECT_EQ(upper_a, upper_b);
    EXPECT_EQ(*b.cov_t_r, b.cov_t_r->transpose());
  }
  EXPECT_EQ(a.accel_offset_g, b.accel_offset_g);
  EXPECT_EQ(a.accel_scale, b.accel_scale);
  EXPECT_EQ(a.predecessor, b.predecessor);
  ASSERT_EQ(a.sensors.size(), b.sensors.size());
  for (std::size_t k = 0; k < a.sensors.size(); ++k) {
    EXPECT_EQ(a.sensors[k].name, b.sensors[k].name);
    EXPECT_EQ(a.sensors[k].type, b.sensors[k].type);
    EXPECT_EQ(a.sensors[k].T_o_s.t, b.sensors[k].T_o_s.t);
    EXPECT_TRUE(a.sensors[k].T_o_s.R.isApprox(b.sensors[k].T_o_s.R, 1e-14)) << "through a quaternion";
  }
}

void expectSameLink(const LinkEstimate& a, const LinkEstimate& b) {
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.target, b.target);
  EXPECT_EQ(a.R_c_n, b.R_c_n);
  EXPECT_EQ(a.quality, b.quality);
  EXPECT_EQ(a.singular_values, b.singular_values);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_DOUBLE_EQ(a.residual_rad, b.residual_rad);
  EXPECT_DOUBLE_EQ(a.sigma_rad, b.sigma_rad);
  EXPECT_DOUBLE_EQ(a.bend_rad, b.bend_rad);
  EXPECT_DOUBLE_EQ(a.twist_rad, b.twist_rad);
  EXPECT_DOUBLE_EQ(a.yaw_rad, b.yaw_rad);
  EXPECT_EQ(a.centred, b.centred);
  EXPECT_EQ(a.supported, b.supported);
  EXPECT_EQ(a.used, b.used);
  EXPECT_EQ(a.in_tree, b.in_tree);
  EXPECT_EQ(a.muted_by, b.muted_by);
  ASSERT_EQ(a.pose_residual_rad.size(), b.pose_residual_rad.size());
  for (std::size_t k = 0; k < a.pose_residual_rad.size(); ++k) {
    ASSERT_EQ(a.pose_residual_rad[k].has_value(), b.pose_residual_rad[k].has_value());
    EXPECT_DOUBLE_EQ(a.pose_residual_rad[k].value_or(0), b.pose_residual_rad[k].value_or(0));
  }
}

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

  EXPECT_THAT(calibrationComplaint("/placements/0/origin_cell", 77), saysAll("placements[0]", "origin"));
  EXPECT_THAT(calibrationComplaint("/placements/0/by_surface", 1), saysAll("placements[0].by_surface"));
  EXPECT_THAT(calibrationComplaint("/placements/0/link", ""),
              saysAll("placements[0]", "a place of this patch on its link"));
  EXPECT_THAT(calibrationComplaint("/placements/0/points/0/sigma_m", 0), saysAll("placements[0].points[0].sigma_m"));
  EXPECT_THAT(calibrationComplaint("/placements/0/distances/0/to_cell", result.placements[0].origin.value()),
              saysAll("placements[0]", "two cells"));
  EXPECT_THAT(calibrationComplaint("/placements/0/place/cov_t_r/0", -1), saysAll("placements[0].place.cov_t_r"));
  const nlohmann::json package = {{"name", "arm"}, {"folder", "/opt/arm"}};
  EXPECT_THAT(calibrationComplaint("/robot/packages", nlohmann::json::array({package, package})),
              saysAll("robot.packages[1].name", "each package once"));
}

TEST(CalibrationJson, ComesBackAsItWas) {
  const Reconstruction result = richCalibration();
  const auto back = parseCalibrationJson(calibrationToJson(result), "c.json");
  EXPECT_EQ(back->solver, result.solver);
  EXPECT_EQ(back->options.solver, Solver::Global);
  EXPECT_EQ(back->options.gap_model, GapModel::Arc);
  EXPECT_EQ(back->options.left_out, result.options.left_out);
  EXPECT_EQ(back->options.centring, result.options.centring);
  EXPECT_EQ(back->options.support_axes, result.options.support_axes);
  EXPECT_EQ(back->options.weights, result.options.weights);
  EXPECT_EQ(back->options.class_threshold, result.options.class_threshold);
  EXPECT_EQ(back->options.max_bend_rad, result.options.max_bend_rad);
  EXPECT_EQ(back->options.max_twist_rad, result.options.max_twist_rad);
  EXPECT_EQ(back->options.max_yaw_rad, result.options.max_yaw_rad);
  EXPECT_EQ(back->options.max_misfit, result.options.max_misfit);
  EXPECT_EQ(back->options.max_opening, result.options.max_opening);
  EXPECT_EQ(back->source.file, "three_cells.session.json");
  EXPECT_EQ(back->source.sha256, result.source.sha256);
  EXPECT_EQ(back->source.text, result.source.text);
  EXPECT_EQ(cellModelToJson(*back->model), cellModelToJson(*result.model));

  ASSERT_EQ(back->poses.size(), result.poses.size());
  for (std::size_t k = 0; k < back->poses.size(); ++k) {
    EXPECT_EQ(back->poses[k].pose, result.poses[k].pose);
    EXPECT_EQ(back->poses[k].label, result.poses[k].label);
    EXPECT_EQ(back->poses[k].enabled, result.poses[k].enabled);
    EXPECT_EQ(back->poses[k].cells_measured, result.poses[k].cells_measured);
    EXPECT_EQ(back->poses[k].noise_g, result.poses[k].noise_g);
    EXPECT_EQ(back->poses[k].new_by_rad.has_value(), result.poses[k].new_by_rad.has_value());
    EXPECT_EQ(back->poses[k].residual_rad.has_value(), result.poses[k].residual_rad.has_value());
  }
  EXPECT_DOUBLE_EQ(back->poses[0].new_by_rad.value_or(0), 0.9);

  ASSERT_EQ(back->patches.size(), result.patches.size());
  for (std::size_t p = 0; p < back->patches.size(); ++p) {
    const PatchReconstruction& a = result.patches[p];
    const PatchReconstruction& b = back->patches[p];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.origin, b.origin);
    ASSERT_EQ(a.gap_share.has_value(), b.gap_share.has_value());
    if (a.gap_share) {
      EXPECT_EQ(a.gap_share->share, b.gap_share->share);
      EXPECT_EQ(a.gap_share->sigma, b.gap_share->sigma);
    }
    ASSERT_EQ(a.gravity.size(), b.gravity.size());
    for (std::size_t k = 0; k < a.gravity.size(); ++k) {
      EXPECT_EQ(a.gravity[k].pose, b.gravity[k].pose);
      EXPECT_EQ(a.gravity[k].g_o, b.gravity[k].g_o);
      EXPECT_DOUBLE_EQ(a.gravity[k].sigma_rad, b.gravity[k].sigma_rad);
    }
    ASSERT_EQ(a.cells.size(), b.cells.size());
    for (std::size_t k = 0; k < a.cells.size(); ++k) expectSamePlacement(a.cells[k], b.cells[k]);
    ASSERT_EQ(a.links.size(), b.links.size());
    for (std::size_t k = 0; k < a.links.size(); ++k) expectSameLink(a.links[k], b.links[k]);
  }
  EXPECT_EQ(back->findings, result.findings);
  EXPECT_EQ(back->assessment.level, VerdictLevel::NotEnough);
  EXPECT_EQ(back->assessment.reason.english(), "Because.");
  EXPECT_EQ(back->assessment.next_action.english(), "Do this.");
  EXPECT_EQ(back->assessment.limit, Limit::Readings);
  EXPECT_THAT(back->assessment.limiting_cells, testing::ElementsAre(CellId(2)));
  EXPECT_EQ(back->assessment.remedy, Remedy::RetakePoses);
  EXPECT_THAT(back->assessment.retake, testing::ElementsAre(PoseId(5)));
  EXPECT_DOUBLE_EQ(back->assessment.position_95_m.value_or(0), 0.00123456789);
  EXPECT_DOUBLE_EQ(back->assessment.orientation_95_rad.value_or(0), 0.0333);
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

TEST(CalibrationJson, HasTheKeysOfTheFormat) {
  const nlohmann::json json = richJson();
  for (const char* key : {"format", "version", "solver", "gap_model", "gap_s", "options", "source", "cell_model",
                          "patches", "findings", "verdict"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  const nlohmann::json& patch = json["patches"][0];
  for (const char* key : {"id", "origin", "gap_s", "gap_s_sigma", "gravity", "cells", "links"})
    EXPECT_TRUE(patch.contains(key)) << key;
  for (const char* key : {"pose", "g_o", "sigma_deg"}) EXPECT_TRUE(patch["gravity"][0].contains(key)) << key;
  const nlohmann::json& cell = patch["cells"][1];
  for (const char* key : {"id", "body_part", "placed_by", "R_o_u", "q_o_u_wxyz", "t_o_u_m", "cov_t_r", "sigma_t_m",
                          "sigma_r_rad", "sensors", "accel_offset_g", "accel_scale"}) {
    EXPECT_TRUE(cell.contains(key)) << key;
  }
  EXPECT_FALSE(cell.contains("predecessor")) << "the origin";
  EXPECT_EQ(patch["cells"][0].at("predecessor"), 2);
  for (const char* key : {"name", "t_o_m", "q_o_wxyz"}) EXPECT_TRUE(cell["sensors"][0].contains(key)) << key;
  for (const char* key :
       {"source", "source_port", "target", "target_port", "R_c_n", "quality", "singular_values", "weight",
        "residual_deg", "sigma_deg", "bend_deg", "twist_deg", "yaw_deg", "used", "muted_by"}) {
    EXPECT_TRUE(patch["links"][1].contains(key)) << key;
  }
  for (const char* key : {"code", "severity", "text", "cells", "ports", "poses"}) {
    EXPECT_TRUE(json["findings"][0].contains(key)) << key;
  }
  for (const char* key : {"level", "reason", "position_95_mm", "orientation_95_deg", "next_action"}) {
    EXPECT_TRUE(json["verdict"].contains(key)) << key;
  }
}

TEST(CalibrationJson, StatesUnitsAsItsKeysSay) {
  const Reconstruction result = richCalibration();
  const nlohmann::json json = richJson();
  const nlohmann::json& cell = json["patches"][0]["cells"][1];
  ASSERT_EQ(cell["cov_t_r"].size(), 21U);
  const Matrix6d cov = test::someCovariance();
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
  SolverOptions options;
  options.solver = Solver::Tree;
  options.gap_model = GapModel::Arc;
  const std::string text = calibrationToJson(*reconstruct(*session.snapshot(), options));
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
  for (const char* key : {"gap_s", "gap_s_sigma"}) json["patches"][0].erase(key);
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
  EXPECT_THAT(calibrationComplaint("/solver", "magic"), saysAll("c.json: solver: expected", "found \"magic\""));
  EXPECT_THAT(calibrationComplaint("/gap_model", "rubber"),
              saysAll("c.json: gap_model", "fit, arc or pivot", "rubber"));
  EXPECT_THAT(calibrationComplaint("/gap_model", 1), saysAll("c.json: gap_model: expected a"));
  EXPECT_THAT(calibrationComplaint("/gap_s", "half"), saysAll("c.json: gap_s: expected a"));
  EXPECT_THAT(calibrationComplaint("/patches/0/gap_s", nlohmann::json::array()),
              saysAll("c.json: patches[0].gap_s: expected a"));
  EXPECT_THAT(calibrationComplaint("/patches/0/gap_s_sigma", -0.1), saysAll("patches[0].gap_s_sigma", "at least 0"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/accel_offset_g", {0, 1}),
              saysAll("patches[0].cells[1].accel_offset_g"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/accel_scale/2", "1"),
              saysAll("patches[0].cells[1].accel_scale[2]"));
  EXPECT_THAT(calibrationComplaint("/options/centre", "maybe"), saysAll("c.json: options.centre", "maybe"));
  EXPECT_THAT(calibrationComplaint("/patches", 1), saysAll("c.json: patches: expected an array"));
  EXPECT_THAT(calibrationComplaint("/patches/0/origin", 99),
              saysAll("c.json: patches[0].origin: expected a cell of this patch"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/R_o_u/4", 0.5),
              saysAll("patches[0].cells[1].R_o_u: expected a rotation"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/q_o_u_wxyz", {0, 1, 0, 0}),
              saysAll("patches[0].cells[1].q_o_u_wxyz: expected the same rotation as R_o_u"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/t_o_u_m", {0, 1}),
              saysAll("patches[0].cells[1].t_o_u_m", "array of 2"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/cov_t_r", {1, 2}), saysAll("patches[0].cells[1].cov_t_r", "21"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/cov_t_r/20", -1),
              saysAll("patches[0].cells[1].cov_t_r", "at least 0"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/cov_t_r/1", 1),
              saysAll("patches[0].cells[1].cov_t_r", "semidefinite"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/sigma_t_m/0", -1), saysAll("patches[0].cells[1].sigma_t_m"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/id", 1),
              saysAll("patches[0].cells[1].id: expected each cell once"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/1/id", -1),
              saysAll("patches[0].cells[1].id: expected a whole number"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/0/predecessor", 99),
              saysAll("patches[0].cells[0].predecessor: expected a cell"));
  EXPECT_THAT(calibrationComplaint("/patches/0/cells/0/predecessor", 1),
              saysAll("patches[0].cells[0].predecessor: expected a cell"));
  nlohmann::json origin_with_predecessor = richJson();
  origin_with_predecessor["patches"][0]["cells"][1]["predecessor"] = 1;
  EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(origin_with_predecessor.dump(), "c.json"); }),
              saysAll("patches[0].cells[1].predecessor: expected a cell"));
  EXPECT_THAT(calibrationComplaint("/patches/0/gravity/0/g_o", {0, 0, 2}),
              saysAll("patches[0].gravity[0].g_o", "unit vector"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/0/source_port", 9),
              saysAll("patches[0].links[0].source_port", "hex-bma150"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/0/target", 1),
              saysAll("patches[0].links[0].source: expected two cells"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/0/target", 99), saysAll("patches[0].links[0].target"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/0/quality", "great"),
              saysAll("patches[0].links[0].quality", "partially"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/1/muted_by", "mood"), saysAll("patches[0].links[1].muted_by"));
  EXPECT_THAT(calibrationComplaint("/patches/0/links/1/pose_residual_deg", {1}),
              saysAll("links[1].pose_residual_deg", "3 poses"));
  EXPECT_THAT(calibrationComplaint("/findings/0/code", "mood"), saysAll("findings[0].code"));
  EXPECT_THAT(calibrationComplaint("/verdict/level", "splendid"), saysAll("verdict.level"));
  EXPECT_THAT(calibrationComplaint("/verdict/position_95_mm", -1), saysAll("verdict.position_95_mm", "at least 0"));
  EXPECT_THAT(calibrationComplaint("/version", 3), saysAll("c.json: version", "version 3", "up to version 2"));
  EXPECT_THAT(calibrationComplaint("/format", "hexoderm-session"), saysAll("c.json: format"));
}

TEST(CalibrationJson, NamesTheKeyPathOfNumbersThatAreNotFinite) {
  std::string text = calibrationToJson(richCalibration());
  const std::size_t at = text.find("\"weight\": ") + 10;
  text.replace(at, 3, "1e999");
  EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(text, "c.json"); }),
              saysAll("c.json: patches[0].links[0].weight: expected a finite number, found 1e999"));
  for (const auto& [key, path] : {std::pair("\n \"gap_s\": ", "gap_s"),
                                  {"\n   \"gap_s\": ", "patches[0].gap_s"},
                                  {"\"gap_s_sigma\": ", "patches[0].gap_s_sigma"},
                                  {"\"accel_offset_g\": [", "accel_offset_g[0]"},
                                  {"\"accel_scale\": [", "accel_scale[0]"}}) {
    text = calibrationToJson(richCalibration());
    const std::size_t begin = text.find(key);
    ASSERT_NE(begin, std::string::npos) << key;
    const std::size_t number = begin + std::string(key).size();
    text.replace(number, text.find_first_of(",]\n", number) - number, "-1e999");
    EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(text, "c.json"); }),
                saysAll(std::string(path) + ": expected", "-1e999"));
  }
}

TEST(CalibrationJson, IsRefusedWhereverItIsCutOff) {
  const std::string text = calibrationToJson(richCalibration());
  const std::size_t end = text.find_last_of('}');
  for (std::size_t size = 0; size <= end; size += 7) {
    EXPECT_THAT(messageOf<FormatError>([&] { parseCalibrationJson(std::string_view(text).substr(0, size), "c.json"); }),
                saysAll("c.json: "))
        << "cut after " << size << " bytes";
  }
}

TEST(CalibrationJson, RefusesOrTakesAnyValueInAnyPlace) {
  const std::size_t count = test::forEachMutation(richJson(), [](const std::string& text, const std::string& what) {
    try {
      const std::string again = calibrationToJson(*parseCalibrationJson(text, "c.json"));
      EXPECT_NO_THROW(parseCalibrationJson(again, "c.json")) << what;
    } catch (const FormatError& error) {
      EXPECT_THAT(error.what(), saysAll("c.json: ")) << what;
    }
  });
  EXPECT_GT(count, 1000U);
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

TEST(CalibrationJson, NamesAFileThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf<StorageError>([&] { readCalibrationJson(folder.path() / "none.calibration.json"); }),
              saysAll("none.calibration.json", "No such file"));
}

}  // namespace
}  // namespace hexoderm
