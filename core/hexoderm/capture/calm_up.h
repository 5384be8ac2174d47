#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>

namespace hexoderm {

/// Where up is on a part that is held, for a picture: follows large moves at once and small ones by the mean of the
/// last readings, and rests while the part is held still, so that a hand's tremor neither moves the picture nor has it
/// drawn again and again. What is shown at rest is within kMovesOn_rad of that mean.
class CalmUp {
 public:
  static constexpr double kMovesOn_rad = 1.0 * kDegree;  ///< a mean over tremor is never that far off

  /// The unit vector that is shown from now on, as up is `up_o` by the newest readings, which come about 20 times a
  /// second; none: not known.
  std::optional<Eigen::Vector3d> follow(const std::optional<Eigen::Vector3d>& up_o) {
    if (!up_o || !shown_o_) {
      shown_o_ = up_o;
      mean_o_ = up_o.value_or(mean_o_);
      rests_ = false;
      return shown_o_;
    }
    if (comesToRest(*up_o)) return shown_o_;
    const double part = std::max(kMinPart, angleBetween(*shown_o_, mean_o_) / kAtOnce_rad);
    shown_o_ =
        part >= 1
            ? mean_o_
            : Eigen::Vector3d(expSO3(part * logSO3(shortestRotation(*shown_o_, mean_o_))) * *shown_o_).normalized();
    return shown_o_;
  }

 private:
  static constexpr double kAtOnce_rad = 4 * kDegree;
  static constexpr double kMinPart = 0.5;                // of the way, with every reading
  static constexpr double kNewest = 0.3;                 // the newest reading's share of the mean
  static constexpr double kSettled_rad = 0.3 * kDegree;  // a pixel or two at the edge of a part that fills a view

  bool comesToRest(const Eigen::Vector3d& up_o) {
    const bool jumps = angleBetween(mean_o_, up_o) > kAtOnce_rad;
    mean_o_ = jumps ? up_o : (mean_o_ + kNewest * (up_o - mean_o_)).normalized();
    rests_ = !jumps && angleBetween(*shown_o_, mean_o_) < (rests_ ? kMovesOn_rad : kSettled_rad);
    return rests_;
  }

  std::optional<Eigen::Vector3d> shown_o_;
  Eigen::Vector3d mean_o_ = Eigen::Vector3d::UnitZ();  ///< of the last readings, the newer the more; one after a jump
  bool rests_ = false;
};

}  // namespace hexoderm
