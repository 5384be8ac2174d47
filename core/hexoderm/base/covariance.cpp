#include "hexoderm/base/covariance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hexoderm {

double largestDeviation(const Eigen::Matrix3d& covariance) {
  // The closed form is exact enough for a deviation, and several times as fast as iterating.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

Eigen::Matrix3d ellipsoid95(const Eigen::Matrix3d& covariance) {
  constexpr double kChiSquare95 = 7.814727903251179;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d lengths = (kChiSquare95 * solver.eigenvalues().cwiseMax(0.0)).cwiseSqrt();
  return solver.eigenvectors() * lengths.asDiagonal();
}

}  // namespace hexoderm
