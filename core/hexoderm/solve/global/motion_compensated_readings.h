#pragma once

#include "hexoderm/solve/global/pose_angular_accelerations.h"

#include <span>
#include <vector>

namespace hexoderm {

/// The readings of a patch with so many poses that their angular accelerations are no unknowns of the joint equations:
/// they are freed from what the accelerations add to them, found in turn with everything else. What is changed is
/// changed in a GlobalProblem without accelerations, which is to be solved again after each change.
class MotionCompensatedReadings {
 public:
  /// The problem's readings are as they were measured.
  explicit MotionCompensatedReadings(const GlobalProblem& problem);

  /// Finds the accelerations anew, for the placements of `state` and `sensors` fitted to them: the problem's readings
  /// are freed from them and less certain by what is not known of them, its acceleration_sigma is their spread, and
  /// `state` has them. False if they have settled: then nothing has changed.
  bool followAngularAccelerations(GlobalProblem& problem, GlobalState& state, std::span<const SensorState> sensors);

  /// Whatever else a hand does leaves errors in the readings, which grow with the distance from the middle, and with
  /// hundreds of poses any cell would look broken for them. They count as noise, as large as the readings show: a
  /// reading's variance V becomes f V + (2/3) (s l / g)^2, with its cell's lever l, as for accelerations of s per axis;
  /// f (at least 1) fits the inner cells, and s the rest of the outer ones. Medians, because single cells may be
  /// broken. True if the variances have grown, which they do once.
  bool widenNoise(GlobalProblem& problem, const GlobalState& state, std::span<const SensorState> sensors);

  /// The cell has no readings from now on.
  void leaveOut(std::size_t cell) { as_measured_[cell].clear(); }

 private:
  void rewrite(GlobalProblem& problem, const GlobalState& state, std::span<const SensorState> sensors) const;

  std::vector<std::vector<CellReading>> as_measured_;  ///< per cell
  PoseAngularAccelerations swings_;
  bool any_swings_ = false;
  double noise_factor_ = 1;        ///< of the variance of every reading
  double noise_per_lever_sq_ = 0;  ///< and what is added to it, g^2/m^2
  bool noise_is_widened_ = false;
};

}  // namespace hexoderm
