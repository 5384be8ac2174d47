#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <memory>

namespace hexoderm {

/// Text that every format has to escape: quote, comma, apostrophe, ampersand, angle brackets, backslash, umlaut.
inline constexpr const char* kAwkwardText = "left \"arm\", Bernd's <R&D> \\ größer";

/// A small result with something of everything, made by hand: patch 0 with cells 3, 7 (origin) and 12, patch 1 with
/// cell 20 alone; links 3:2-7:3 (fully), 7:2-12:3 (over), 7:1-12:4 (muted, one-sided) and 7:4-20:1 (muted, between the
/// patches); poses 1 (awkward label), 2 (link 3-7 has no residual in it) and 4 (disabled). Every cell but 20 has a
/// sensor off its centre; cell 12 has an awkward body part and no covariance, and is pitched by 90 degrees (gimbal
/// lock).
inline Reconstruction makeTestReconstruction() {
  Reconstruction result;
  auto model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  result.model = model;
  result.solver = "tree";
  result.source.text = Message::verbatim("made by hand");
  result.source.file = "hand \"made\".session.json";

  const auto cell = [](std::uint32_t id, const SE3& T_o_u) {
    CellPlacement placement;
    placement.cell = CellId(id);
    placement.T_o_u = T_o_u;
    placement.cov_t_r = Matrix6d::Zero();
    return placement;
  };
  const auto addSensor = [](CellPlacement& placement, const std::string& name, const std::string& type) {
    const SE3 T_u_s{expSO3({0.1, -0.2, 0.3}), {0.004, -0.002, -0.001}};
    placement.sensors.push_back({name, type, placement.T_o_u * T_u_s});
  };

  PatchReconstruction patch0;
  patch0.id = PatchId(0);
  patch0.origin = CellId(7);
  patch0.cells = {cell(3, {expSO3({0.2, -0.3, 0.1}), {-0.024, 0.0013, -0.0031}}), cell(7, {}),
                  cell(12, {rotationFromRpy({0.4, 1.5707963267948966, 0}), {0.0123456789012345, 0.007, -0.012}})};
  patch0.cells[0].path = {CellId(7), CellId(3)};
  patch0.cells[1].path = {CellId(7)};
  patch0.cells[2].path = {CellId(7), CellId(12)};
  patch0.cells[0].cov_t_r = 1e-6 * Matrix6d::Identity();
  patch0.cells[2].cov_t_r.reset();
  patch0.cells[2].placed_by = PlacedBy::Links;
  patch0.cells[2].body_part = kAwkwardText;
  addSensor(patch0.cells[0], "accelerometer", "accelerometer");
  addSensor(patch0.cells[1], "force \"1\"/größe", "force, normal");
  addSensor(patch0.cells[1], "force '1' größe", "force");
  addSensor(patch0.cells[2], "", "");
  patch0.gravity = {{PoseId(1), Eigen::Vector3d::UnitZ(), 0.01}, {PoseId(2), Eigen::Vector3d(0.6, 0, 0.8), 0.02}};

  const auto end = [](std::uint32_t id, std::uint32_t port) { return LinkEnd{CellId(id), PortNumber(port)}; };
  LinkEstimate fully;
  fully.source = end(3, 2);
  fully.target = end(7, 3);
  fully.R_c_n = patch0.cells[0].T_o_u.R.transpose();
  fully.quality = EdgeQuality::Fully;
  fully.singular_values = {1.5, 0.5000000000000001, 0};
  fully.weight = 1;
  fully.residual_rad = 0.01;
  fully.sigma_rad = 0.02;
  fully.bend_rad = -0.3;
  fully.twist_rad = 0.1;
  fully.yaw_rad = 1.0 / 3;
  fully.used = true;
  fully.in_tree = true;
  fully.pose_residual_rad = {0.011, std::nullopt, 0.5};
  LinkEstimate over = fully;
  over.source = end(7, 2);
  over.target = end(12, 3);
  over.quality = EdgeQuality::Over;
  over.pose_residual_rad = {0.0, 0.02, std::nullopt};
  LinkEstimate muted;
  muted.source = end(7, 1);
  muted.target = end(12, 4);
  muted.muted_by = FindingCode::OneSidedLink;
  LinkEstimate between = muted;
  between.source = end(7, 4);
  between.target = end(20, 1);
  between.muted_by = FindingCode::BodyPartBoundary;
  patch0.links = {fully, muted, over, between};

  PatchReconstruction patch1;
  patch1.id = PatchId(1);
  patch1.origin = CellId(20);
  patch1.cells = {cell(20, {})};
  patch1.cells[0].path = {CellId(20)};

  result.patches = {patch0, patch1};
  result.poses.resize(3);
  result.poses[0] = {PoseId(1), Message::verbatim("standing, \"arm\"\nhanging"), true, 4, 0.001, std::nullopt, 0.011};
  result.poses[1] = {PoseId(2), {}, true, 3, 0.0015, 0.6435011087932844, 0.02};
  result.poses[2] = {PoseId(4), Message::verbatim(" größer"), false, 4, 0.002, std::nullopt, std::nullopt};
  result.layout.cells = {{CellId(3), {-0.024, 0.001}, 0.1},
                         {CellId(7), {0, 0}, 0},
                         {CellId(12), {0.024, -0.001}, 0},
                         {CellId(20), {0.0931, 0}, 0}};
  result.assessment.level = VerdictLevel::Usable;
  return result;
}

/// The same skin without any cell, as from an empty session.
inline Reconstruction makeEmptyReconstruction() {
  Reconstruction result;
  result.model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  return result;
}

}  // namespace hexoderm
