#pragma once

#include "hexoderm/skin/shortest_paths.h"

#include "hexoderm/solve/tree/edge_rotation.h"
#include "hexoderm/solve/tree/gap_share.h"

#include <vector>

namespace hexoderm {

/// One cell's placement along the tree and its predicted error.
struct TreePlacement {
  SE3 T_o_u;
  Matrix6d covariance = Matrix6d::Zero();  ///< see CellPlacement::cov_t_r
};

/// Orientations and positions along the shortest-path tree, eqs. (3), (5), (6), with first-order covariances: every
/// cell has an attitude error of its own (offset, gains, noise), so the orientation error of a cell is the difference
/// of its own and the origin's; what the poses don't show is the elastomer's to vary, link by link, and adds up; link
/// points meet within the model's link_sigma_m. Links are taken as pivots; by how much a bent mould opens them is an
/// error of all links together, of which `gap` is the prior.
///
/// `edges`: per link of the graph. `attitude_covariance`: per cell of the patch, in the cell frame. Result: per cell of
/// the patch; both at GraphCell::place.
std::vector<TreePlacement> placeAlongTree(const SkinGraph& graph, const CellModel& model, const ShortestPaths& paths,
                                          const std::vector<EdgeRotation>& edges,
                                          const std::vector<Eigen::Matrix3d>& attitude_covariance, const GapShare& gap);

}  // namespace hexoderm
