#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/base/message.h"
#include "hexoderm/robots/robot_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hexoderm {

/// Free joints of the robot that the angles don't name, in the order of RobotModel::joints().
std::vector<std::string> missingJoints(const RobotModel& robot, const JointAngles& angles);

/// One sentence where a position (rad, prismatic: m) is outside the joint's limits by more than 2 degrees or 5 mm,
/// which calibrations of joints excuse.
std::optional<Message> beyondLimits(const RobotJoint& joint, double position);

/// How far a joint was outside its limits.
struct BeyondLimits {
  std::string joint;
  std::size_t index = 0;  ///< among the angles that were looked at
  double position = 0;    ///< rad or m: the one farthest outside
  JointLimits limits;
  Message message;
};

/// What makes joint angles doubtful. They are used as they are all the same.
struct JointDoubts {
  /// One for each joint that is outside its limits, as beyondLimits() has it.
  std::vector<BeyondLimits> beyond_limits;
  /// Said where the angles make sense only as degrees: read as rad, most joints that turn are outside their limits by
  /// more than their whole range (without limits, by more than six turns), and as degrees none is outside.
  std::optional<Message> probably_degrees;
  [[nodiscard]] bool empty() const { return beyond_limits.empty() && !probably_degrees; }  ///< there is no doubt
};

/// Looks at the angles of several poses together. Joints that the robot does not have are ignored.
JointDoubts doubtsOf(const RobotModel& robot, std::span<const JointAngles> angles);

}  // namespace hexoderm
