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

namespace {

constexpr double kLeastInformation = 1e-6;  // a turn that no reading shows takes nothing away, and the algebra is finite

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Gradient and information of half the misfit to a small turn e of the cell in all poses and a further one from the
/// reading `split` on. R_a_o becomes exp(-e) R_a_o, so v becomes v + v x e.
void linearizeTurns(const AccelerometerFit& fit, std::span<const Eigen::Vector3d> v_g, std::size_t split,
                    Vector6& gradient, Matrix6& information) {
  gradient.setZero();
  information.setZero();
  std::array<Eigen::Matrix<double, 4, 6>, 3> mixed;
  for (auto& block : mixed) block.setZero();
  for (std::size_t k = 0; k < v_g.size(); ++k) {
    const Eigen::Vector4d row(1, v_g[k].x(), v_g[k].y(), v_g[k].z());
    Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();  // of the residual
    J.leftCols<3>() = -fit.gain * skew(v_g[k]);
    if (k >= split) J.rightCols<3>() = J.leftCols<3>();
    gradient.noalias() += fit.precision[k] * J.transpose() * fit.residual_g[k];
    information.noalias() += fit.precision[k] * J.transpose() * J;
    for (int axis = 0; axis < 3; ++axis) {
      mixed[static_cast<std::size_t>(axis)].noalias() += fit.precision[k] * row * J.row(axis);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix<double, 4, 6> root = fit.covariance_root[axis].transpose() * mixed[axis];
    information.noalias() -= root.transpose() * root;
  }
  information.diagonal().array() += kLeastInformation;
}

}  // namespace

TurnBetweenPoses findTurn(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                          std::span<const Eigen::Vector3d> v_g, const AttitudePrior& attitude) {
  TurnBetweenPoses best;
  AccelerometerFit fit;
  fitAccelerometer(prior, readings, v_g, HuberLoss{std::numeric_limits<double>::infinity()}, fit);
  for (std::size_t split = 1; split < readings.size(); ++split) {
    Vector6 gradient;
    Matrix6 information;
    linearizeTurns(fit, v_g, split, gradient, information);
    gradient.head<3>() -= attitude.weighted;
    information.topLeftCorner<3, 3>() += attitude.information;
    const Eigen::Vector3d rigid = gradient.head<3>();
    const Vector6 step = -information.ldlt().solve(gradient);
    const double with = -gradient.dot(step);
    const double without = rigid.dot(information.topLeftCorner<3, 3>().ldlt().solve(rigid));
    // One pose shows two of three angles.
    const bool one_side_is_single = split == 1 || split + 1 == readings.size();
    const Misfit gain{std::max(0.0, with - without), one_side_is_single ? 2.0 : 3.0};
    if (best.first_after != 0 && gain.deviate() <= best.gain.deviate()) continue;
    best = {split, step.tail<3>().norm(), gain};
  }
  return best;
}

OwnAttitude findAttitude(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                         std::span<const Eigen::Vector3d> f_o, const Eigen::Matrix3d& R_start) {
  constexpr int kSteps = 15;
  constexpr double kConverged = 1e-7;
  constexpr double kLargestStep = 0.5;
  OwnAttitude own;
  own.R = R_start;
  AccelerometerFit& fit = own.sensor;
  std::vector<Eigen::Vector3d> v_g(readings.size());
  for (int k = 0; k < kSteps; ++k) {
    for (std::size_t reading = 0; reading < readings.size(); ++reading) v_g[reading] = own.R.transpose() * f_o[reading];
    fitAccelerometer(prior, readings, v_g, HuberLoss{std::numeric_limits<double>::infinity()}, fit);
    Vector6 gradient;
    Matrix6 information;
    linearizeTurns(fit, v_g, readings.size(), gradient, information);
    own.information = attitudeInformation(fit, v_g);
    // v + v x e is the force in a cell that is turned by e.
    Eigen::Vector3d step = information.topLeftCorner<3, 3>().ldlt().solve(gradient.head<3>());
    if (step.norm() > kLargestStep) step *= kLargestStep / step.norm();
    own.R *= expSO3(-step);
    if (step.norm() < kConverged) break;
  }
  return own;
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
  information.diagonal().array() += kLeastInformation;
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
