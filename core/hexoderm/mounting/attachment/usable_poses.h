#pragma once

// The poses whose joint angles are known.

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/base/message.h"
#include "hexoderm/robots/robot_model.h"

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace hexoderm {

/// The poses that can be compared, and what joints and poses have to be left out.
struct UsablePoses {
  std::vector<PoseId> poses;             ///< ascending
  std::set<std::size_t> unknown_joints;  ///< links beyond them can't be compared
  std::vector<Message> findings;         ///< what is left out, a sentence each
};

/// Joints that fewer than half of the poses name are not known; poses that lack one of the others are left out.
UsablePoses usablePoses(const std::vector<PoseId>& seen, const RobotModel& robot,
                        const std::map<PoseId, JointAngles>& angles);

}  // namespace hexoderm
