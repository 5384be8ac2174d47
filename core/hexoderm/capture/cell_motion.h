#pragma once

// The motion of one cell, judged by its readings in the window of the drift and in that of the hold.

#include "hexoderm/capture/sample_slots.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace hexoderm {

/// The slots of a judgement, newest first. Drift is the slope of a straight line fitted with the weights 1 - u^2, u =
/// -1 to 1 over the window: ending in zero, they let a tremor of more than two periods through at a fraction of what
/// equal weights would.
struct SlotWindow {
  std::size_t newest = 0;              ///< index in CellSlots
  std::size_t drift_slots = 0;         ///< in the drift window
  std::size_t hold_slots = 0;          ///< in the window of the excess, at most drift_slots
  std::array<float, kSlots> time_s{};  ///< middle of each, from the middle of the drift window on
  std::array<float, kSlots> weight{};
};

/// The motion of a cell with samples in at least 60 % of the slots of both windows.
struct CellMotion {
  bool enough = false;
  Eigen::Vector3f mean_g = Eigen::Vector3f::Zero();  ///< in the hold window
  float count = 0;                                   ///< samples in the hold window
  float variance_g2 = 0;                             ///< in the hold window, mean of the axes
  /// Variance of white noise, mean of the axes: within slots, or where a slot holds hardly more than one sample, by the
  /// differences between neighbouring ones.
  float white_g2 = 0;
  float whiteness = 0;     ///< variance between slots over what white noise gives: near 1 for noise, more for motion
  float turn_rad2_s2 = 0;  ///< squared drift of the direction, noise included, for 1 g
  float slope_variance_s2 = 0;  ///< variance of the slope along one axis for white noise of variance 1
  /// Variance of the slots' means about the straight line, across gravity, mean of the two axes, as that of a sample.
  float residual_g2 = 0;
  /// The same of the means of kBatches parts of the window, over residual_g2: 1 for white noise, more if it is slow,
  /// less if it is a quick tremor. Negative: slots are too few to tell.
  float colour = -1;
  std::size_t steady_slots = 0;  ///< newest slots in a row that are near the newest ones
};

/// `steady_g` is the distance within which a slot counts as near the newest ones.
CellMotion motionOf(const CellSlots& slots, const SlotWindow& window, float steady_g);

}  // namespace hexoderm
