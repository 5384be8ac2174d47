#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include "hexoderm/solve/tree/gravity_table.h"

#include <vector>

namespace hexoderm {

/// The table of poses of a reconstruction whose patches are in place: noise, how new each direction is, residuals.
std::vector<PoseSummary> summarisePoses(const SessionSnapshot& snapshot, const GravityTable& table,
                                        const Reconstruction& reconstruction);

/// Adds findings about the poses as a whole: there are none, all lie on a single line of gravity, some repeat others.
/// Needs the patches and the table of poses to be in place.
void judgePoses(const Reconstruction& reconstruction, std::vector<Finding>& findings);

}  // namespace hexoderm
