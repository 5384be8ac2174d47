#pragma once

#include "hexoderm/graph/cell_model.h"
#include "hexoderm/reconstruction/result/solver_options.h"
#include "hexoderm/util/finding.h"

#include <vector>

namespace hexoderm {

/// A finding for each of bend, twist and yaw that no skin link has: beyond the options' limit by more than three
/// predicted standard deviations of the link's rotation (`sigma_rad`; 0 where the rotation is taken as exact).
///
/// `angles` are the parts of one rotation vector (LinkAngles). They are judged, and given in the text, as a yaw about z
/// followed by a tilt with its parts twist and bend, which is the same for small angles and tells large ones apart.
/// Exact for ports in the cell's plane.
std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target,
                                     const SolverOptions& options, double sigma_rad);

}  // namespace hexoderm
