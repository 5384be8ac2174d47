#pragma once

// The formats that are written in one go. None of these functions throws an Error: exportReconstruction(),
// exportBundle() and exportBytes() call them, and have checked that options make sense, that all numbers are finite and
// that a mesh has cells. Placements in a Reconstruction are in the frame of the patch's origin cell, or in that of the
// link that ExportOptions::in_link names. gltfBytes() writes them as they are, and `frame` says in words which it is;
// dotText() takes no frame, for it draws the flat layout.

#include "hexoderm/io/exporter.h"
#include "hexoderm/io/skin_tree.h"

#include <string>
#include <vector>

namespace hexoderm {

/// A cluster per patch, a node per cell at its place in the flat layout (real size; `neato` and `fdp` read `pos` in
/// inches), two directed edges per link with the ports at their ends and the quality as colour, style and tooltip.
std::string dotText(const Reconstruction& reconstruction);

/// glTF 2.0 in its binary form (.glb), metres. glTF has +Y up: the root node turns the skin's frame, whose z becomes
/// that +Y. Below it a node "cell_N" for each cell, with its place as translation and rotation and one of five shared
/// meshes, one a colour, and below that a node for each sensor. The frame is said in the root node's extras.
std::string gltfBytes(const Reconstruction& reconstruction, const std::string& frame);

/// SDF 1.9 (Gazebo), of one link of the robot: one <link> for it, with the cells as visuals in it, and a <frame> for
/// every patch, cell and sensor. A link of SDF has a mass; the skin's is not known, and 1 g stands for it.
std::string sdfBytes(const SkinTree& tree);
/// MJCF (MuJoCo), likewise: a body for the link of the robot, each patch and each cell, a site for each sensor, and an
/// <accelerometer> for those sensors that are. The geometry has no mass and touches nothing.
std::string mjcfBytes(const SkinTree& tree);

/// Static transforms for TF: of every frame, its parent, and T_parent_frame as a translation in metres and a
/// quaternion.
std::string rosLaunchText(const std::vector<SkinFrame>& frames);   ///< ROS 1: static_transform_publisher of tf2_ros
std::string ros2LaunchText(const std::vector<SkinFrame>& frames);  ///< ROS 2, in Python
/// A list of geometry_msgs/TransformStamped, for a node that sends all of them at once.
std::string transformsYaml(const std::vector<SkinFrame>& frames);

/// TUM SkinConfig XML: every patch with its cells in the frame of its origin (the root cell), their neighbours at each
/// port, and a patchExtrinsics element with where the root cell is in the link it is placed on. Metres, 12 decimals.
std::string tumBytes(const Reconstruction& reconstruction, const ExportOptions& options);

}  // namespace hexoderm
