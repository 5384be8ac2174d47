#pragma once

// findLinks() on simulated robots with truth, counted over seeds: for the tests, and for the figures in the room's
// README.

#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/sim/simulated_robot.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/mounting/attachment/links_tally.h"

namespace hexoderm {

struct SimulatedLinksOptions {
  std::size_t poses = 8;
  bool motors = false;
  double zero_sigma_rad = 0.5 * kDegree;  ///< of the simulated joints
  LinksOptions find{};
};

/// Patches on the upper arm, the forearm and the hand of the demo robot.
inline SimulatedRobot simulatedArm(std::uint64_t seed, const SimulatedLinksOptions& options) {
  SimulatedRobotOptions robot;
  if (options.motors) robot.skin = SimulatedSkinOptions::robot();
  robot.seed = seed;
  robot.zero_offset_sigma_rad = options.zero_sigma_rad;
  robot.mounts = demoMounts();
  PatchMount hand{"hand", {rotationFromRpy({0.2, 0.4, 1}), {0, 0.04, 0.05}}, "sheet:2x3", "plane"};
  robot.mounts.push_back(hand);
  return {builtInCellModel("hex-bma150"), RobotModel::read(demoRobotFile()), robot};
}

inline LinksTally tallySimulatedLinks(const SimulatedLinksOptions& options, int seeds) {
  LinksTally tally;
  for (int seed = 1; seed <= seeds; ++seed) {
    SimulatedRobot robot = simulatedArm(static_cast<std::uint64_t>(seed), options);
    const SimulatedRobotSession simulated = simulateRobotSession(robot, options.poses);
    std::map<PoseId, JointAngles> angles;
    for (const SessionPose& pose : simulated.session.poses()) angles.emplace(pose.capture->id, pose.joint_angles);
    LinksTruth truth{{}, robot.zeroOffsets(), simulated.poses.front().up_w};
    for (const MountedPatch& patch : robot.patches()) {
      for (std::size_t k = 0; k < patch.cells.size(); ++k) {
        truth.cells[patch.cells[k]] = {patch.link, patch.T_l_u[k].R};
      }
    }
    tally.add(findLinks(*reconstruct(*simulated.session.snapshot()), robot.robot(), angles, options.find), truth);
  }
  return tally;
}

}  // namespace hexoderm
