#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/sim/simulated_robot.h"
#include "hexoderm/sim/simulated_skin.h"

namespace hexoderm {

/// What a simulated skin or robot says of itself begins so, also in files and over a wire: nothing real was measured.
bool isSimulated(const SourceDescription& source);

/// A session without poses on a simulated skin: its model, neighbours, description and truth.
Session beginSimulatedSession(const SimulatedSkin& skin);

/// A whole scripted calibration of a simulated skin: `pose_count` poses as SimulatedSkin::upDirections() has them, each
/// the mean of `frame_count` samples.
Session simulateSession(SimulatedSkin& skin, std::size_t pose_count, std::size_t frame_count = 100);

/// A whole calibration of a simulated robot, and how it stood.
struct SimulatedRobotSession {
  Session session;                        ///< poses with the joint angles that the robot reports; places as truth
  std::vector<SimulatedRobotPose> poses;  ///< the truth of each pose of the session
};
/// `pose_count` poses with joints in angles drawn at random, each the mean of `frame_count` samples.
SimulatedRobotSession simulateRobotSession(SimulatedRobot& robot, std::size_t pose_count,
                                           std::size_t frame_count = 100);

}  // namespace hexoderm
