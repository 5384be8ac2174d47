#pragma once

namespace hexoderm {

/// From now on openSkinSource() opens simulated skins that stream: what a newcomer sees, and what programs are tried
/// with. "sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot]", patch and surface as in SimulatedSkinOptions,
/// lies on a table until TurnTo turns it, by a simulated hand; or a robot turns it by itself (`motion`) and refuses
/// TurnTo.
/// "sim:robot[?urdf=FILE&package=NAME=FOLDER&mount=LINK:X,Y,Z&base=fixed|motors|hand&patch=...&surface=...&seed=N
/// &speed=X|max]", as RobotText has it, is on the links of a simulated robot, which moves its joints for TurnTo and
/// says where they stand; package and mount may be repeated. Of hex-bma150 cells. `speed`: times real time, above 0;
/// max: as fast as the listener takes it. SetLed is taken, SetRate is not. Opening throws InvalidArgument naming what
/// was expected, and for the files of a robot as makeRobot().
///
/// Call it once in a program, before any source is opened; again it changes nothing.
void addSimulatedSources();

}  // namespace hexoderm
