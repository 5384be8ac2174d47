#pragma once

#include <string>
#include <string_view>

namespace hexoderm {

enum class Solver { Tree };                  ///< the paper's way (SPEC step 9)
enum class Centring { Auto, On, Off };       ///< subtract each cell's mean vector before the SVD (step 6)
enum class SupportAxes { Auto, On, Off };    ///< append the gap's axes, scaled to 10 % (step 8)
enum class LinkWeights { Paper, Residual };  ///< 3, 2, 1, 1 by class, or by predicted deviation and residual (2.2)

struct SolverOptions {
  Solver solver = Solver::Tree;
  Centring centring = Centring::Auto;
  SupportAxes support_axes = SupportAxes::Auto;
  LinkWeights weights = LinkWeights::Paper;
  /// A singular value of at least this much counts as a defined direction, eq. (17); the paper takes it as 1
  /// (SPEC 2.2).
  double class_threshold = 0.5;
  /// Limits beyond which a link can't be a skin link (it is a cable, a joint or a wrong port), radians; three predicted
  /// standard deviations are added before a link is judged.
  double max_bend_rad = 1.0471975511965976;   ///< 60 degrees
  double max_twist_rad = 0.6981317007977318;  ///< 40 degrees
  double max_yaw_rad = 0.6981317007977318;    ///< 40 degrees
  /// A link is no rigid link if its residual is larger than this many times the residual that the priors predict.
  double max_residual_ratio = 3.0;

  /// Throws InvalidArgument naming the first value out of range.
  void validate() const;
};

std::string_view solverName(Solver solver);
std::string_view centringName(Centring centring);
std::string_view supportAxesName(SupportAxes support_axes);
std::string_view linkWeightsName(LinkWeights weights);
/// Throw InvalidArgument listing the names there are. "global" is refused: it is not in this version.
Solver solverFromName(std::string_view name);
Centring centringFromName(std::string_view name);
SupportAxes supportAxesFromName(std::string_view name);
LinkWeights linkWeightsFromName(std::string_view name);

}  // namespace hexoderm
