#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/message.h"

#include <optional>
#include <string_view>
#include <vector>

namespace hexoderm {

/// How good a calibration is.
enum class VerdictLevel {
  Good,        ///< every measured cell is known to the goal (SolverOptions::goal), and nothing was found
  Usable,      ///< known to three times the goal, or something was found
  Coarse,      ///< less well known
  NotEnough,   ///< what was measured leaves the cells' places open
  NotTrusted,  ///< what was measured contradicts the model: no uncertainty is stated
  Failed,      ///< most cells are linked to no other, or have no readings
};
std::string_view verdictName(VerdictLevel level);                    ///< "good", ..., "not_enough", ..., as in files
std::optional<VerdictLevel> verdictFromName(std::string_view name);  ///< nothing for a name that is none

/// What keeps a result from being better than it is.
enum class Limit {
  Nothing,     ///< it is good
  NoSkin,      ///< there is no cell, or nothing between cells to estimate
  NoPose,      ///< nothing was measured
  Directions,  ///< gravity was seen from too few directions
  Readings,    ///< some cells have readings in few of the poses
  Mould,       ///< what more poses don't lower: how cells lie in the mould, and what lies between them
  Patches,     ///< no link joins the patches
  Findings,    ///< something is broken or contradictory
};
std::string_view limitName(Limit limit);                    ///< "nothing", "no_skin", "no_pose", ..., as in files
std::optional<Limit> limitFromName(std::string_view name);  ///< nothing for a name that is none

/// What helps most, next.
enum class Remedy {
  Nothing,     ///< the result is as good as it gets: it can be exported
  CheckSkin,   ///< the connection, or the links between the cells
  TakePose,    ///< another pose, in a new direction
  RetakePoses  ///< poses again in which cells have no usable reading (Assessment::retake)
};
std::string_view remedyName(Remedy remedy);  ///< "nothing", "check_skin", "take_pose", "retake_poses", as in files
std::optional<Remedy> remedyFromName(std::string_view name);  ///< nothing for a name that is none

/// The one answer to: how well is the skin known, what limits that, and what helps next? Computed once for a result
/// (assess()), and held by calibration files. Banner, steps, panels, command line, report, exit code and a robot's rule
/// for stopping say what stands here and judge nothing by themselves.
struct Assessment {
  VerdictLevel level = VerdictLevel::Failed;
  Message reason;                              ///< one sentence or a few
  std::optional<double> position_95_m{};       ///< at the worst measured cell, relative to its origin
  std::optional<double> orientation_95_rad{};  ///< absent if they are not known, and of NotTrusted
  Limit limit = Limit::Nothing;
  std::vector<CellId> limiting_cells{};  ///< Readings: the cells that lack some
  Remedy remedy = Remedy::Nothing;
  Message next_action;           ///< one sentence or two
  std::vector<PoseId> retake{};  ///< RetakePoses

  /// Robot software can use it: the level is good, usable or coarse.
  [[nodiscard]] bool isUsable() const { return level <= VerdictLevel::Coarse; }
  /// The part should be held still once more, in a new direction or an old one.
  [[nodiscard]] bool wantsPose() const { return remedy == Remedy::TakePose || remedy == Remedy::RetakePoses; }
};

}  // namespace hexoderm
