#pragma once

#include "hexoderm/reconstruction/patch/patch_solver.h"

#include <span>
#include <vector>

namespace hexoderm {

/// Takes out of the skin what the attitudes of a solved patch show to be no part of it (AttitudeSearch): links are
/// muted, and the readings of cells that are mounted otherwise, or whose readings are each other's, are dropped. What
/// is only suspicious, because there are too few poses, is named and stays. A tree's readings are freed from what a
/// hand that turned the part added to them. True if anything was changed: then edges and patches have to be estimated
/// again.
[[nodiscard]] bool isolateAttitudes(SkinLinks& skin, std::span<const PatchSolver> patches,
                                    std::vector<Finding>& findings);

}  // namespace hexoderm
