#pragma once

// Private to capture/: samples and device-side means pooled into one mean with its covariance.

#include "hexoderm/capture/pose_capture.h"

namespace hexoderm {

/// Welford's update (one pass, no cancellation) and its extension to batches by Chan, Golub and LeVeque (1983).
class GravityAccumulator {
 public:
  /// `sample_g` must be finite.
  void add(const Eigen::Vector3d& sample_g) {
    const double before = count_++;
    const Eigen::Vector3d difference = sample_g - mean_g_;
    mean_g_ += difference / count_;
    addScatter(before / count_, difference);
  }

  /// `mean` must be finite, and stand for one sample at least.
  void add(const CellMean& mean) {
    const double before = count_;
    const double added = mean.count;
    count_ += mean.count;
    const Eigen::Vector3d difference = mean.mean_g - mean_g_;
    mean_g_ += difference * (added / count_);
    addScatter(before * added / count_, difference);
    for (int axis = 0; axis < 3; ++axis) scatter_g2_(axis, axis) += (added - 1) * mean.variance_g2(axis);
  }

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] const Eigen::Vector3d& mean_g() const { return mean_g_; }

  [[nodiscard]] GravitySample sample(CellId cell) const {
    GravitySample sample{cell, mean_g_, Eigen::Matrix3d::Zero(), count_};
    if (count_ > 1) {
      const double n = count_;
      sample.cov_g2 = Eigen::Matrix3d(scatter_g2_.selfadjointView<Eigen::Upper>()) / (n * (n - 1));
    }
    return sample;
  }

 private:
  void addScatter(double factor, const Eigen::Vector3d& difference) {
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row <= column; ++row) {
        scatter_g2_(row, column) += factor * difference(row) * difference(column);
      }
    }
  }

  std::uint32_t count_ = 0;
  Eigen::Vector3d mean_g_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter_g2_ = Eigen::Matrix3d::Zero();  ///< upper triangle
};

/// Whether a device's mean can be used: finite, not of nothing, no negative variance.
inline bool isUsable(const CellMean& mean) {
  return mean.count > 0 && mean.mean_g.allFinite() && mean.variance_g2.allFinite() && mean.variance_g2.minCoeff() >= 0;
}

}  // namespace hexoderm
