#include "hexoderm/base/procrustes.h"

#include "hexoderm/base/error.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

/// The two columns at right angles, by one rotation from the right of both A and V.
void makeOrthogonal(Eigen::Matrix3d& A, Eigen::Matrix3d& V, int p, int q) {
  const double pp = A.col(p).squaredNorm();
  const double qq = A.col(q).squaredNorm();
  const double pq = A.col(p).dot(A.col(q));
  constexpr double kRounding = 1e-16;
  if (std::abs(pq) <= kRounding * std::sqrt(pp * qq)) return;
  const double zeta = (qq - pp) / (2 * pq);
  const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
  const double c = 1 / std::sqrt(1 + t * t);
  const double s = c * t;
  for (Eigen::Matrix3d* M : {&A, &V}) {
    const Eigen::Vector3d column = M->col(p);
    M->col(p) = c * column - s * M->col(q);
    M->col(q) = s * column + c * M->col(q);
  }
}

/// H = U S V^T by one-sided Jacobi rotations (Hestenes 1958): the columns of H V are made orthogonal. Several times as
/// fast as a general SVD, but good for two singular values that are well above 0 only: false otherwise.
bool solveQuickly(const Eigen::Matrix3d& H, ProcrustesSolution& solution) {
  constexpr int kSweeps = 6;  // converges quadratically; four do for nearly all
  constexpr double kMinRatio = 1e-4;
  Eigen::Matrix3d A = H;
  Eigen::Matrix3d V = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    makeOrthogonal(A, V, 0, 1);
    makeOrthogonal(A, V, 0, 2);
    makeOrthogonal(A, V, 1, 2);
  }
  const Eigen::Vector3d s = A.colwise().norm();
  std::array<int, 3> order = {0, 1, 2};
  if (s[order[0]] < s[order[1]]) std::swap(order[0], order[1]);
  if (s[order[1]] < s[order[2]]) std::swap(order[1], order[2]);
  if (s[order[0]] < s[order[1]]) std::swap(order[0], order[1]);
  solution.singular_values = {s[order[0]], s[order[1]], s[order[2]]};
  if (!(solution.singular_values.y() > kMinRatio * solution.singular_values.x())) return false;

  // V diag(1, 1, det) U^T without the third pair, which the first two determine.
  const Eigen::Vector3d u_1 = A.col(order[0]) / s[order[0]];
  const Eigen::Vector3d u_2 = A.col(order[1]) / s[order[1]];
  const Eigen::Vector3d v_1 = V.col(order[0]);
  const Eigen::Vector3d v_2 = V.col(order[1]);
  solution.R_c_n = v_1 * u_1.transpose() + v_2 * u_2.transpose() + v_1.cross(v_2) * u_1.cross(u_2).transpose();
  return true;
}

}  // namespace

ProcrustesSolution solveProcrustes(const Eigen::Matrix3Xd& N, const Eigen::Matrix3Xd& C) {
  if (N.cols() != C.cols()) throw InvalidArgument("solveProcrustes: N and C must have the same number of vectors");
  if (!N.allFinite() || !C.allFinite()) throw InvalidArgument("solveProcrustes: vectors must be finite");
  if (N.cols() == 0) return {};

  const Eigen::Matrix3d H = N.lazyProduct(C.transpose());
  ProcrustesSolution solution;
  if (solveQuickly(H, solution)) return solution;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d d(1, 1, (svd.matrixV() * svd.matrixU().transpose()).determinant());
  return {svd.matrixV() * d.asDiagonal() * svd.matrixU().transpose(), svd.singularValues()};
}

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
