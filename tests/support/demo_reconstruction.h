#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/util/units.h"

#include <array>
#include <cmath>
#include <memory>

namespace hexoderm {

/// Properties of a hand-made skin for the tests of views; it comes from no solver and no simulator.
struct DemoOptions {
  double radius_m = 0.0501;     ///< radius of the cylinder (axis along y of the origin cell)
  std::uint32_t arm_cells = 4;  ///< cells in each of the four arms; 4 makes an X17, 0 a single cell
  std::uint32_t first_id = 1;   ///< the origin; the arms are numbered in turns, as the X17's cells are
  std::array<EdgeQuality, 4> arm_quality = {EdgeQuality::Fully, EdgeQuality::Fully, EdgeQuality::Fully,
                                            EdgeQuality::Fully};
};

/// One X-shaped patch, bent around a cylinder: a chain of linkTransforms along each of the four ports.
inline PatchReconstruction demoPatch(const CellModel& model, const DemoOptions& options = {}) {
  PatchReconstruction patch;
  patch.origin = CellId(options.first_id);
  patch.gravity = {{PoseId(1), Eigen::Vector3d(0.1, 0.9, 0.3).normalized(), 0.01},
                   {PoseId(2), Eigen::Vector3d(0.9, -0.2, 0.3).normalized(), 0.01}};
  patch.cells.resize(1 + 4 * options.arm_cells);
  patch.cells[0].cell = patch.origin;
  patch.cells[0].path = {patch.origin};
  for (std::uint32_t arm = 0; arm < 4; ++arm) {
    const Port& out = model.port(PortNumber(arm + 1));
    const Port& in = model.port(PortNumber(4 - arm));  // opposite: 1-4, 2-3
    const double bend_rad =
        std::copysign(2 * std::atan(std::abs(out.vector_m.x()) / options.radius_m), out.vector_m.x());
    const Eigen::Matrix3d R_c_n = expSO3(bend_rad * Eigen::Vector3d::UnitY());
    std::size_t source = 0;
    for (std::uint32_t step = 0; step < options.arm_cells; ++step) {
      const std::size_t target = 1 + arm + 4 * step;
      CellPlacement& cell = patch.cells[target];
      cell.cell = CellId(options.first_id + static_cast<std::uint32_t>(target));
      cell.T_o_u = patch.cells[source].T_o_u * linkTransform(R_c_n, out, in);
      cell.path = patch.cells[source].path;
      cell.path.push_back(cell.cell);
      LinkEstimate link;
      link.source = {patch.cells[source].cell, out.number};
      link.target = {cell.cell, in.number};
      link.R_c_n = R_c_n;
      link.quality = options.arm_quality.at(arm);
      link.singular_values = {1.0, 0.9, 0.1};
      link.weight = 1;
      link.residual_rad = 0.4 * kDegree;
      link.sigma_rad = (1.0 + step) * kDegree;
      link.bend_rad = std::abs(bend_rad);
      link.used = true;
      link.in_tree = true;
      patch.links.push_back(link);
      source = target;
    }
  }
  return patch;
}

/// A skin of the given patches, numbered in order, with two poses.
inline Reconstruction demoReconstruction(std::vector<PatchReconstruction> patches) {
  Reconstruction reconstruction;
  reconstruction.revision = 1;
  reconstruction.model = std::make_shared<const CellModel>(builtInCellModel("hex-bma150"));
  reconstruction.patches = std::move(patches);
  for (std::size_t k = 0; k < reconstruction.patches.size(); ++k) {
    reconstruction.patches[k].id = PatchId(static_cast<std::uint32_t>(k));
  }
  reconstruction.poses = {
      {PoseId(1), Message::verbatim("standing"), true, reconstruction.cellCount(), 0.0014, std::nullopt, 0.007},
      {PoseId(2), Message::verbatim("on its side"), true, reconstruction.cellCount(), 0.0022, 1.5, 0.009}};
  reconstruction.assessment = {VerdictLevel::Usable, Message::verbatim("Made by hand for a test."), 0.002, 0.08,
                            Message::verbatim("Take a third pose.")};
  return reconstruction;
}

/// The X17 on a cylinder, all links fully defined unless told otherwise.
inline Reconstruction demoReconstruction(const DemoOptions& options = {}) {
  return demoReconstruction({demoPatch(builtInCellModel("hex-bma150"), options)});
}

/// A flat sheet of columns x rows cells, every port towards a neighbour linked.
inline Reconstruction sheetReconstruction(std::uint32_t columns, std::uint32_t rows) {
  const CellModel model = builtInCellModel("hex-bma150");
  const Port& right_up = model.port(PortNumber(1));
  const Port& right_down = model.port(PortNumber(2));
  PatchReconstruction patch;
  patch.origin = CellId(1);
  patch.gravity = {{PoseId(1), Eigen::Vector3d::UnitZ(), 0.01}};
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t id = 1 + row * columns + column;
      CellPlacement cell;
      cell.cell = CellId(id);
      cell.T_o_u.t = 2.0 * column * right_up.vector_m + 2.0 * row * right_down.vector_m;
      patch.cells.push_back(cell);
      LinkEstimate link;
      link.quality = EdgeQuality::Fully;
      link.used = true;
      if (column + 1 < columns) {
        link.source = {CellId(id), PortNumber(1)};
        link.target = {CellId(id + 1), PortNumber(4)};
        patch.links.push_back(link);
      }
      if (row + 1 < rows) {
        link.source = {CellId(id), PortNumber(2)};
        link.target = {CellId(id + columns), PortNumber(3)};
        patch.links.push_back(link);
      }
    }
  }
  return demoReconstruction({std::move(patch)});
}

}  // namespace hexoderm
