#include "hexoderm/geometry/procrustes.h"

#include "hexoderm/util/error.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace hexoderm {

ProcrustesSolution solveProcrustes(const Eigen::Matrix3Xd& N, const Eigen::Matrix3Xd& C) {
  if (N.cols() != C.cols()) throw InvalidArgument("solveProcrustes: N and C must have the same number of vectors");
  if (!N.allFinite() || !C.allFinite()) throw InvalidArgument("solveProcrustes: vectors must be finite");
  if (N.cols() == 0) return {};

  const Eigen::Matrix3d H = N * C.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d d(1, 1, (svd.matrixV() * svd.matrixU().transpose()).determinant());
  return {svd.matrixV() * d.asDiagonal() * svd.matrixU().transpose(), svd.singularValues()};
}

}  // namespace hexoderm
