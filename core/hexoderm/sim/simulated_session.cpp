#include "hexoderm/sim/simulated_session.h"

#include "hexoderm/device/pose_average.h"

namespace hexoderm {

bool isSimulated(const SourceDescription& source) { return source.text.english().starts_with("Simulated "); }

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
    PoseAverage average;
    skin.record(up, frame_count, [&average](const SampleFrame& frame) { average.add(frame); });
    session.addPose({std::make_shared<const PoseCapture>(average.pose(id, label)), false});
  }
  return session;
}

SimulatedRobotSession simulateRobotSession(SimulatedRobot& robot, std::size_t pose_count, std::size_t frame_count) {
  SimulatedRobotSession result{Session(robot.model(), robot.neighbors(), {robot.description(), {}, {}}), {}};
  Session& session = result.session;
  session.setTruth(robot.groundTruth());
  for (std::size_t k = 0; k < pose_count; ++k) {
    result.poses.push_back(robot.nextPose());
    const PoseId id = session.nextPoseId();
    PoseCapture capture = averageFrames(robot.record(frame_count), id, message("pose {}", id));
    session.addPose({std::make_shared<const PoseCapture>(std::move(capture)), false, {}, result.poses.back().reported});
  }
  return result;
}

}  // namespace hexoderm
