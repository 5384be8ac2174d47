#pragma once

#include "hexoderm/io/skin_tree.h"

#include <string>
#include <string_view>

namespace hexoderm {

/// SDF 1.9 (Gazebo): one <link> for the link of the robot, with the cells as visuals in it, and a <frame> for every
/// patch, cell and sensor. A link of SDF has a mass; the skin's is not known, and 1 g stands for it.
std::string sdfBytes(const SkinTree& tree);
void verifySdf(std::string_view bytes, const SkinTree& tree, const std::string& file);

/// MJCF (MuJoCo): a body for the link of the robot, each patch and each cell, a site for each sensor, and an
/// <accelerometer> for those sensors that are. The geometry has no mass and touches nothing.
std::string mjcfBytes(const SkinTree& tree);
void verifyMjcf(std::string_view bytes, const SkinTree& tree, const std::string& file);

// Both hold one link of the robot. The functions that verify compare where everything ends up, to 1e-9 (m and matrix
// elements), and throw FormatError.

}  // namespace hexoderm
