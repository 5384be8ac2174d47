#include "hexoderm/solve/global/shape_covariance.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace hexoderm {
namespace {

/// Centres that are all nearer to one line than this, rms, don't say how the patch is turned about it.
constexpr double kOnOneLine_m = 1e-4;
constexpr double kArmOfAttitude_m = 1e-3;

Eigen::Vector3d middleOfCells(const std::vector<SE3>& cells) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SE3& cell : cells) middle += cell.t / static_cast<double>(cells.size());
  return middle;
}

bool lieOnOneLine(const std::vector<SE3>& cells, const Eigen::Vector3d& middle) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const SE3& cell : cells) {
    spread += (cell.t - middle) * (cell.t - middle).transpose() / static_cast<double>(cells.size());
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues()[1] <
         kOnOneLine_m * kOnOneLine_m;
}

/// What a motion of the whole patch (shift, then turn about its middle) does to a cell.
Matrix6d motionOf(const SE3& cell, const Eigen::Vector3d& middle) {
  Matrix6d G = Matrix6d::Zero();
  G.topLeftCorner<3, 3>().setIdentity();
  G.topRightCorner<3, 3>() = -skew(cell.t - middle);
  G.bottomRightCorner<3, 3>() = cell.R.transpose();
  return G;
}

Eigen::Index rowsOf(std::size_t cell) { return static_cast<Eigen::Index>(6 * cell); }

/// W G.
Eigen::MatrixXd weightedMotions(const std::vector<SE3>& cells, const Eigen::Vector3d& middle, double arm_m) {
  Eigen::MatrixXd weighted(rowsOf(cells.size()), 6);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    weighted.middleRows<6>(rowsOf(cell)) = motionOf(cells[cell], middle);
    weighted.middleRows<3>(rowsOf(cell) + 3) *= arm_m * arm_m;
  }
  return weighted;
}

/// Differences of nearly equal covariances may come out slightly negative where nothing is left.
Matrix6d withoutNegatives(const Matrix6d& covariance) {
  if (covariance.llt().info() == Eigen::Success) return covariance;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(covariance);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

std::vector<Matrix6d> shapeCovariancesOf(const std::vector<SE3>& T_o_u,
                                         const std::function<Eigen::MatrixXd(Eigen::MatrixXd)>& times,
                                         const std::function<Matrix6d(std::size_t)>& own) {
  if (T_o_u.empty()) return {};
  const Eigen::Vector3d middle = middleOfCells(T_o_u);
  const double arm_m = lieOnOneLine(T_o_u, middle) ? kArmOfAttitude_m : 0;
  const Eigen::MatrixXd mixed = times(weightedMotions(T_o_u, middle, arm_m));  // C W G
  const Eigen::MatrixXd weighted = weightedMotions(T_o_u, middle, arm_m);  // W G: there was no room for it meanwhile
  Matrix6d normal = Matrix6d::Zero();                                      // G^T W G
  for (std::size_t cell = 0; cell < T_o_u.size(); ++cell) {
    normal += motionOf(T_o_u[cell], middle).transpose() * weighted.middleRows<6>(rowsOf(cell));
  }
  const Matrix6d inverse = normal.ldlt().solve(Matrix6d::Identity());
  const Matrix6d motion = inverse * (weighted.transpose() * mixed) * inverse;  // covariance of the motion taken out
  std::vector<Matrix6d> shape;
  shape.reserve(T_o_u.size());
  for (std::size_t cell = 0; cell < T_o_u.size(); ++cell) {
    const Matrix6d G = motionOf(T_o_u[cell], middle);
    const Matrix6d half =
        own(cell) / 2 + G * motion * G.transpose() / 2 - mixed.middleRows<6>(rowsOf(cell)) * inverse * G.transpose();
    shape.push_back(withoutNegatives(half + half.transpose()));
  }
  return shape;
}

}  // namespace hexoderm
