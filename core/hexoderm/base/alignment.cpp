#include "hexoderm/base/alignment.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/procrustes.h"

namespace hexoderm {

SE3 alignPoints(std::span<const Eigen::Vector3d> a, std::span<const Eigen::Vector3d> b) {
  if (a.size() != b.size()) throw InvalidArgument("alignPoints: both sets must have the same number of points");
  if (a.empty()) return {};
  const auto count = static_cast<Eigen::Index>(a.size());
  Eigen::Matrix3Xd A(3, count);
  Eigen::Matrix3Xd B(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    A.col(i) = a[static_cast<std::size_t>(i)];
    B.col(i) = b[static_cast<std::size_t>(i)];
  }
  const Eigen::Vector3d mean_a = A.rowwise().mean();
  const Eigen::Vector3d mean_b = B.rowwise().mean();
  const Eigen::Matrix3d R = solveProcrustes(B.colwise() - mean_b, A.colwise() - mean_a).R_c_n;
  return {R, mean_a - R * mean_b};
}

Eigen::Matrix3d chordalMean(std::span<const Eigen::Matrix3d> rotations) {
  if (rotations.empty()) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Matrix3d& R : rotations) sum += R;
  return projectToSO3(sum);
}

}  // namespace hexoderm
