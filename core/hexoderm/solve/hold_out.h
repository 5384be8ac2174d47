#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <stop_token>
#include <vector>

namespace hexoderm {

/// What became of a pose that was held out.
enum class HoldOutOutcome {
  Evaluated,
  TooFewPoses,       ///< fewer than three other poses: offsets and attitudes can't be told apart
  NothingToCompare,  ///< in no patch do two cells read gravity in the pose and in the others
  Stopped,
};

/// Agreement of the errors with their expected size.
enum class HoldOutAgreement { AsStated, Worse, FarWorse };

/// Poses besides the one that is held out: offsets and attitudes can't be told apart with fewer.
inline constexpr std::size_t kFewestOtherPoses = 3;

/// How well the other poses foretell a cell's reading.
struct HoldOutCell {
  CellId cell;
  double error_rad = 0;
  double expected_rad = 0;  ///< root of the expected square of the error
};
/// How well the other poses foretell a link.
struct HoldOutLink {
  LinkEnd source;
  LinkEnd target;
  double error_rad = 0;
  double expected_rad = 0;
};

/// How well a reconstruction foretells a pose that it has not seen.
///
/// Of each patch, solved without the pose, every cell's reading y in the pose is freed from the errors of its sensor
/// and turned into the patch frame: s_u = R_o_u gain_u^-1 (y_u - offset_u), the specific force at the cell. All cells
/// should see one motion of a rigid part, s_u = f + w x t_u: gravity and whatever a hand's tremor adds to it (f), and a
/// swing w, for a hand turns the part too while it is sampled. Nobody says f, and w little (prior: see
/// expected_turning_rad_s2). So each cell is compared with what the N - 1 others foretell by f and w,
///   error_u = angle(s_u, f_others + w_others x t_u),
/// and a link's error is the angle between what its two cells see, the swing between them apart.
///
/// Expected: with attitude, offset and gains of a cell unknown but for their priors (the elastomer's of its links among
/// them) and for what its readings in the other poses say, s_u has a covariance S_u, the reading's own noise included;
/// what the others foretell has one that follows from theirs. Only the sensor's own noise counts there, not the tremor
/// that the solver grants each reading (GravityTable): tremor moves the part as a whole, and what it did to the other
/// poses comes out here as a motion again, which is fitted away. The sensor's own noise is what a sample of a cell
/// scatters by in the stillest poses of the session, over the square root of the samples averaged: windows of any
/// length weigh by their information. Where every pose trembles, up to half as much again is expected as is seen.
/// Offsets change from pose to pose as the cell model says: a sensor's own instability counts with its noise, and what
/// all offsets changed by together in the pose, in the sensors' axes, is a third vector that the others foretell.
///
/// With three other poses offsets and gains are known from their priors mostly: the expected error of uncalibrated
/// sensors is then above a degree, and the check is coarse (detectable_rad). From five on it is about 0.2 degrees.
struct HoldOutResult {
  HoldOutOutcome outcome = HoldOutOutcome::TooFewPoses;
  PoseId pose;
  std::size_t other_poses = 0;  ///< number of poses that the reconstruction was made of
  std::vector<HoldOutCell> cells;
  std::vector<HoldOutLink> links;
  double rms_rad = 0;           ///< over cells
  double expected_rms_rad = 0;  ///< root of the mean of the cells' expected squares
  /// Half of the part that turned by this much against the other half would be found three times in four.
  double detectable_rad = 0;
  bool coarse = false;  ///< true beyond 2.5 degrees: a result that agrees may still be bent
  /// The swing that fits best, as an angular acceleration; of the patch that turns most.
  double turning_rad_s2 = 0;
  /// Rms of what a tremor leaves, 0.05 degrees at 4 to 12 Hz averaged over 0.1 s, with what it did to the other poses.
  double expected_turning_rad_s2 = 0;
  bool turned = false;  ///< by more than 2 times what is expected
  /// As stated: rms up to 1.5 times what is expected, the worst cell's error up to 4 times (of 10,000 cells one is
  /// beyond by chance once in a thousand times), turning up to 2 times. Far worse: beyond 3, 8 or 3 times. A part that
  /// moved while it was read, or was deformed, shows in the rms, in the turning, or in both; a broken sensor at its
  /// cell.
  HoldOutAgreement agreement = HoldOutAgreement::AsStated;
};

/// Solves the session without the pose and evaluates it there. Disabled poses stay out, and can be the one that is
/// evaluated. With the tree solver, which estimates no sensor, the readings are taken as they are and the errors of the
/// sensors expected in full. `stop` is looked at between the steps, not within a solve.
/// Throws InvalidArgument if there is no such pose, or for options out of range.
HoldOutResult evaluateHoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options = {},
                              const std::stop_token& stop = {});

}  // namespace hexoderm
