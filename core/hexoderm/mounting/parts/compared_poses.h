#pragma once

// The poses in which patches are compared.

#include "hexoderm/mounting/parts/gravity_seen.h"

#include <vector>

namespace hexoderm {

/// The poses in which any of the patches saw gravity, ascending.
std::vector<PoseId> posesOf(const std::vector<const PatchReconstruction*>& patches);

/// As many of `all` as are allowed, each the one that differs most from those taken before, by what the patch sees that
/// tells them apart best; ascending.
std::vector<PoseId> differentPoses(const std::vector<const PatchReconstruction*>& patches,
                                   const std::vector<PoseId>& all, std::size_t most);

/// gravityOf() in those of these poses (ascending) that the patch saw.
GravitySeen gravityIn(const PatchReconstruction& patch, const std::vector<PoseId>& poses, double lever_m,
                      double tremor_share = 1);

}  // namespace hexoderm
