#pragma once

#include "hexoderm/solve/metrics/distribution.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <optional>
#include <vector>

namespace hexoderm {

// The figures that a reviewer of a reconstruction looks at first, gathered from all parts of it.

/// A row of the table of cells.
struct CellSummary {
  PatchId patch;
  CellId cell;
  bool origin = false;
  PlacedBy placed_by = PlacedBy::Samples;
  SE3 T_o_u;
  std::optional<Uncertainty95> stated;  ///< relative to the origin; absent where no covariance is
  std::optional<Uncertainty95> shape;   ///< relative to the patch as a whole; absent where it is not stated
  /// The largest residual of its links that are in use; absent where none was measured.
  std::optional<double> worst_residual_rad;
  std::optional<Eigen::Vector3d> offset_g;
  /// Scale less 1 of the axis whose scale is furthest from 1.
  std::optional<double> worst_scale_error;
};
/// All cells, patch by patch, ascending.
std::vector<CellSummary> summariseCells(const Reconstruction& reconstruction);

/// Residuals of the links in one pose: five numbers for a box plot, quantiles interpolated linearly. Radians.
struct PoseResiduals {
  std::size_t index = 0;  ///< into Reconstruction::poses
  PoseId pose;
  std::size_t count = 0;
  double least = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double largest = 0;
};
/// A link by its residual.
struct RankedLink {
  std::size_t patch = 0;  ///< into Reconstruction::patches
  std::size_t link = 0;   ///< into its links
  double residual_rad = 0;
  std::optional<double> sigma_rad;
};
/// The residuals of all links.
struct ResidualSummary {
  std::vector<PoseResiduals> poses;  ///< those that any link has a residual in
  std::vector<RankedLink> links;     ///< measured ones, largest residual first
  /// Number of links whose residual is so many times their predicted deviation: from 0 on, equally wide; empty if
  /// nothing is predicted.
  std::vector<ValueBin> ratios;
};
ResidualSummary summariseResiduals(const Reconstruction& reconstruction);  ///< the residuals of a reconstruction

/// "offset -25.3, -10.1, -45.0 +- 2.1 mg, scale 1.003 +- 0.001 (1 sigma)"; of the offset the sigma of the worst axis.
Message lotText(const LotEstimate& lot);

}  // namespace hexoderm
