#include "hexoderm/session/simulated_session.h"

namespace hexoderm {

Session beginSimulatedSession(const SimulatedSkin& skin) {
  Session session(skin.model(), skin.neighbors(), {skin.description(), {}, {}});
  session.setTruth(skin.groundTruth());
  return session;
}

Session simulateSession(SimulatedSkin& skin, std::size_t pose_count, std::size_t frame_count) {
  Session session = beginSimulatedSession(skin);
  for (const Eigen::Vector3d& up : skin.upDirections(pose_count)) {
    const PoseId id = session.nextPoseId();
    const Message label = id.value() == 1   ? message("standing")
                          : id.value() == 2 ? message("on its side")
                                            : message("pose {}", id);
    session.addPose(
        {std::make_shared<const PoseCapture>(averageFrames(skin.record(up, frame_count), id, label)), false});
  }
  return session;
}

}  // namespace hexoderm
