#pragma once

#include "hexoderm/skin/cell_model.h"

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace hexoderm {

/// A Huber loss on squared residuals in standard deviations, as Ceres has it: rho(s) = s up to the square of the
/// threshold, then 2 k sqrt(s) - k^2.
struct HuberLoss {
  double threshold = 3;
  [[nodiscard]] double cost(double squared) const;
  /// d rho / d s: what an iteratively reweighted least squares multiplies the residual's precision by.
  [[nodiscard]] double weight(double squared) const;
};

/// Model of an uncalibrated accelerometer that reads a specific force v in its own axes: y = (I + D) v + b + noise,
/// with b and the elements of D normal about 0 with the cell model's sigmas of a chip's own errors. Readings are those
/// without the lot's errors (SensorLot).
class AccelerometerPrior {
 public:
  /// `more_g2`: of the offset's variance, per axis.
  explicit AccelerometerPrior(const Accelerometer& accelerometer,
                              const Eigen::Vector3d& more_g2 = Eigen::Vector3d::Zero());
  /// Prior precisions of (b_i, D_i0, D_i1, D_i2), the parameters that axis i reads through.
  [[nodiscard]] const Eigen::Vector4d& precision(int axis) const { return precision_[static_cast<std::size_t>(axis)]; }

 private:
  std::array<Eigen::Vector4d, 3> precision_;
};

/// One cell's mean reading in one pose.
struct CellReading {
  std::size_t pose = 0;    ///< index into the poses of the patch
  Eigen::Vector3d y_g;     ///< accelerometer axes
  double variance_g2 = 0;  ///< per axis, > 0
};

/// What the errors of all chips of a lot have in common: a chip with the offset b and the gain I + D of its own reads
/// scale (I + D) v + b + offset_g of a specific force v. Gains are multiplied, so that a larger force under a smaller
/// scale says the same of a chip; offsets and noise are not.
struct SensorLot {
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();
  double scale = 1;
  /// The chips as without() leaves their readings: of the gain I + scale D.
  [[nodiscard]] Accelerometer chips(Accelerometer of) const {
    of.scale_sigma *= scale;
    of.cross_axis_sigma *= scale;
    return of;
  }
  /// The gain of a chip from what it is without the lot.
  [[nodiscard]] Eigen::Matrix3d gain(const Eigen::Matrix3d& without_lot) const {
    return without_lot + (scale - 1) * Eigen::Matrix3d::Identity();
  }
  /// The reading without the lot's offset, and with a scale of 1.
  [[nodiscard]] CellReading without(const CellReading& reading, const Eigen::Vector3d& v_g) const {
    return {reading.pose, reading.y_g - offset_g - (scale - 1) * v_g, reading.variance_g2};
  }
  /// The reading that the chip's own errors alone would give, to their first order.
  [[nodiscard]] CellReading without(const CellReading& reading) const {
    return {reading.pose, (reading.y_g - offset_g) / scale, reading.variance_g2 / (scale * scale)};
  }
};

/// L with L L^T = the inverse of a positive definite matrix.
Eigen::Matrix4d rootOfInverse(const Eigen::Matrix4d& matrix);

/// The most probable offset, scale and cross-axis errors of one accelerometer for given specific forces, and what that
/// leaves unexplained. Placements are estimated with these errors eliminated (variable projection), so that a skin of
/// any size has six unknowns a cell and few poses are safe: what the data don't say about a sensor, the prior says.
struct AccelerometerFit {
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();  ///< b
  Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();  ///< I + D
  std::vector<Eigen::Vector3d> residual_g;             ///< y - gain v - b, per reading
  std::vector<double> precision;                       ///< per reading and axis, robust weight included, 1/g^2
  /// Per axis, L with L L^T = posterior covariance of (b_i, D_i).
  std::array<Eigen::Matrix4d, 3> covariance_root;
  double cost = 0;  ///< half of: losses of all readings and the prior's squared deviations
};

/// `v_g`: the specific force per reading in the accelerometer's axes. Result is reused to avoid allocations.
void fitAccelerometer(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                      std::span<const Eigen::Vector3d> v_g, const HuberLoss& loss, AccelerometerFit& fit);

}  // namespace hexoderm
