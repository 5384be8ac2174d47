#pragma once

#include "hexoderm/sim/simulated_robot.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// How a mount is written: m and rad in the link's frame (PatchMount::T_l_m).
inline constexpr std::string_view kMountSyntax = "LINK:X,Y,Z or LINK:X,Y,Z,ROLL,PITCH,YAW";

/// A simulated robot, all of whose patches are alike, as people name it, in the options of a program or in an address.
struct RobotText : SkinChoice {
  std::string robot;                  ///< as for robotNamed(); empty: none, a skin alone
  std::vector<std::string> packages;  ///< likewise
  std::vector<std::string> mounts;    ///< kMountSyntax; none: demoMounts(), for the demo robot only
  std::string base = "fixed";         ///< or motors: fixed, with the motors on; or hand
  bool ideal = false;                 ///< SimulatedRobotOptions::ideal()
};

/// Throws InvalidArgument for a text that is none of kMountSyntax, or has numbers that no place has.
void requireMount(const std::string& text);

/// The skin of these words alone. `motion` says what turns it: hand, or robot, with its motors on. Throws
/// InvalidArgument for another.
SimulatedSkinOptions skinOptions(const RobotText& words, const std::string& motion = "hand");

/// Throws InvalidArgument for words that mean nothing. Opens nothing.
SimulatedRobotOptions robotOptions(const RobotText& words);

/// Throws as robotOptions(), robotNamed() and SimulatedRobot().
SimulatedRobot makeRobot(CellModel model, const RobotText& words);

/// The robot of these words, or where they name none the skin alone, which `motion` turns.
std::unique_ptr<SimulatedBody> makeBody(CellModel model, const RobotText& words, const std::string& motion = "hand");

}  // namespace hexoderm
