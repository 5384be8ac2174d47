#pragma once

#include "hexoderm/solve/global/accelerometer_fit.h"

#include <Eigen/Core>
#include <span>

namespace hexoderm {

/// Parameters of one accelerometer's errors: (b_i, D_i0, D_i1, D_i2) of the axes i = 0, 1, 2, one after the other.
inline constexpr Eigen::Index kSensorParameters = 12;

/// The kinds of a sensor's errors, each with one sigma in the cell model.
enum class SensorError { Offset, Scale, CrossAxis };
inline constexpr std::size_t kSensorErrors = 3;
/// Of the parameter `index` of a sensor.
SensorError kindOfParameter(Eigen::Index index);

/// What readings say about the errors x of some accelerometers, kSensorParameters each, all else being unknown and
/// nothing granted beforehand: near its peak the likelihood is exp(-x^T M x / 2 + h^T x), with
/// M = `information` (positive semidefinite, often singular) and h = `weighted`, M times the most likely errors. Over
/// all readings that there could be, and x normal about 0 with covariance L, h is normal about 0 with M + M L M.
struct SensorEvidence {
  Eigen::MatrixXd information;  ///< 12 n x 12 n
  Eigen::VectorXd weighted;     ///< 12 n

  [[nodiscard]] std::size_t sensors() const { return static_cast<std::size_t>(weighted.size() / kSensorParameters); }
};

/// The same, under a prior of covariance L (diagonal): `precision` = (M^-1 + L)^-1, the inverse covariance that the
/// most likely errors have about 0, and `weighted`, that times these errors. With the posterior mean m and covariance C
/// of the errors, weighted = L^-1 m and precision = L^-1 (L - C) L^-1.
struct WeighedEvidence {
  Eigen::MatrixXd precision;
  Eigen::VectorXd weighted;
};
/// `prior`: the diagonal of L, >= 0.
WeighedEvidence weigh(const SensorEvidence& evidence, const Eigen::VectorXd& prior);
/// The diagonal of L by the sigmas of `accelerometer`, for `sensors` sensors.
Eigen::VectorXd priorVariances(const Accelerometer& accelerometer, std::size_t sensors);

/// What one cell's readings say about its sensor, of the specific forces `v_g` (accelerometer axes, per reading), when
/// nothing is known of how the cell is turned. To first order in the turn.
SensorEvidence ownEvidence(std::span<const CellReading> readings, std::span<const Eigen::Vector3d> v_g);

}  // namespace hexoderm
