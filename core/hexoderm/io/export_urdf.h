#pragma once

#include "hexoderm/io/skin_tree.h"
#include "hexoderm/robots/robot_model.h"

#include <filesystem>
#include <string>

namespace hexoderm {

/// What a URDF of the skin holds: all joints fixed and named after their child. With one link per patch the cells are
/// its visuals and the sensors are <sensor> elements. Cells are drawn as hexagonal prisms.
struct UrdfContent {
  SkinTree tree;
  bool link_per_cell = true;
  UrdfForm form = UrdfForm::Alone;  ///< of a file of the skin's own
};

/// The skin in a file of its own. InvalidArgument: the name of a patch is none that a xacro macro can have.
std::string urdfBytes(const UrdfContent& content);

/// The description of a robot: its text, and what urdfdom and KDL make of it.
struct RobotUrdf {
  std::string text;
  RobotModel model;
};
/// Throws StorageError; FormatError, naming file, place and expectation, for what is no URDF.
RobotUrdf readRobotUrdf(const std::filesystem::path& path);

/// The robot with the skin on it: its text byte for byte, and in front of </robot> the links and joints of the skin.
/// InvalidArgument: the robot has no link of the name that a patch is placed on. FormatError: it has a link, joint or
/// sensor already of the name of one that would be added. Materials that it has, of an earlier skin, are used.
std::string robotUrdfBytes(const RobotUrdf& robot, const UrdfContent& content);

}  // namespace hexoderm
