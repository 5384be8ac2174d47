#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// What a session has decided about places on the robot, for the patches as they were solved: named by the patches'
/// present origin cells, and in their frames. A new pose may give a patch another origin cell; the place then stays
/// that of the old one, x_l = T_l_old (T_new_old)^-1 x_new, and the covariance is moved with it, without the
/// uncertainty of T_new_old. Placements of cells that no patch holds are left out; of several of one patch, the first
/// counts. Ascending by origin cell.
std::vector<PatchPlacement> placementsOf(const std::vector<PatchReconstruction>& patches,
                                         const std::vector<PatchPlacement>& of_session);

/// The result with the robot and the placements of the session as they are now: nothing else of it depends on them.
std::shared_ptr<const Reconstruction> withPlacements(const Reconstruction& result, const Session& session);

/// Null if nothing was decided about the patch.
const PatchPlacement* placementOf(const Reconstruction& result, const PatchReconstruction& patch);

/// The patches whose places were chosen; what exporters take.
std::vector<PatchOnLink> placedPatches(const Reconstruction& result);

}  // namespace hexoderm
