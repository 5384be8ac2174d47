#pragma once

#include "hexoderm/io/skin_tree.h"

#include <string>
#include <vector>

namespace hexoderm {

/// Static transforms for TF: of every frame, its parent, and T_parent_frame as a translation in metres and a
/// quaternion.
std::string rosLaunchText(const std::vector<SkinFrame>& frames);   ///< ROS 1: static_transform_publisher of tf2_ros
std::string ros2LaunchText(const std::vector<SkinFrame>& frames);  ///< ROS 2, in Python
/// A list of geometry_msgs/TransformStamped, for a node that sends all of them at once.
std::string transformsYaml(const std::vector<SkinFrame>& frames);

}  // namespace hexoderm
