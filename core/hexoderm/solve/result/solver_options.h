#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/units.h"

#include <span>
#include <string_view>
#include <vector>

namespace hexoderm {

/// The way in which a session is solved.
enum class Solver {
  Global,  ///< all cells, poses and links together, with the sensors' errors
  Tree,    ///< the paper's way, along shortest paths
};
/// Behaviour of a mould when it is bent. Pivot: nothing stretches, and both extended port vectors end in one point.
/// Arc: the pitch is kept along the arc. Fit: the data tell the position between the two.
///
/// Pivot is linkTransform(). Fit stays at 0.5 +- 0.5 where no loop tells; for made-up readings choose Pivot.
enum class GapModel { Fit, Arc, Pivot };
/// Subtract each cell's mean vector before the SVD.
enum class Centring { Auto, On, Off };
/// Append the gap's axes, scaled to 10 %, to the data; Auto: of edges that the poses leave more uncertain than the
/// elastomer does.
enum class SupportAxes { Auto, On, Off };
/// 3, 2, 1, 1 by class, or by predicted deviation and residual.
enum class LinkWeights { Paper, Residual };

/// SolverOptions::class_threshold is above 0 and at most this.
inline constexpr double kMaxClassThreshold = 1000;

/// How well every measured cell is to be known, with 95 %, for a result to be good. SolverOptions::goal is above 0, and
/// at most 1 m and 20 degrees.
struct Goal {
  double position_m = 3 * kMillimetre;
  double orientation_rad = 2 * kDegree;
  friend bool operator==(const Goal&, const Goal&) = default;
};
inline constexpr Goal kMaxGoal{1, 20 * kDegree};

/// How a session is solved; the defaults suit every skin.
struct SolverOptions {
  Solver solver = Solver::Global;
  GapModel gap_model = GapModel::Fit;  ///< of the global solver; the tree always uses Pivot
  Centring centring = Centring::Auto;
  SupportAxes support_axes = SupportAxes::Auto;
  LinkWeights weights = LinkWeights::Paper;
  /// A singular value of at least this much counts as a defined direction, eq. (17). The paper's threshold of 1 calls
  /// its own recipe "partially defined" as soon as the poses are a hair off orthogonal; with 0.5, two directions 60 to
  /// 120 degrees apart are fully defined.
  double class_threshold = 0.5;
  /// Limits beyond which a link can't be a skin link (it is a cable, a joint or a wrong port), radians; three predicted
  /// standard deviations are added before a link is judged.
  double max_bend_rad = 1.0471975511965976;   ///< 60 degrees
  double max_twist_rad = 0.6981317007977318;  ///< 40 degrees
  double max_yaw_rad = 0.6981317007977318;    ///< 40 degrees
  /// A link is no rigid link, and a cell's sensor is broken, if what they read is less likely than a normal deviate of
  /// this many standard deviations, the priors of the sensors' errors granted.
  double max_misfit = 5.0;
  /// A link is no skin link if, solved with all others, its ends lie further apart than this many of the cell model's
  /// link_sigma_m.
  double max_opening = 15.0;
  Goal goal;  ///< the verdict compares the result with it; the estimate does not depend on it
  /// Cells whose readings are not to be used; they are placed through their links.
  std::vector<CellId> left_out;

  /// Throws InvalidArgument naming the first value out of range.
  void validate() const;
  friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

std::string_view solverName(Solver solver);                  ///< the name of a choice, in files and on the command line
std::string_view gapModelName(GapModel gap_model);           ///< likewise
std::string_view centringName(Centring centring);            ///< likewise
std::string_view supportAxesName(SupportAxes support_axes);  ///< likewise
std::string_view linkWeightsName(LinkWeights weights);       ///< likewise
/// Throw InvalidArgument listing the names there are.
Solver solverFromName(std::string_view name);
GapModel gapModelFromName(std::string_view name);        ///< throws as solverFromName()
Centring centringFromName(std::string_view name);        ///< throws as solverFromName()
SupportAxes supportAxesFromName(std::string_view name);  ///< throws as solverFromName()
LinkWeights linkWeightsFromName(std::string_view name);  ///< throws as solverFromName()

/// An option with few values as a value, so that a command line and settings hold all of them without knowing any.
struct SolverChoice {
  std::string_view name;  ///< on the command line, after "--"
  std::string_view help;
  std::string_view (*get)(const SolverOptions& options);
  void (*set)(SolverOptions& options, std::string_view value);  ///< throws as solverFromName()
};
std::span<const SolverChoice> solverChoices();  ///< all of them

}  // namespace hexoderm
