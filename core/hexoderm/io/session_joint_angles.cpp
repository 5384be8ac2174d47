#include "hexoderm/io/session_joint_angles.h"

#include <algorithm>

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

Message whyNoPoseHasAngles(const Session& session, const JointAnglesTable& table) {
  if (session.poses().empty() || table.rows.empty() || !jointAnglesFor(session, table).edits.empty()) return {};
  const auto number = [](const SessionPose& pose) { return pose.capture->id; };
  const auto [first, last] = std::ranges::minmax_element(session.poses(), {}, number);
  if (table.rows.front().pose) {
    const auto [from, to] = std::ranges::minmax_element(table.rows, {}, [](const auto& row) { return *row.pose; });
    return message("has angles of the poses {} to {}, but the session has the poses {} to {}", *from->pose, *to->pose,
                   number(*first), number(*last));
  }
  std::vector<double> taken_s;
  for (const SessionPose& pose : session.poses()) {
    if (pose.capture->taken_at_ms) taken_s.push_back(1e-3 * static_cast<double>(*pose.capture->taken_at_ms));
  }
  if (taken_s.empty()) {
    return message("has times, but the poses of the session don't say when they were taken: expected a column pose");
  }
  const auto [earliest, latest] = std::ranges::minmax(taken_s);
  return message(
      "no time is within a second of a pose: the file goes from {} to {}, and the poses were taken from {} to {} (s "
      "since 1970, UTC)",
      Number{*table.rows.front().time_s, 1}, Number{*table.rows.back().time_s, 1}, Number{earliest, 1},
      Number{latest, 1});
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
