#pragma once

#include "hexoderm/io/session_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/paths.h"
#include "tests/support/session_matchers.h"

#include <filesystem>

namespace hexoderm::test {

inline Matrix6d someCovariance() {
  Matrix6d A;
  for (int k = 0; k < 36; ++k) A(k / 6, k % 6) = 1e-3 / (k + 1.7);
  return A * A.transpose();
}

/// A solved skin in which every key that a calibration can have occurs.
inline Reconstruction richCalibration() {
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
  result.placements = {placementWithEverything(patch.origin)};
  return result;
}

}  // namespace hexoderm::test
