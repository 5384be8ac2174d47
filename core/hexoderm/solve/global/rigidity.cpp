#include "hexoderm/solve/global/rigidity.h"

#include "hexoderm/base/se3.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

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

constexpr double kMinInformation = 1e-6;  // a turn that no reading shows takes nothing away, and the algebra is finite

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The most probable errors of a sensor, and what a small turn e of its cell changes beyond them. R_a_o becomes
/// exp(-e) R_a_o, so v becomes v + v x e, and the residual of axis i changes by r^T J_i e.
struct SensorAndTurn {
  Eigen::Matrix<double, 4, 3> errors;              ///< (b_i, D_i), one axis in a column
  std::array<Eigen::Matrix4d, 3> covariance_root;  ///< of these, as in AccelerometerFit
  Eigen::Matrix3d gain;
  std::array<Eigen::Matrix<double, 4, 3>, 3> J;
  Eigen::Vector3d gradient;     ///< of half the misfit
  Eigen::Matrix3d information;  ///< the errors eliminated
};

/// Sum of r e^T / V, with the residuals e.
Eigen::Matrix<double, 4, 3> residualsOf(const ReadingSums& sums, const Eigen::Matrix<double, 4, 3>& errors) {
  return sums.mixed - sums.rows * errors;
}

Eigen::Vector3d gradientOf(const ReadingSums& sums, const SensorAndTurn& solved) {
  const Eigen::Matrix3d pull = residualsOf(sums, solved.errors).bottomRows<3>() * solved.gain;
  return {pull(1, 2) - pull(2, 1), pull(2, 0) - pull(0, 2), pull(0, 1) - pull(1, 0)};
}

SensorAndTurn solveSensorAndTurn(const AccelerometerPrior& prior, const ReadingSums& sums) {
  SensorAndTurn solved;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix4d& root = solved.covariance_root[static_cast<std::size_t>(axis)];
    Eigen::Matrix4d with_prior = sums.rows;
    with_prior.diagonal() += prior.precision(axis);
    root = rootOfInverse(with_prior);
    solved.errors.col(axis) = root * (root.transpose() * sums.mixed.col(axis));
  }
  solved.gain = Eigen::Matrix3d::Identity() + solved.errors.bottomRows<3>().transpose();
  solved.gradient = gradientOf(sums, solved);
  solved.information.setZero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Eigen::Matrix<double, 4, 3>& J = solved.J[axis];
    J.setZero();
    J.bottomRows<3>() = skew(solved.gain.row(static_cast<Eigen::Index>(axis)).transpose());
    const Eigen::Matrix<double, 4, 3> weighted = sums.rows * J;
    const Eigen::Matrix<double, 4, 3> explained = solved.covariance_root[axis].transpose() * weighted;
    solved.information += J.transpose() * weighted - explained.transpose() * explained;
  }
  return solved;
}

double twiceCost(const ReadingSums& sums, const SensorAndTurn& solved) {
  return sums.errors - solved.errors.cwiseProduct(sums.mixed).sum();
}

/// Information about a turn e in all poses and a further one in those that `after` has the sums of.
Matrix6 informationAboutTwoTurns(const ReadingSums& all, const ReadingSums& after, const SensorAndTurn& solved) {
  Matrix6 information = Matrix6::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix<double, 4, 3>& J = solved.J[axis];
    Eigen::Matrix<double, 4, 6> weighted;
    weighted << all.rows * J, after.rows * J;
    information.topRows<3>() += J.transpose() * weighted;
    information.bottomRightCorner<3, 3>() += J.transpose() * weighted.rightCols<3>();
    const Eigen::Matrix<double, 4, 6> explained = solved.covariance_root[axis].transpose() * weighted;
    information -= explained.transpose() * explained;
  }
  // Only its upper right was summed up.
  information.bottomLeftCorner<3, 3>() = information.topRightCorner<3, 3>().transpose();
  information.diagonal().array() += kMinInformation;
  return information;
}

}  // namespace

void ReadingSums::add(const CellReading& reading, const Eigen::Vector3d& v_g, double sign) {
  const double precision = sign / reading.variance_g2;
  const Eigen::Vector4d row(1, v_g.x(), v_g.y(), v_g.z());
  const Eigen::Vector3d error = reading.y_g - v_g;
  readings += sign;
  rows.noalias() += precision * row * row.transpose();
  mixed.noalias() += precision * row * error.transpose();
  errors += precision * error.squaredNorm();
}

TurnBetweenPoses findTurn(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                          std::span<const Eigen::Vector3d> v_g, const AttitudePrior& attitude, double least_gain) {
  TurnBetweenPoses best;
  ReadingSums all;
  for (std::size_t k = 0; k < readings.size(); ++k) all.add(readings[k], v_g[k]);
  const SensorAndTurn solved = solveSensorAndTurn(prior, all);
  // Turns can't explain more than is left unexplained, of the readings and of what others say.
  const double unexplained =
      twiceCost(all, solved) + attitude.weighted.dot(attitude.information.ldlt().solve(attitude.weighted));
  if (unexplained < least_gain) return best;
  Vector6 gradient;
  gradient.head<3>() = solved.gradient - attitude.weighted;
  const Eigen::Matrix3d rigid =
      solved.information + attitude.information + kMinInformation * Eigen::Matrix3d::Identity();
  const double without = gradient.head<3>().dot(rigid.ldlt().solve(gradient.head<3>()));
  ReadingSums after = all;
  for (std::size_t split = 1; split < readings.size(); ++split) {
    after.add(readings[split - 1], v_g[split - 1], -1);
    gradient.tail<3>() = gradientOf(after, solved);
    Matrix6 information = informationAboutTwoTurns(all, after, solved);
    information.topLeftCorner<3, 3>() += attitude.information;
    const Vector6 step = -information.ldlt().solve(gradient);
    const double with = -gradient.dot(step);
    // One pose shows two of three angles.
    const bool one_side_is_single = split == 1 || split + 1 == readings.size();
    const Misfit gain{std::max(0.0, with - without), one_side_is_single ? 2.0 : 3.0};
    if (best.first_after != 0 && gain.deviate() <= best.gain.deviate()) continue;
    best = {split, step.tail<3>().norm(), gain};
  }
  return best;
}

OwnAttitude findAttitude(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                         std::span<const Eigen::Vector3d> f_o, const Eigen::Matrix3d& R_start, int most_steps) {
  constexpr double kConverged = 1e-9;
  constexpr double kLargestStep = 0.5;
  // With q = (1, f) and V the variances: sums of q q^T / V and of q y^T / V. In a cell with the attitude R the forces
  // are v = R^T f, and everything follows from these sums turned, however many readings there are.
  Eigen::Matrix4d forces = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 3> read = Eigen::Matrix<double, 4, 3>::Zero();
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Eigen::Vector4d row(1, f_o[k].x(), f_o[k].y(), f_o[k].z());
    const Eigen::Vector4d weighted = row / readings[k].variance_g2;
    forces.noalias() += weighted * row.transpose();
    read.noalias() += weighted * readings[k].y_g.transpose();
  }
  OwnAttitude own;
  own.R = R_start;
  Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
  for (int k = 0; k < most_steps; ++k) {
    turned.bottomRightCorner<3, 3>() = own.R.transpose();
    ReadingSums sums;
    sums.rows = turned * forces * turned.transpose();
    sums.mixed = turned * read - sums.rows.rightCols<3>();
    const SensorAndTurn solved = solveSensorAndTurn(prior, sums);
    own.information = solved.information;
    own.offset_g = solved.errors.row(0).transpose();
    own.gain = solved.gain;
    // v + v x e is the force in a cell that is turned by e.
    const Eigen::Matrix3d finite = solved.information + kMinInformation * Eigen::Matrix3d::Identity();
    Eigen::Vector3d step = finite.ldlt().solve(solved.gradient);
    if (step.norm() > kLargestStep) step *= kLargestStep / step.norm();
    own.R *= expSO3(-step);
    if (step.norm() < kConverged) break;
  }
  return own;
}

AttitudeKernelOptions attitudeKernelOptions(const AccelerometerPrior& prior) {
  AttitudeKernelOptions options{};
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) options.precision[4 * axis + k] = prior.precision(axis)[k];
  }
  options.min_information = kMinInformation;
  return options;
}

Misfit testRigidity(const AccelerometerPrior& prior, const ReadingSums& sums) {
  Misfit misfit;
  if (sums.readings < 2) return misfit;
  SensorAndTurn solved = solveSensorAndTurn(prior, sums);
  const double twice_cost = twiceCost(sums, solved);
  solved.information.diagonal().array() += kMinInformation;
  misfit.chi_squared =
      std::max(0.0, twice_cost - solved.gradient.dot(solved.information.ldlt().solve(solved.gradient)));
  misfit.degrees = 3 * sums.readings - 3;
  return misfit;
}

Misfit testRigidity(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                    std::span<const Eigen::Vector3d> v_g) {
  ReadingSums sums;
  for (std::size_t k = 0; k < readings.size(); ++k) sums.add(readings[k], v_g[k]);
  return testRigidity(prior, sums);
}

AccelerometerPrior pairPrior(const Accelerometer& accelerometer, const Eigen::Matrix3d& R_a_b) {
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
  return AccelerometerPrior(pair, accelerometer.sharedOffsetBetween_g2(R_a_b).diagonal().cwiseMax(0));
}

}  // namespace hexoderm
