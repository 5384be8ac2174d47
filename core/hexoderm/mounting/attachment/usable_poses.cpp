#include "hexoderm/mounting/attachment/usable_poses.h"

#include <algorithm>
#include <string>

namespace hexoderm {
namespace {

bool turnsLinks(const RobotJoint& joint) { return joint.isFree() && joint.turns(); }

}  // namespace

UsablePoses usablePoses(const std::vector<PoseId>& seen, const RobotModel& robot,
                        const std::map<PoseId, JointAngles>& angles) {
  const std::vector<RobotJoint>& joints = robot.joints();
  const auto names = [&](PoseId pose, std::size_t joint) {
    return angles.at(pose).positions.contains(joints[joint].name);
  };
  UsablePoses usable;
  std::vector<PoseId> with_angles;
  std::vector<PoseId> without;
  for (const PoseId pose : seen) {
    const auto found = angles.find(pose);
    const bool has = found != angles.end() && !found->second.positions.empty();
    (has ? with_angles : without).push_back(pose);
  }
  if (!without.empty() && !with_angles.empty()) {
    usable.findings.push_back(
        message("No joint angles are known of these poses, which are not compared: {}.", without));
  }
  std::vector<std::string> unknown;
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (!turnsLinks(joints[joint])) continue;
    const auto named = std::ranges::count_if(with_angles, [&](PoseId pose) { return names(pose, joint); });
    if (2 * static_cast<std::size_t>(named) >= with_angles.size()) continue;
    usable.unknown_joints.insert(joint);
    unknown.push_back(joints[joint].name);
  }
  if (!with_angles.empty() && !unknown.empty()) {
    usable.findings.push_back(
        message("The angles of these joints are not known, and links beyond them are not compared: {}.", unknown));
  }
  for (const PoseId pose : with_angles) {
    std::vector<std::string> missing;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      if (turnsLinks(joints[joint]) && !usable.unknown_joints.contains(joint) && !names(pose, joint)) {
        missing.push_back(joints[joint].name);
      }
    }
    if (missing.empty()) {
      usable.poses.push_back(pose);
    } else {
      usable.findings.push_back(
          message("Pose {} is not compared, because it lacks the angles of these joints: {}.", pose, missing));
    }
  }
  return usable;
}

}  // namespace hexoderm
