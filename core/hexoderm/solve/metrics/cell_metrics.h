#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// Figures of each cell of a reconstruction, one number each, for colours and tables. Every vector has one entry per
/// cell, in order of patch and ID. Metres and radians.
struct CellMetrics {
  std::vector<CellId> cells;
  std::vector<std::size_t> patch;  ///< index into Reconstruction::patches
  /// The worst of the used links at the cell: smallest class, largest residual, largest predicted deviation. Absent
  /// without a used link, and for figures that were not computed (imported files, links that no pose measured).
  std::vector<std::optional<EdgeQuality>> quality;
  std::vector<std::optional<double>> residual_rad;
  std::vector<std::optional<double>> sigma_rad;
  /// Of the used link at the cell that bends (twists, is turned) most. The sign of a bend and of a twist is that of the
  /// link; that of a yaw depends on the end that one looks from, so that it is left out.
  std::vector<std::optional<double>> bend_rad;
  std::vector<std::optional<double>> twist_rad;
  std::vector<std::optional<double>> yaw_rad;
  /// See uncertaintyOf().
  std::vector<std::optional<double>> position_95_m;
  std::vector<std::optional<double>> orientation_95_rad;
  /// See shapeUncertaintyOf().
  std::vector<std::optional<double>> shape_position_95_m;
  std::vector<std::optional<double>> shape_orientation_95_rad;
  /// From the origin from centre to centre along the shortest path; absent where that is not known.
  std::vector<std::optional<double>> path_length_m;
  /// Names of the body parts in ascending order, the empty one left out; then the index of each cell's.
  std::vector<std::string> body_parts;
  std::vector<std::optional<std::size_t>> body_part;
};

/// O(n log n) in cells and links.
CellMetrics makeCellMetrics(const Reconstruction& reconstruction);

}  // namespace hexoderm
