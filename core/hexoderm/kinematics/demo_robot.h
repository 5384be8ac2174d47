#pragma once

#include <filesystem>

namespace hexoderm {

/// The made-up arm to try things with (resources/robot/demo_arm.urdf), beside the running program where it was
/// installed, where this library was installed, or in its source tree. Throws StorageError naming these places if it is
/// in none.
std::filesystem::path demoRobotFile();

}  // namespace hexoderm
