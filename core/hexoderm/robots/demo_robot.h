#pragma once

#include "hexoderm/robots/robot_model.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// The made-up arm to try things with (resources/robot/demo_arm.urdf), beside the running program where it was
/// installed, where this library was installed, or in its source tree. Throws StorageError naming these places if it is
/// in none.
std::filesystem::path demoRobotFile();

/// The name of the made-up arm where any robot can be named.
inline constexpr std::string_view kDemoRobotName = "demo";
/// Throws InvalidArgument for a text that is not "NAME=FOLDER".
PackageFolders packageFolders(const std::vector<std::string>& texts);
/// The robot of a URDF's file, or the made-up arm as kDemoRobotName. Throws as packageFolders(), demoRobotFile() and
/// RobotModel::read().
RobotModel robotNamed(const std::string& robot, const std::vector<std::string>& packages = {});

}  // namespace hexoderm
