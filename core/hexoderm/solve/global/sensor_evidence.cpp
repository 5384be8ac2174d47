#include "hexoderm/solve/global/sensor_evidence.h"

#include "hexoderm/base/se3.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace hexoderm {
namespace {

double sigmaOf(const Accelerometer& accelerometer, SensorError kind) {
  if (kind == SensorError::Offset) return accelerometer.largestOffsetSigma_g();
  return kind == SensorError::Scale ? accelerometer.scale_sigma : accelerometer.cross_axis_sigma;
}

}  // namespace

SensorError kindOfParameter(Eigen::Index index) {
  const Eigen::Index axis = (index % kSensorParameters) / 4;
  const Eigen::Index of_axis = index % 4;
  if (of_axis == 0) return SensorError::Offset;
  return of_axis == axis + 1 ? SensorError::Scale : SensorError::CrossAxis;
}

namespace {

/// `kParameters`: of all sensors, where the compiler is to know it.
template <int kParameters>
WeighedEvidence weighParameters(const SensorEvidence& evidence, const Eigen::VectorXd& prior) {
  using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
  using Vector = Eigen::Matrix<double, kParameters, 1>;
  // With L = R R: (M^-1 + L)^-1 = M - M R (1 + R M R)^-1 R M, for singular M and L too.
  const Matrix information = evidence.information;
  const Vector root = prior.cwiseSqrt();
  Matrix left = root.asDiagonal() * information;
  Matrix inner = left * root.asDiagonal();
  inner.diagonal().array() += 1;
  const Eigen::LLT<Matrix> factor(inner);
  factor.matrixL().solveInPlace(left);
  Vector right = root.cwiseProduct(evidence.weighted);
  factor.matrixL().solveInPlace(right);
  Matrix precision = information;
  precision.noalias() -= left.transpose() * left;
  return {precision, evidence.weighted - left.transpose() * right};
}

}  // namespace

WeighedEvidence weigh(const SensorEvidence& evidence, const Eigen::VectorXd& prior) {
  return evidence.sensors() == 1 ? weighParameters<kSensorParameters>(evidence, prior)
                                 : weighParameters<Eigen::Dynamic>(evidence, prior);
}

Eigen::VectorXd priorVariances(const Accelerometer& accelerometer, std::size_t sensors) {
  Eigen::VectorXd variances(static_cast<Eigen::Index>(sensors) * kSensorParameters);
  for (Eigen::Index k = 0; k < variances.size(); ++k) {
    variances[k] = std::pow(sigmaOf(accelerometer, kindOfParameter(k)), 2);
  }
  return variances;
}

SensorEvidence ownEvidence(std::span<const CellReading> readings, std::span<const Eigen::Vector3d> v_g) {
  // A reading's error is y - v = x + n for an axis's errors by (1, v), and a turn e of the cell adds v x e to v.
  constexpr double kMinTurnInformation = 1e-6;  // of a turn that no reading shows
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
  SensorEvidence evidence{Eigen::MatrixXd::Zero(kSensorParameters, kSensorParameters),
                          Eigen::VectorXd::Zero(kSensorParameters)};
  Eigen::Matrix3d turns = kMinTurnInformation * Eigen::Matrix3d::Identity();
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, kSensorParameters, 3> mixed = Eigen::Matrix<double, kSensorParameters, 3>::Zero();
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const double precision = 1 / readings[k].variance_g2;
    const Eigen::Vector4d row(1, v_g[k].x(), v_g[k].y(), v_g[k].z());
    const Eigen::Vector3d error = readings[k].y_g - v_g[k];
    const Eigen::Matrix3d J = skew(v_g[k]);
    rows.noalias() += precision * row * row.transpose();
    turns.noalias() += precision * J.transpose() * J;
    turned.noalias() += precision * J.transpose() * error;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      evidence.weighted.segment<4>(4 * axis).noalias() += precision * error[axis] * row;
      mixed.middleRows<4>(4 * axis).noalias() += precision * row * J.row(axis);
    }
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) evidence.information.block<4, 4>(4 * axis, 4 * axis) = rows;
  const Eigen::LDLT<Eigen::Matrix3d> factor(turns);
  evidence.information -= mixed * factor.solve(mixed.transpose());
  evidence.weighted -= mixed * factor.solve(turned);
  return evidence;
}

}  // namespace hexoderm
