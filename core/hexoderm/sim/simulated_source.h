#pragma once

// Private to device/.

#include "hexoderm/device/skin_source.h"

#include <memory>
#include <string>

namespace hexoderm {

/// A simulated skin that streams: what a newcomer sees, and what programs are tried with. It lies on a table until
/// TurnTo turns it, by a simulated hand; or a robot turns it by itself (SimulatedSkinOptions::robot) and refuses
/// TurnTo. Or it is on the links of a simulated robot, which moves its joints for TurnTo and says where they stand.
/// SetLed is taken, SetRate is not.
///
/// "sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot]", patch and surface as in SimulatedSkinOptions, or
/// "sim:robot[?urdf=FILE&package=NAME=FOLDER&mount=LINK:X,Y,Z&base=fixed|motors|hand&patch=...&surface=...&seed=N
/// &speed=X|max]", as RobotInWords has it; package and mount may be repeated. Of hex-bma150 cells. `speed`: times real
/// time, above 0; max: as fast as the listener takes it. Throws InvalidArgument naming what was expected, and for the
/// files of a robot as makeRobot().
std::unique_ptr<SkinSource> openSimulatedSource(const std::string& address);
/// Throws like openSimulatedSource() for faults of the address itself; builds nothing, however many cells there are.
/// Only building can tell that a patch does not fit its surface.
void checkSimulatedAddress(const std::string& address);

}  // namespace hexoderm
