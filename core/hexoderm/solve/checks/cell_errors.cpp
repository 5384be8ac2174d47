#include "hexoderm/solve/checks/cell_errors.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>

namespace hexoderm {
namespace {

/// The cross-axis sensitivities among the unknowns of a cell.
constexpr std::array<int, 6> kCrossAxis = {5, 6, 8, 10, 12, 13};

}  // namespace

CellJacobian readingJacobian(const Eigen::Matrix3d& gain, const Eigen::Vector3d& v) {
  CellJacobian J = CellJacobian::Zero();
  J.leftCols<3>() = gain * skew(v);
  for (int axis = 0; axis < 3; ++axis) {
    J(axis, 3 + 4 * axis) = 1;
    J.block<1, 3>(axis, 4 + 4 * axis) = v.transpose();
  }
  return J;
}

Eigen::Matrix3d elastomerInformation(const CellModel& model, std::span<const PortNumber> ports) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  for (const PortNumber port : ports) {
    const Eigen::Matrix3d axes = linkAxes(model.port(port));
    const Eigen::Vector3d sigma(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
    for (int k = 0; k < 3; ++k) {
      if (sigma[k] > 0) information += axes.col(k) * axes.col(k).transpose() / (sigma[k] * sigma[k]);
    }
  }
  const Eigen::Matrix3d& R_u_a = model.accelerometer.T_u_a.R;
  return R_u_a.transpose() * information * R_u_a;
}

CellErrors priorInformation(const AccelerometerPrior& sensor, const Eigen::Matrix3d& attitude) {
  CellErrors information = CellErrors::Zero();
  information.topLeftCorner<3, 3>() = attitude;
  for (int axis = 0; axis < 3; ++axis) information.diagonal().segment<4>(3 + 4 * axis) = sensor.precision(axis);
  return information;
}

CellErrors errorsOfCell(const CellErrors& priors, std::span<const PlacingReading> readings, const Eigen::Matrix3d& gain,
                        CellEstimate estimate) {
  CellErrors normal = CellErrors::Zero();
  CellErrors scattered = CellErrors::Zero();
  for (const PlacingReading& reading : readings) {
    const CellJacobian J = readingJacobian(gain, reading.v_g);
    const CellErrors share = J.transpose() * J / reading.variance_g2;
    normal += share;
    scattered += reading.scatter_g2 / reading.variance_g2 * share;
  }
  if (estimate != CellEstimate::Tree) {
    // The error is -A^-1 L x + A^-1 J^T W n, of true unknowns x with covariance L^-1 and readings' noise n.
    CellErrors of_noise = (priors + normal).inverse();
    CellErrors of_truth = of_noise * priors;
    if (estimate == CellEstimate::GlobalNoCrossAxis) {
      for (const int k : kCrossAxis) {
        of_noise.row(k).setZero();
        of_truth.row(k) = CellErrors::Identity().row(k);
      }
    }
    return of_truth * priors.ldlt().solve(of_truth.transpose()) + of_noise * scattered * of_noise.transpose();
  }
  const Eigen::Matrix3d attitude = (normal + priors).topLeftCorner<3, 3>().inverse();
  const CellErrors sensor = priors.diagonal().cwiseInverse().asDiagonal();
  CellErrors carried = CellErrors::Identity();
  carried.topLeftCorner<3, 3>().setZero();
  carried.topRightCorner<3, 12>() = -attitude * normal.topRightCorner<3, 12>();
  CellErrors covariance = carried * sensor * carried.transpose();
  covariance.topLeftCorner<3, 3>() += attitude;
  return covariance;
}

PartMotionJacobian motionJacobian(const Eigen::Vector3d& at_o) {
  PartMotionJacobian X;
  X << Eigen::Matrix3d::Identity(), -skew(at_o);
  return X;
}

}  // namespace hexoderm
