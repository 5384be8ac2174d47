#include "hexoderm/sim/robot_text.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/text.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/sim/patch_plan.h"

#include <utility>

namespace hexoderm {
namespace {

PatchMount mountOf(const std::string& text, const RobotText& words) {
  const std::size_t colon = text.rfind(':');
  const std::vector<std::string> numbers =
      colon == std::string::npos ? std::vector<std::string>() : split(text.substr(colon + 1), ',');
  if (colon == 0 || (numbers.size() != 3 && numbers.size() != 6)) {
    throw InvalidArgument(message("mount: expected {}, found \"{}\"", kMountSyntax, text));
  }
  PatchMount mount;
  mount.link = text.substr(0, colon);
  mount.patch = words.patch;
  mount.surface = words.surface;
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k % 3);
    const double most = k < 3 ? kMaxLength_m : kMaxAngle_rad;
    (k < 3 ? mount.T_l_m.t : rpy)[axis] = parseNumberWithin(numbers[k], "mount " + shortened(text, 80), -most, most);
  }
  mount.T_l_m.R = rotationFromRpy(rpy);
  return mount;
}

}  // namespace

void requireMount(const std::string& text) { mountOf(text, {}); }

SimulatedSkinOptions skinOptions(const RobotText& words, const std::string& motion) {
  if (motion != "hand" && motion != "robot") {
    throw InvalidArgument("motion: expected hand or robot, found \"" + motion + "\"");
  }
  SimulatedSkinOptions options = words.ideal         ? SimulatedSkinOptions::ideal()
                                 : motion == "robot" ? SimulatedSkinOptions::robot()
                                                     : SimulatedSkinOptions();
  static_cast<SkinChoice&>(options) = words;
  return options;
}

SimulatedRobotOptions robotOptions(const RobotText& words) {
  SimulatedRobotOptions options = words.ideal ? SimulatedRobotOptions::ideal() : SimulatedRobotOptions();
  if (words.base == "motors") {
    options.skin = SimulatedSkinOptions::robot();
  } else if (words.base == "hand") {
    options.base = BaseHold::Hand;
  } else if (words.base != "fixed") {
    throw InvalidArgument(message("base: expected fixed, motors or hand, found \"{}\"", words.base));
  }
  if (words.ideal && words.base == "motors") {
    throw InvalidArgument(message("base: a robot with its motors on is not ideal"));
  }
  parseLivePatch(words.patch);
  if (!words.surface.empty()) makeSurface(words.surface);
  options.seed = words.seed;
  static_cast<SkinChoice&>(options.skin) = words;
  for (const std::string& mount : words.mounts) options.mounts.push_back(mountOf(mount, words));
  if (options.mounts.empty()) {
    if (words.robot != kDemoRobotName) {
      throw InvalidArgument(message("the robot needs a mount for each patch, {}", kMountSyntax));
    }
    options.mounts = demoMounts();
  }
  packageFolders(words.packages);
  return options;
}

SimulatedRobot makeRobot(CellModel model, const RobotText& words) {
  SimulatedRobotOptions options = robotOptions(words);
  return {std::move(model), robotNamed(words.robot, words.packages), std::move(options)};
}

std::unique_ptr<SimulatedBody> makeBody(CellModel model, const RobotText& words, const std::string& motion) {
  if (!words.robot.empty()) return std::make_unique<SimulatedRobot>(makeRobot(std::move(model), words));
  return std::make_unique<SimulatedSkin>(std::move(model), skinOptions(words, motion));
}

}  // namespace hexoderm
