#include "hexoderm/session/session_joint_angles.h"

namespace hexoderm {

JointAnglesForSession jointAnglesFor(const Session& session, const JointAnglesTable& table) {
  JointAnglesForSession result;
  for (std::size_t k = 0; k < session.poses().size(); ++k) {
    const PoseCapture& capture = *session.poses()[k].capture;
    if (auto angles = table.of(capture.id, capture.taken_at_ms)) {
      result.edits.push_back({k, std::move(*angles)});
    } else {
      result.without_angles.push_back(capture.id);
    }
  }
  return result;
}

JointAnglesTable jointAnglesOf(const Session& session) {
  JointAnglesTable table;
  for (const SessionPose& pose : session.poses()) {
    if (pose.joint_angles.positions.empty()) continue;
    table.rows.push_back({pose.capture->id, std::nullopt, pose.joint_angles});
  }
  for (const JointAnglesRow& other : std::vector(table.rows)) {
    for (JointAnglesRow& row : table.rows) {
      std::erase_if(row.angles.positions,
                    [&](const auto& joint) { return !other.angles.positions.contains(joint.first); });
    }
  }
  return table;
}

}  // namespace hexoderm
