#pragma once

// What is stated of joints and base once all placed patches were fitted together.

#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/attachment/robot_fit.h"

#include <vector>

namespace hexoderm {

/// `patches`: those that were fitted, in the order of the fit; `poses`: those that were compared, by place.
RobotEstimate estimateOf(const RobotFit& fit, std::vector<PatchId> patches, const std::vector<PoseId>& poses,
                         const RobotModel& robot, const LinksOptions& options);

/// Zeros and a tilt that are worth saying, and a fit that is a bad one; a sentence each.
std::vector<Message> findingsOf(const RobotEstimate& estimate, const LinksOptions& options);

}  // namespace hexoderm
