#pragma once

#include "hexoderm/solve/estimate/patch_solver.h"

#include <span>
#include <vector>

namespace hexoderm {

/// The patches of a result, each with its cells, sensors, gravity, gap share and covariances, from the joint estimate
/// where there is one and from the tree elsewhere, and with every link of the skin in the patch of its source.
///
/// `patches`: all of the skin, in the graph's order. `weights`: per link, as the paths were found with.
std::vector<PatchReconstruction> describePatches(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                                 std::span<const double> weights);

/// Of these what is known as soon as the cells are placed, and takes no covariance: cells, sensors, the mean direction
/// of gravity, and links as the readings of their two cells show them.
std::vector<PatchReconstruction> describePlacements(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                                    std::span<const double> weights);

}  // namespace hexoderm
