#pragma once

// What is said of the links of patches, and why patches may fit none.

#include "hexoderm/base/message.h"
#include "hexoderm/mounting/attachment/link_fit.h"
#include "hexoderm/mounting/attachment/links.h"

#include <optional>
#include <vector>

namespace hexoderm {

/// Whether the operator chose a link that doesn't fit.
bool contradictsChoice(const PatchLinks& patch);

/// PatchLinks::why and ::what_would_tell, from all the rest of it.
void putIntoWords(PatchLinks& patch, const RobotModel& robot);

/// Of how many patches the link is known; needs one at least.
Message summaryOf(const std::vector<PatchLinks>& patches);

/// Patches and the robot that they were compared with.
struct ComparedRobot {
  const RobotModel& robot;
  std::vector<JointAngles> angles;  ///< of the compared poses
  std::vector<PoseId> poses;
  Eigen::Vector3d up_w;
  LinkTest test;
};

/// One mistake that would explain why these patches fit no link, the likeliest kinds first: angles
/// in another unit, a base that stands otherwise, angles of the next pose or the one before, those of a single pose, a
/// joint that counts the other way round, a joint whose zero is far off. In words; nullopt if none does, or if there
/// are too few poses to tell.
std::optional<Message> explain(const std::vector<const SeenByPatch*>& without_link, const ComparedRobot& compared);

}  // namespace hexoderm
