#pragma once

// Samples and device-side means pooled into one mean with its covariance.

#include "hexoderm/base/limits.h"
#include "hexoderm/device/pose_capture.h"

#include <algorithm>

namespace hexoderm {

/// Welford's update (one pass, no cancellation) and its extension to batches by Chan, Golub and LeVeque (1983).
class GravityAccumulator {
 public:
  /// `sample_g` must be finite.
  void add(const Eigen::Vector3d& sample_g) {
    const auto before = static_cast<double>(count_++);
    const Eigen::Vector3d difference = sample_g - mean_g_;
    mean_g_ += difference / (before + 1);
    addScatter(before / (before + 1), difference);
  }

  /// `mean` must be finite, and stand for one sample at least.
  void add(const CellMean& mean) {
    const auto before = static_cast<double>(count_);
    const double added = mean.count;
    count_ += mean.count;
    const Eigen::Vector3d difference = mean.mean_g - mean_g_;
    mean_g_ += difference * (added / (before + added));
    addScatter(before * added / (before + added), difference);
    for (int axis = 0; axis < 3; ++axis) scatter_g2_(axis, axis) += (added - 1) * mean.variance_g2(axis);
  }

  /// Limited to 32 bits, although means may claim to be of more samples.
  [[nodiscard]] std::uint32_t count() const {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(count_, UINT32_MAX));
  }
  [[nodiscard]] const Eigen::Vector3d& mean_g() const { return mean_g_; }

  [[nodiscard]] GravitySample sample(CellId cell) const {
    GravitySample sample{cell, mean_g_, Eigen::Matrix3d::Zero(), count()};
    if (count_ > 1) {
      const auto n = static_cast<double>(count_);
      sample.cov_g2 = Eigen::Matrix3d(scatter_g2_.selfadjointView<Eigen::Upper>()) / (n * (n - 1));
    }
    return sample;
  }

 private:
  void addScatter(double factor, const Eigen::Vector3d& difference) {
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row <= column; ++row) scatter_g2_(row, column) += factor * difference(row) * difference(column);
    }
  }

  std::uint64_t count_ = 0;
  Eigen::Vector3d mean_g_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter_g2_ = Eigen::Matrix3d::Zero();  ///< upper triangle
};

/// Whether a sample can be used: it is finite and within the range of any accelerometer.
inline bool isUsable(const CellSample& sample) { return isWithin(sample.acceleration_g, kMaxAcceleration_g); }
/// The same for a mean, which also needs at least one sample and no negative variance.
inline bool isUsable(const CellMean& mean) {
  return mean.count > 0 && isWithin(mean.mean_g, kMaxAcceleration_g) &&
         isWithin(mean.variance_g2, kMaxAcceleration_g * kMaxAcceleration_g) && mean.variance_g2.minCoeff() >= 0;
}

}  // namespace hexoderm
