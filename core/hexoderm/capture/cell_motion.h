#pragma once

// The motion of one cell, judged by its readings in the window of the drift and in that of the hold.

#include "hexoderm/capture/sample_slots.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
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

/// Parts of the drift window whose means tell how slow noise is: of the periods that a slope of the window feels.
inline constexpr std::size_t kBatches = 5;

/// Deviations from a straight line, across gravity.
class LineResiduals {
 public:
  explicit LineResiduals(const Eigen::Vector3f& along) : along_(along) {}
  void add(const Eigen::Vector3f& weighted, float weight) {
    if (weight <= 0) return;
    const float along = weighted.dot(along_);
    sum_g2_ += (weighted.squaredNorm() - along * along) / weight;
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Of one sample along one axis. A line takes two degrees of freedom.
  [[nodiscard]] float variance_g2() const {
    return count_ > 2 ? std::max(0.0F, sum_g2_) / static_cast<float>(2 * (count_ - 2)) : 0;
  }

 private:
  Eigen::Vector3f along_;
  float sum_g2_ = 0;
  std::size_t count_ = 0;
};

/// `steady_g` is the distance within which a slot counts as near the newest ones.
inline CellMotion motionOf(const CellSlots& slots, const SlotWindow& window, float steady_g) {
  // Sums are taken about a base near the readings: about zero, floats would lose the small differences.
  float n = 0, n_of_several = 0, several = 0, scatter = 0;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float sum_squares = 0;
  float g0 = 0, g1 = 0, g2 = 0;
  float v0 = 0, v1 = 0, v2 = 0;
  Eigen::Vector3f m0 = Eigen::Vector3f::Zero(), m1 = Eigen::Vector3f::Zero();
  std::size_t filled = 0, filled_in_hold = 0;
  Eigen::Vector3f base = Eigen::Vector3f::Zero();
  float differences = 0, pairs = 0, neighbour_count = 0;
  Eigen::Vector3f neighbour = Eigen::Vector3f::Zero();
  bool has_base = false, steady = true;
  const float steady_g2 = steady_g * steady_g;

  CellMotion motion;
  for (std::size_t k = 0; k < window.drift_slots; ++k) {
    const CellSlot& slot = slots[(window.newest + kSlots - k) % kSlots];
    if (slot.count > 0) {
      if (!has_base) {
        base = slot.mean_g;
        has_base = true;
      }
      const Eigen::Vector3f m = slot.mean_g - base;
      const float squared = m.squaredNorm();
      const float g = window.weight[k], t = window.time_s[k];
      g0 += g;
      g1 += g * t;
      g2 += g * t * t;
      m0 += g * m;
      m1 += (g * t) * m;
      const float gg = g * g / slot.count;
      v0 += gg;
      v1 += gg * t;
      v2 += gg * t * t;
      ++filled;
      if (neighbour_count > 0) {
        differences += (m - neighbour).squaredNorm() * slot.count * neighbour_count / (slot.count + neighbour_count);
        ++pairs;
      }
      neighbour = m;
      neighbour_count = slot.count;
      if (k < window.hold_slots) {
        ++filled_in_hold;
        n += slot.count;
        sum += slot.count * m;
        sum_squares += slot.count * squared;
        scatter += slot.scatter_g2;
        if (slot.count > 1) {
          n_of_several += slot.count;
          ++several;
        }
      }
      if (squared > steady_g2) steady = false;
    }
    if (steady) motion.steady_slots = k + 1;
  }
  // 60 %
  if (10 * filled < 6 * window.drift_slots || 10 * filled_in_hold < 6 * window.hold_slots || filled < 3 || n < 2) {
    return motion;
  }

  motion.enough = true;
  motion.count = n;
  const Eigen::Vector3f mean = sum / n;
  motion.mean_g = base + mean;
  const float between = std::max(0.0F, sum_squares - n * mean.squaredNorm());
  motion.variance_g2 = (scatter + between) / (3 * (n - 1));
  motion.white_g2 =
      several > 0 && n_of_several - several >= 3 ? scatter / (3 * (n_of_several - several)) : differences / (3 * pairs);
  // White noise of variance s2 leaves s2 (slots - 1) per axis in the counted scatter between slots.
  const float expected = 3 * motion.white_g2 * static_cast<float>(filled_in_hold - 1);
  motion.whiteness = expected > 0 ? between / expected : (between > 0 ? 1e6F : 1.0F);

  const float centre_s = g1 / g0;
  const float spread = g2 - g1 * centre_s;
  const Eigen::Vector3f slope = (m1 - centre_s * m0) / spread;
  motion.slope_variance_s2 = std::max(0.0F, v2 - 2 * centre_s * v1 + centre_s * centre_s * v0) / (spread * spread);
  // Only the component perpendicular to gravity turns it.
  const float norm2 = motion.mean_g.squaredNorm();
  const float along = norm2 > 0 ? slope.dot(motion.mean_g) : 0;
  motion.turn_rad2_s2 = std::max(0.0F, slope.squaredNorm() - (norm2 > 0 ? along * along / norm2 : 0));

  const Eigen::Vector3f up = norm2 > 0 ? Eigen::Vector3f(motion.mean_g / std::sqrt(norm2)) : Eigen::Vector3f::Zero();
  const std::size_t batch = window.drift_slots / kBatches;
  LineResiduals of_slots(up), of_batches(up);
  Eigen::Vector3f in_batch = Eigen::Vector3f::Zero();
  float count_in_batch = 0;
  for (std::size_t k = 0; k < window.drift_slots; ++k) {
    const CellSlot& slot = slots[(window.newest + kSlots - k) % kSlots];
    if (slot.count > 0) {
      const Eigen::Vector3f residual =
          slot.count * (slot.mean_g - base - m0 / g0 - (window.time_s[k] - centre_s) * slope);
      of_slots.add(residual, slot.count);
      in_batch += residual;
      count_in_batch += slot.count;
    }
    const bool is_last = k + 1 == window.drift_slots;
    if (is_last || ((k + 1) % batch == 0 && k + batch < window.drift_slots)) {
      of_batches.add(in_batch, count_in_batch);
      in_batch.setZero();
      count_in_batch = 0;
    }
  }
  motion.residual_g2 = of_slots.variance_g2();
  if (batch > 1 && of_batches.count() > 2 && motion.residual_g2 > 0) {
    motion.colour = of_batches.variance_g2() / motion.residual_g2;
  }
  return motion;
}

}  // namespace hexoderm
