#pragma once

#include "hexoderm/base/se3.h"

#include <Eigen/Core>
#include <span>

namespace hexoderm {

/// Solution of the constrained orthogonal Procrustes problem.
struct ProcrustesSolution {
  Eigen::Matrix3d R_c_n = Eigen::Matrix3d::Identity();
  Eigen::Vector3d singular_values = Eigen::Vector3d::Zero();  ///< singular values of H, descending, not negative
};

/// The rotation that best turns the columns of N onto those of C, eqs. (13) to (15) of the paper:
/// with H = sum_p n_p c_p^T = U S V^T,  R_c_n = V diag(1, 1, det(V U^T)) U^T  minimises  sum_p |c_p - R_c_n n_p|^2.
/// (Eq. (14) as printed gives the transpose for row-stacked data; this convention is fixed by a test.)
///
/// `N`, `C`: 3 x P, vector p of cell n and of cell c in that cell's frame; P may be 0. Weights are put into the vectors
/// by the caller. Throws InvalidArgument if the shapes differ or a value is not finite.
/// Degenerate: with rank(H) < 2 the rotation is one of many minimisers (P = 0 gives the identity); the singular values
/// tell. Never NaN.
ProcrustesSolution solveProcrustes(const Eigen::Matrix3Xd& N, const Eigen::Matrix3Xd& C);

/// The rigid transform that minimises sum |a_i - T_a_b b_i|^2 (Arun, Huang, Blostein 1987; no scale, no reflection).
/// Sizes must agree (InvalidArgument). With fewer than three points, or points on a line, one of the minimisers.
SE3 alignPoints(std::span<const Eigen::Vector3d> a, std::span<const Eigen::Vector3d> b);

/// The rotation closest to all of `rotations` in the sum of squared Frobenius norms. Empty: identity.
Eigen::Matrix3d chordalMean(std::span<const Eigen::Matrix3d> rotations);

}  // namespace hexoderm
