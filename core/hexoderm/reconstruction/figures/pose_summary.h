#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "hexoderm/session/session.h"

#include "hexoderm/reconstruction/links/gravity_table.h"

#include <vector>

namespace hexoderm {

/// The table of poses of a reconstruction whose patches are in place: noise, how new each direction is, residuals.
std::vector<PoseSummary> summarisePoses(const SessionSnapshot& snapshot, const GravityTable& table,
                                        const std::vector<PatchReconstruction>& patches);

/// Adds findings about the poses as a whole: none at all, a single line of gravity, repetitions.
void judgePoses(const std::vector<PoseSummary>& poses, const std::vector<PatchReconstruction>& patches,
                std::vector<Finding>& findings);

}  // namespace hexoderm
