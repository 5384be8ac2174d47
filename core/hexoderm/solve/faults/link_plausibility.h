#pragma once

#include "hexoderm/base/finding.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/result/solver_options.h"

#include <vector>

namespace hexoderm {

/// A finding for each of bend, twist and yaw that no skin link has: beyond six deviations of the cell model's
/// elastomer and of the link's own rotation (`sigma_rad`: about the link's direction, across it in the surface, and
/// about z; 0 where the rotation is taken as exact), and in any case beyond the options' limit by more than three
/// deviations of the rotation.
///
/// `angles` are the parts of one rotation vector (LinkAngles). They are judged, and given in the text, as a yaw about z
/// followed by a tilt with its parts twist and bend, which is the same for small angles and tells large ones apart. z
/// stands for the third of the linkAxes().
std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target, const CellModel& model,
                                     const SolverOptions& options, const LinkAngles& sigma_rad);

/// The finding for a link with an angle (`code`: ImplausibleBend, ImplausibleTwist or ImplausibleYaw) that the links
/// around it don't let expect.
Finding describeUnexpectedAngle(FindingCode code, LinkEnd source, LinkEnd target, double angle_rad, double lowest_rad,
                                double highest_rad);

}  // namespace hexoderm
