#include "hexoderm/mounting/attachment/link_gravity.h"

#include "hexoderm/base/se3.h"

#include <algorithm>

namespace hexoderm {
namespace {

bool anyNames(std::span<const JointAngles> angles, const std::string& joint) {
  return std::ranges::any_of(angles, [&](const JointAngles& pose) { return pose.positions.contains(joint); });
}

}  // namespace

LinkGravity::LinkGravity(const RobotModel& robot, std::span<const JointAngles> angles, const Eigen::Vector3d& up_w,
                         std::span<const double> zeros)
    : robot_(robot), up_w_(up_w) {
  const std::vector<RobotJoint>& joints = robot.joints();
  for (JointAngles pose : angles) {
    for (std::size_t joint = 0; joint < zeros.size(); ++joint) {
      if (zeros[joint] != 0) pose.positions[joints[joint].name] += zeros[joint];
    }
    T_w_l_.push_back(robot.forward(pose));
  }
  for (std::size_t link = 0; link < robot.links().size(); ++link) {
    std::vector<Step>& steps = steps_to_.emplace_back();
    std::vector<std::size_t>& followed = joints_to_.emplace_back();
    for (auto joint = robot.links()[link].joint; joint; joint = robot.links()[joints[*joint].parent].joint) {
      if (!joints[*joint].turns()) continue;
      Step step{*joint, *joint, 1};
      bool is_known_itself = false;
      while (joints[step.follows].mimic && !is_known_itself) {
        is_known_itself = anyNames(angles, joints[step.follows].name);
        step.multiplier *= joints[step.follows].mimic->multiplier;
        step.follows = joints[step.follows].mimic->joint;
      }
      if (is_known_itself || !joints[step.follows].turns()) continue;
      steps.push_back(step);
      followed.push_back(step.follows);
    }
    std::ranges::sort(followed);
    followed.erase(std::unique(followed.begin(), followed.end()), followed.end());
  }
}

Eigen::Vector3d LinkGravity::byZero(std::size_t link, std::size_t pose, std::size_t joint) const {
  Eigen::Vector3d axis_w = Eigen::Vector3d::Zero();
  for (const Step& step : steps_to_[link]) {
    if (step.follows != joint) continue;
    const RobotJoint& turned = robot_.joints()[step.joint];
    axis_w += step.multiplier * (T_w_l_[pose][turned.child].R * turned.axis);
  }
  return T_w_l_[pose][link].R.transpose() * up_w_.cross(axis_w);
}

}  // namespace hexoderm
