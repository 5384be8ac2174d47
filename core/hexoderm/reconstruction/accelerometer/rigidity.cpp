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

constexpr double kLeastInformation =
    1e-6;  // a turn that no reading shows takes nothing away, and the algebra is finite

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

void RigidityTest::add(const CellReading& reading, const Eigen::Vector3d& v_g) { count(reading, v_g, 1); }
void RigidityTest::remove(const CellReading& reading, const Eigen::Vector3d& v_g) { count(reading, v_g, -1); }

void RigidityTest::count(const CellReading& reading, const Eigen::Vector3d& v_g, double sign) {
  const double precision = sign / reading.variance_g2;
  const Eigen::Vector4d row(1, v_g.x(), v_g.y(), v_g.z());
  const Eigen::Vector3d error = reading.y_g - v_g;
  readings_ += sign;
  rows_.noalias() += precision * row * row.transpose();
  mixed_.noalias() += precision * row * error.transpose();
  errors_ += precision * error.squaredNorm();
}

Misfit RigidityTest::misfit() const {
  Misfit misfit;
  if (readings_ < 2) return misfit;
  // The sensor's errors (b_i, D_i), one axis in a column, and what a turn of the cell changes beyond them.
  Eigen::Matrix<double, 4, 3> errors;
  std::array<Eigen::LLT<Eigen::Matrix4d>, 3> factors;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::LLT<Eigen::Matrix4d>& factor = factors[static_cast<std::size_t>(axis)];
    Eigen::Matrix4d with_prior = rows_;
    with_prior.diagonal() += prior_.precision(axis);
    factor.compute(with_prior);
    errors.col(axis) = factor.solve(mixed_.col(axis));
  }
  const double twice_cost = errors_ - errors.cwiseProduct(mixed_).sum();
  const Eigen::Matrix3d gain = Eigen::Matrix3d::Identity() + errors.bottomRows<3>().transpose();
  const Eigen::Matrix<double, 4, 3> left = mixed_ - rows_ * errors;  // sum of w r e^T, e: residuals
  const Eigen::Matrix3d pull = left.bottomRows<3>() * gain;
  const Eigen::Vector3d gradient(pull(2, 1) - pull(1, 2), pull(0, 2) - pull(2, 0), pull(1, 0) - pull(0, 1));
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    // d residual / d turn = r^T J.
    Eigen::Matrix<double, 4, 3> J = Eigen::Matrix<double, 4, 3>::Zero();
    J.bottomRows<3>() = skew(gain.row(axis).transpose());
    const Eigen::Matrix<double, 4, 3> weighted = rows_ * J;
    information +=
        J.transpose() * weighted - weighted.transpose() * factors[static_cast<std::size_t>(axis)].solve(weighted);
  }
  information.diagonal().array() += kLeastInformation;
  misfit.chi_squared = std::max(0.0, twice_cost - gradient.dot(information.ldlt().solve(gradient)));
  misfit.degrees = 3 * readings_ - 3;
  return misfit;
}

Misfit testRigidity(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                    std::span<const Eigen::Vector3d> v_g) {
  RigidityTest test(prior);
  for (std::size_t k = 0; k < readings.size(); ++k) test.add(readings[k], v_g[k]);
  return test.misfit();
}

RigidityKernelOptions rigidityKernelOptions(const AccelerometerPrior& prior, const Eigen::Matrix3d& R_a_u) {
  RigidityKernelOptions options{};
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) options.precision[4 * axis + k] = prior.precision(axis)[k];
    for (int k = 0; k < 3; ++k) options.R_a_u[3 * axis + k] = R_a_u(axis, k);
  }
  options.least_information = kLeastInformation;
  return options;
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
