#include "app/cli/export_robot.h"

#include <algorithm>
#include <string_view>

namespace hexoderm::cli {
namespace {

/// Whether a format has a link that a patch is fixed to whose place is not known.
bool hasParent(ExportFormat format) {
  const auto parent = std::ranges::find(exportOptions(), "parent", &ExportOptionDescription::name);
  return parent != exportOptions().end() && std::ranges::find(parent->formats, format) != parent->formats.end();
}

/// Whether a file is of no use without the robot's own links.
bool isForARobot(ExportFormat format) {
  using enum ExportFormat;
  return format == RobotUrdf || format == TfRos1 || format == TfRos2 || format == TfYaml;
}

}  // namespace

void requireLinksOfTheRobot(const std::vector<ExportFormat>& formats, const ExportOptions& options) {
  if (options.robot_urdf.empty()) return;
  const RobotModel robot = [&] {
    try {
      return openRobot(options.robot_urdf.string(), {});
    } catch (const BadInput& error) {
      throw BadInput("--robot " + std::string(error.what()));
    }
  }();
  const auto require = [&](const std::string& link, std::string_view option) {
    try {
      static_cast<void>(robot.linkNamed(link));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(std::string(option), error.message());
    }
  };
  for (const PatchOnLink& place : options.placements) require(place.link, "the place of a patch");
  if (!options.in_link.empty()) require(options.in_link, "--in-link");
  if (options.placements.empty() && std::ranges::any_of(formats, hasParent)) require(options.parent_link, "--parent");
}

std::string joinedWithoutAPlace(const std::vector<ExportFormat>& formats, const ExportOptions& options) {
  if (!options.placements.empty() || std::ranges::none_of(formats, isForARobot)) return {};
  return "Where the patch is on the robot is not known: it is joined to " + options.parent_link +
         " without any offset. --place LINK:x,y,z,roll,pitch,yaw says where it is.";
}

bool isOfTheRobot(const Error& error, const ExportOptions& options) {
  return !options.robot_urdf.empty() && std::string_view(error.what()).starts_with(options.robot_urdf.string() + ": ");
}

}  // namespace hexoderm::cli
