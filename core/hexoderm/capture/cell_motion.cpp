#include "hexoderm/capture/cell_motion.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Parts of the drift window whose means tell how slow noise is: of the periods that a slope of the window feels.
constexpr std::size_t kBatches = 5;

/// Deviations from a straight line, across gravity.
class Residuals {
 public:
  explicit Residuals(const Eigen::Vector3f& along) : along_(along) {}
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

}  // namespace

CellMotion motionOf(const CellSlots& slots, const SlotWindow& window, float steady_g) {
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
  Residuals of_slots(up), of_batches(up);
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
