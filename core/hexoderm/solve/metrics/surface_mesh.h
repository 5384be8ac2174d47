#pragma once

#include "hexoderm/solve/checks/evaluation.h"

#include <vector>

namespace hexoderm {

/// The part of a fitted surface that lies under the cells, for drawing, in the patch frame, metres.
struct SurfaceMesh {
  /// A grid of rows x columns points, row by row.
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;  ///< unit, to the side where distances are positive
  /// For each cell of the evaluation, in its order: its centre, and the nearest point of the surface.
  std::vector<Eigen::Vector3d> centers;
  std::vector<Eigen::Vector3d> feet;
};

/// `margin_m`: how far the grid goes beyond the outermost centres. `patch` is the one that was evaluated; cells that it
/// does not have any more are left out (their distances too then belong to another result). Empty if none is left.
SurfaceMesh meshSurface(const SurfaceEvaluation& evaluation, const PatchReconstruction& patch, double margin_m);

}  // namespace hexoderm
