#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace hexoderm {

/// Whether M turns and does nothing else, to a millionth. False for numbers that are not finite.
inline bool isRotation(const Eigen::Matrix3d& M) {
  constexpr double kOrthogonal = 1e-6;
  const Eigen::Matrix3d off = M.transpose() * M - Eigen::Matrix3d::Identity();
  return M.allFinite() && off.cwiseAbs().maxCoeff() <= kOrthogonal && M.determinant() > 0;
}

}  // namespace hexoderm
