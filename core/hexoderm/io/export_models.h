#pragma once

#include "hexoderm/io/skin_tree.h"

#include <string>

namespace hexoderm {

// Both hold one link of the robot.

/// SDF 1.9 (Gazebo): one <link> for the link of the robot, with the cells as visuals in it, and a <frame> for every
/// patch, cell and sensor. A link of SDF has a mass; the skin's is not known, and 1 g stands for it.
std::string sdfBytes(const SkinTree& tree);

/// MJCF (MuJoCo): a body for the link of the robot, each patch and each cell, a site for each sensor, and an
/// <accelerometer> for those sensors that are. The geometry has no mass and touches nothing.
std::string mjcfBytes(const SkinTree& tree);

}  // namespace hexoderm
