#include "hexoderm/robots/joint_check.h"

#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kAngleSlack = 2 * kDegree;
constexpr double kLengthSlack_m = 0.005;
/// A joint without limits turns on and on, but a controller reports it within a few turns.
constexpr double kMaxTurns_rad = 4 * kPi;

double slackOf(const RobotJoint& joint) { return joint.type == JointType::Prismatic ? kLengthSlack_m : kAngleSlack; }

/// How far a position is outside the limits: 0 inside.
double excess(const JointLimits& limits, double position) {
  return std::max({0.0, limits.lower - position, position - limits.upper});
}

JointLimits limitsOrTurns(const RobotJoint& joint) {
  return joint.limits.value_or(JointLimits{-kMaxTurns_rad, kMaxTurns_rad});
}

Message beyondLimitsMessage(const RobotJoint& joint, double position, const JointLimits& limits) {
  if (joint.type == JointType::Prismatic) {
    return message("Joint {} is at {}; its limits are {} and {}.", joint.name, Millimetres{position, 0},
                   Millimetres{limits.lower, 0}, Millimetres{limits.upper, 0});
  }
  return message("Joint {} is at {}; its limits are {} and {}.", joint.name, Degrees{position}, Degrees{limits.lower},
                 Degrees{limits.upper});
}

/// The joints that turn, of which `angles` hold something other than 0.
struct TurningJoints {
  std::size_t moved = 0;
  std::size_t outside = 0;             ///< of them, by more than their whole range
  std::size_t outside_as_degrees = 0;  ///< if all positions were degrees
  std::string example;                 ///< the first joint that was outside
  double example_position = 0;
};

TurningJoints turningJoints(const RobotModel& robot, std::span<const JointAngles> angles) {
  TurningJoints result;
  for (const RobotJoint& joint : robot.joints()) {
    if (!joint.isFree() || joint.type == JointType::Prismatic) continue;
    const JointLimits limits = limitsOrTurns(joint);
    double farthest = 0;
    double outside = 0;
    double outside_as_degrees = 0;
    for (const JointAngles& pose : angles) {
      const auto found = pose.positions.find(joint.name);
      if (found == pose.positions.end()) continue;
      if (std::abs(found->second) > std::abs(farthest)) farthest = found->second;
      outside = std::max(outside, excess(limits, found->second));
      outside_as_degrees = std::max(outside_as_degrees, excess(limits, kDegree * found->second));
    }
    if (farthest == 0) continue;
    ++result.moved;
    if (outside > limits.upper - limits.lower + kAngleSlack) {
      if (result.outside == 0) {
        result.example = joint.name;
        result.example_position = farthest;
      }
      ++result.outside;
    }
    if (outside_as_degrees > kAngleSlack) ++result.outside_as_degrees;
  }
  return result;
}

}  // namespace

std::vector<std::string> missingJoints(const RobotModel& robot, const JointAngles& angles) {
  std::vector<std::string> missing;
  for (const RobotJoint& joint : robot.joints()) {
    if (joint.isFree() && !angles.positions.contains(joint.name)) missing.push_back(joint.name);
  }
  return missing;
}

std::optional<Message> beyondLimits(const RobotJoint& joint, double position) {
  if (!joint.limits || excess(*joint.limits, position) <= slackOf(joint)) return std::nullopt;
  return beyondLimitsMessage(joint, position, *joint.limits);
}

JointDoubts doubtsOf(const RobotModel& robot, std::span<const JointAngles> angles) {
  JointDoubts doubts;
  for (const RobotJoint& joint : robot.joints()) {
    if (!joint.limits) continue;
    BeyondLimits worst{joint.name, 0, 0, *joint.limits, {}};
    double worst_excess = slackOf(joint);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const auto found = angles[k].positions.find(joint.name);
      if (found == angles[k].positions.end() || excess(*joint.limits, found->second) <= worst_excess) continue;
      worst_excess = excess(*joint.limits, found->second);
      worst.index = k;
      worst.position = found->second;
    }
    if (worst_excess <= slackOf(joint)) continue;
    worst.message = beyondLimitsMessage(joint, worst.position, *joint.limits);
    doubts.beyond_limits.push_back(std::move(worst));
  }

  const TurningJoints as_degrees = turningJoints(robot, angles);
  if (2 * as_degrees.outside > as_degrees.moved && as_degrees.outside_as_degrees == 0) {
    doubts.probably_degrees = message(
        "These joint angles are probably degrees that were read as rad: {} of {} joints that turn are far beyond "
        "their limits, and as degrees none is. Joint {}, for example, has {}.",
        as_degrees.outside, as_degrees.moved, as_degrees.example, Number{as_degrees.example_position, 1});
  }
  return doubts;
}

}  // namespace hexoderm
