#include "hexoderm/solve/global/pose_angular_accelerations.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/tree/gravity_table.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace hexoderm {
namespace {

/// d (force at the cell) / d (angular acceleration), g s^2: a x l = -[l]x a.
Eigen::Matrix3d leverMatrix(const GlobalState& state, std::size_t cell) {
  return -skew(state.cells[cell].t - state.middle_o) / kStandardGravity;
}

Eigen::Matrix3d readingPerForce(const GlobalProblem& problem, const GlobalState& state, std::size_t cell,
                                const AccelerometerFit& sensor) {
  return state.lot.gain(sensor.gain) * problem.model->accelerometer.T_u_a.R.transpose() *
         state.cells[cell].R.transpose();
}

}  // namespace

double accelerationSpread(const std::vector<Eigen::Vector3d>& accelerations,
                          const std::vector<Eigen::Matrix3d>& covariances) {
  constexpr double kWeightOfTremor = 10;
  double squared = kWeightOfTremor * kTremorAcceleration_rad_s2 * kTremorAcceleration_rad_s2;
  for (std::size_t pose = 0; pose < accelerations.size(); ++pose) {
    squared += accelerations[pose].squaredNorm() + covariances[pose].trace();
  }
  return std::sqrt(squared / (kWeightOfTremor + 3 * static_cast<double>(accelerations.size())));
}

PoseAngularAccelerations PoseAngularAccelerations::unknown(std::size_t poses, double sigma) {
  return {std::vector<Eigen::Vector3d>(poses, Eigen::Vector3d::Zero()),
          std::vector<Eigen::Matrix3d>(poses, sigma * sigma * Eigen::Matrix3d::Identity()),
          std::vector<Eigen::Vector3d>(poses, Eigen::Vector3d::Zero())};
}

double PoseAngularAccelerations::distanceTo(const PoseAngularAccelerations& other) const {
  if (acceleration_o.empty()) return 0;
  double squared = 0;
  for (std::size_t pose = 0; pose < acceleration_o.size(); ++pose) {
    squared += (acceleration_o[pose] - other.acceleration_o[pose]).squaredNorm();
  }
  return std::sqrt(squared / static_cast<double>(3 * acceleration_o.size()));
}

PoseAngularAccelerations findAngularAccelerations(const GlobalProblem& problem, const GlobalState& state,
                                                  std::span<const SensorState> sensors,
                                                  const PoseAngularAccelerations& now, double sigma) {
  using Matrix = Eigen::Matrix<double, 6, 6>;  // force, then acceleration
  using Vector = Eigen::Matrix<double, 6, 1>;
  std::vector<Matrix> information(problem.poses, Matrix::Zero());
  std::vector<Vector> right(problem.poses, Vector::Zero());
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    const AccelerometerFit& sensor = sensors[cell].fit;
    Eigen::Matrix<double, 3, 6> J;
    J.leftCols<3>() = readingPerForce(problem, state, cell, sensor);
    J.rightCols<3>() = J.leftCols<3>() * leverMatrix(state, cell);
    for (std::size_t k = 0; k < problem.readings[cell].size(); ++k) {
      const std::size_t pose = problem.readings[cell][k].pose;
      information[pose].noalias() += sensor.precision[k] * J.transpose() * J;
      right[pose].noalias() += sensor.precision[k] * J.transpose() * sensor.residual_g[k];
    }
  }
  PoseAngularAccelerations swings = PoseAngularAccelerations::unknown(problem.poses, sigma);
  const double prior = 1 / (sigma * sigma);
  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    if (information[pose].isZero()) continue;
    information[pose].diagonal().tail<3>().array() += prior;
    right[pose].tail<3>() -= prior * now.acceleration_o[pose];
    const Eigen::LDLT<Matrix> factor(information[pose]);
    const Vector change = factor.solve(right[pose]);
    if (factor.info() != Eigen::Success || !change.allFinite()) continue;
    swings.force_change_o[pose] = change.head<3>();
    swings.acceleration_o[pose] = now.acceleration_o[pose] + change.tail<3>();
    const Matrix covariance = factor.solve(Matrix::Identity());
    swings.covariance[pose] = covariance.bottomRightCorner<3, 3>();
  }
  return swings;
}

AngularAccelerationInReading swingInReading(const GlobalProblem& problem, const GlobalState& state, std::size_t cell,
                                            const AccelerometerFit& sensor, const PoseAngularAccelerations& swings,
                                            std::size_t pose) {
  const Eigen::Matrix3d lever = leverMatrix(state, cell);
  return {readingPerForce(problem, state, cell, sensor) * (lever * swings.acceleration_o[pose]),
          (lever * swings.covariance[pose] * lever.transpose()).trace() / 3};
}

}  // namespace hexoderm
