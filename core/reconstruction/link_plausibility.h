#pragma once

#include "hexoderm/graph/cell_model.h"
#include "hexoderm/reconstruction/solver_options.h"
#include "hexoderm/util/finding.h"

#include <vector>

namespace hexoderm {

/// A finding for each of bend, twist and yaw that no skin link has: beyond the options' limit by more than three
/// predicted standard deviations of the link's rotation (`sigma_rad`; 0 where the rotation is taken as exact).
std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target,
                                     const SolverOptions& options, double sigma_rad);

}  // namespace hexoderm
