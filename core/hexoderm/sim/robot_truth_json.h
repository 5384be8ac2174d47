#pragma once

#include "hexoderm/sim/simulated_session.h"

#include <string>

namespace hexoderm {

inline constexpr const char* kRobotTruthFormat = "hexoderm-robot-truth";  ///< what stands under `format`
inline constexpr int kRobotTruthVersion = 1;                              ///< what stands under `version`

/// What is known only of simulated robots, as JSON: where every patch is on its link, the errors of the joints, and how
/// the robot stood in each pose (resources/formats/README.md has the keys).
std::string robotTruthToJson(const SimulatedRobot& robot, const SimulatedRobotSession& simulated);

}  // namespace hexoderm
