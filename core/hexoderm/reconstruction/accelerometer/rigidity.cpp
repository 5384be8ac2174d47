#include "hexoderm/reconstruction/accelerometer/rigidity.h"

#include "hexoderm/geometry/se3.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {

double Misfit::deviate() const {
  if (degrees <= 0) return 0;
  const double spread = 2 / (9 * degrees);
  return (std::cbrt(chi_squared / degrees) - (1 - spread)) / std::sqrt(spread);
}

Eigen::Matrix3d attitudeInformation(const AccelerometerFit& fit, std::span<const Eigen::Vector3d> v_g) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  std::array<Eigen::Matrix<double, 4, 3>, 3> mixed;
  for (auto& block : mixed) block.setZero();
  for (std::size_t k = 0; k < v_g.size(); ++k) {
    const Eigen::Vector4d row(1, v_g[k].x(), v_g[k].y(), v_g[k].z());
    const Eigen::Matrix3d J = fit.gain * skew(v_g[k]);
    information.noalias() += fit.precision[k] * J.transpose() * J;
    for (int axis = 0; axis < 3; ++axis) {
      mixed[static_cast<std::size_t>(axis)].noalias() += fit.precision[k] * row * J.row(axis);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix<double, 4, 3> root = fit.covariance_root[axis].transpose() * mixed[axis];
    information.noalias() -= root.transpose() * root;
  }
  return information;
}

Misfit testRigidity(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                    std::span<const Eigen::Vector3d> v_g) {
  Misfit misfit;
  if (readings.size() < 2) return misfit;
  AccelerometerFit fit;
  fitAccelerometer(prior, readings, v_g, HuberLoss{std::numeric_limits<double>::infinity()}, fit);

  Eigen::Matrix3d information = attitudeInformation(fit, v_g);
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < readings.size(); ++k) {
    gradient.noalias() += fit.precision[k] * (fit.gain * skew(v_g[k])).transpose() * fit.residual_g[k];
  }
  // A turn that no reading shows takes nothing away; the smallest information keeps the algebra finite.
  information.diagonal().array() += 1e-6;
  misfit.chi_squared = std::max(0.0, 2 * fit.cost - gradient.dot(information.ldlt().solve(gradient)));
  misfit.degrees = 3 * static_cast<double>(readings.size()) - 3;
  return misfit;
}

Accelerometer pairOf(const Accelerometer& accelerometer) {
  // The neighbour's gains act in its own, turned axes: a part of its scale errors appears as cross-axis sensitivity.
  // The shares are those of a turn of 60 degrees about z, the commonest in a hexagonal skin.
  constexpr double kScaleKept = 0.75;
  constexpr double kScaleTurned = 0.25;
  const double scale_sq = accelerometer.scale_sigma * accelerometer.scale_sigma;
  Accelerometer pair = accelerometer;
  pair.offset_sigma_g = std::sqrt(2.0) * accelerometer.offset_sigma_g;
  pair.scale_sigma = std::sqrt((1 + kScaleKept) * scale_sq);
  pair.cross_axis_sigma =
      std::sqrt(2 * accelerometer.cross_axis_sigma * accelerometer.cross_axis_sigma + kScaleTurned * scale_sq);
  return pair;
}

}  // namespace hexoderm
