#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/util/units.h"

#include <cmath>
#include <cstdint>
#include <memory>

namespace hexoderm {

/// A sheet laid directly around nine tenths of a cylinder, cells in staggered columns along its axis, every port
/// towards a neighbour linked: what large skins look like, for tests and benchmarks of drawing. From no solver and no
/// simulator; links don't fit exactly.
inline Reconstruction cylinderSheet(std::uint32_t columns, std::uint32_t rows) {
  Reconstruction reconstruction;
  reconstruction.revision = 1;
  auto model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  model->interface_id = CellId(1U << 30);
  reconstruction.model = model;
  const Eigen::Vector3d step = 2 * model->port(PortNumber(1)).vector_m;  // to the right and up
  const double radius_m = step.x() * columns / (0.9 * 2 * kPi);
  PatchReconstruction patch;
  patch.id = PatchId(0);
  patch.origin = CellId(columns / 2 * rows + rows / 2 + 1);
  patch.gravity = {{PoseId(1), Eigen::Vector3d(0, 1, 0), 0.01}};
  patch.cells.reserve(static_cast<std::size_t>(columns) * rows);
  const auto idOf = [rows](std::uint32_t column, std::uint32_t row) { return CellId(1 + column * rows + row); };
  for (std::uint32_t column = 0; column < columns; ++column) {
    const double angle = step.x() * (column - columns / 2.0) / radius_m;
    const Eigen::Matrix3d R = expSO3(angle * Eigen::Vector3d::UnitY());
    for (std::uint32_t row = 0; row < rows; ++row) {
      CellPlacement cell;
      cell.cell = idOf(column, row);
      const double along_m = step.y() * (2.0 * (row - rows / 2.0) + column % 2);
      cell.T_o_u = {R, R * Eigen::Vector3d(0, 0, radius_m) + Eigen::Vector3d(0, along_m, -radius_m)};
      const double sigma_m = 0.0001 + 0.002 * std::abs(angle) / kPi;
      const double sigma_rad = 0.002 + 0.02 * row / rows;
      cell.cov_t_r = Matrix6d::Zero();
      cell.cov_t_r->diagonal() << Eigen::Vector3d::Constant(sigma_m * sigma_m),
          Eigen::Vector3d::Constant(sigma_rad * sigma_rad);
      patch.cells.push_back(std::move(cell));
      if (column + 1 == columns) continue;
      const std::uint32_t up = row + column % 2;  // in the next column
      const auto link = [&](std::uint32_t port, std::uint32_t target_row) {
        LinkEstimate entry;
        entry.source = {idOf(column, row), PortNumber(port)};
        entry.target = {idOf(column + 1, target_row), PortNumber(5 - port)};
        entry.quality = static_cast<EdgeQuality>((column / 8 + row / 6) % 4);
        entry.residual_rad = 0.3 * kDegree;
        entry.sigma_rad = (0.5 + 0.1 * (column % 40)) * kDegree;
        entry.used = true;
        patch.links.push_back(std::move(entry));
      };
      if (up < rows) link(1, up);
      if (up > 0) link(2, up - 1);
    }
  }
  reconstruction.patches.push_back(std::move(patch));
  return reconstruction;
}

}  // namespace hexoderm
