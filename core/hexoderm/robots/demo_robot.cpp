#include "hexoderm/robots/demo_robot.h"

#include "hexoderm/base/error.h"

#include <dlfcn.h>

#include <string>
#include <system_error>
#include <utility>

namespace hexoderm {
namespace {

/// The file of the shared library that this code is in; of a program, what it was started as.
std::filesystem::path fileOfThisCode() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&demoRobotFile), &info) == 0 || info.dli_fname == nullptr) return {};
  return info.dli_fname;
}

}  // namespace

std::filesystem::path demoRobotFile() {
  const std::filesystem::path name = std::filesystem::path("robot") / "demo_arm.urdf";
  std::vector<std::filesystem::path> places;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) places.push_back(program.parent_path().parent_path() / "share" / "hexoderm" / name);
  // A package may be installed elsewhere than it was built for. Libraries are in lib/ or some folders below.
  const std::filesystem::path file = fileOfThisCode();
  for (std::filesystem::path above = file.parent_path(); file.is_absolute() && above.has_relative_path();) {
    above = above.parent_path();
    places.push_back(above / "share" / "hexoderm" / name);
  }
  places.push_back(std::filesystem::path(HEXODERM_INSTALLED_DATA) / name);
  places.push_back(std::filesystem::path(HEXODERM_SOURCE_DATA) / name);
  std::vector<std::string> looked_at;
  for (const std::filesystem::path& place : places) {
    if (std::filesystem::exists(place, error)) return place;
    looked_at.push_back(place.string());
  }
  throw StorageError(message("the demo robot is not installed: there is no {}", looked_at));
}

PackageFolders packageFolders(const std::vector<std::string>& texts) {
  PackageFolders folders;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
      throw InvalidArgument(message("package: expected NAME=FOLDER, found \"{}\"", text));
    }
    folders[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return folders;
}

RobotModel robotNamed(const std::string& robot, const std::vector<std::string>& packages) {
  PackageFolders folders = packageFolders(packages);
  return RobotModel::read(robot == kDemoRobotName ? demoRobotFile() : std::filesystem::path(robot), std::move(folders));
}

}  // namespace hexoderm
