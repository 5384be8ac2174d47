#pragma once

#include "hexoderm/reconstruction/reconstruction.h"

#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace hexoderm {

enum class HoldOutOutcome {
  Evaluated,
  TooFewPoses,       ///< fewer than three other poses: offsets and attitudes can't be told apart
  NothingToCompare,  ///< in no patch do two cells read gravity in the pose and in the others
  Stopped,
};

/// What the errors say beside what was expected of them.
enum class HoldOutAgreement { AsStated, Worse, FarWorse };
/// "as_stated", "worse", "far_worse", as in reports.
std::string_view holdOutAgreementName(HoldOutAgreement agreement);

/// Poses besides the one that is held out: offsets and attitudes can't be told apart with fewer.
inline constexpr std::size_t kFewestOtherPoses = 3;

struct HoldOutCell {
  CellId cell;
  double error_rad = 0;
  double expected_rad = 0;  ///< root of the expected square of the error
};
struct HoldOutLink {
  LinkEnd source;
  LinkEnd target;
  double error_rad = 0;
  double expected_rad = 0;
};

/// How well a reconstruction foretells a pose that it has not seen.
///
/// Of each patch, solved without the pose, every cell's reading y in the pose is freed from the errors of its sensor
/// and turned into the patch frame: d_u = R_o_u gain_u^-1 (y_u - offset_u), a direction. They should all be one, that
/// of gravity, but which one nobody says: the patch's attitude in the pose is free, of which a direction shows two
/// degrees. So each cell is compared with what the N - 1 others foretell,
///   error_u = angle(d_u, unit sum of d_k over k != u),
/// and 2 N - 2 degrees of freedom are left in a patch. A link's error is the angle between the directions of its cells.
///
/// Expected: with attitude, offset and gains of a cell unknown but for their priors (the elastomer's of its links among
/// them) and for what its readings in the other poses say, its direction in this one has a mean squared error P_u, the
/// reading's own noise included; E error_u^2 = P_u + sum of P_k / (N - 1)^2 over the others, of a link P_c + P_n. What
/// all cells have in common (how well the poses' gravity directions are known) cancels out; angular accelerations of a
/// large part that a hand turns are not foreseen, so that its errors are larger than expected.
struct HoldOutResult {
  HoldOutOutcome outcome = HoldOutOutcome::TooFewPoses;
  PoseId pose;
  std::size_t other_poses = 0;  ///< that the reconstruction was made of
  std::vector<HoldOutCell> cells;
  std::vector<HoldOutLink> links;
  double rms_rad = 0;           ///< over cells
  double expected_rms_rad = 0;  ///< root of the mean of the cells' expected squares
  std::size_t degrees_of_freedom = 0;
  HoldOutAgreement agreement = HoldOutAgreement::AsStated;  ///< up to 1.5 and 3 times the expected rms
};

/// Solves the session without the pose and evaluates it there. Disabled poses stay out, and can be the one that is
/// evaluated. With the tree solver, which estimates no sensor, the readings are taken as they are and the errors of the
/// sensors expected in full. `stop` is looked at between the steps, not within a solve.
/// Throws InvalidArgument if there is no such pose, or for options out of range.
HoldOutResult evaluateHoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options = {},
                              const std::stop_token& stop = {});

}  // namespace hexoderm
