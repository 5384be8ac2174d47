#pragma once

#include "hexoderm/base/se3.h"

#include <span>

namespace hexoderm {

/// The rigid transform that minimises sum |a_i - T_a_b b_i|^2 (Arun, Huang, Blostein 1987; no scale, no reflection).
/// Sizes must agree (InvalidArgument). With fewer than three points, or points on a line, one of the minimisers.
SE3 alignPoints(std::span<const Eigen::Vector3d> a, std::span<const Eigen::Vector3d> b);

/// The rotation closest to all of `rotations` in the sum of squared Frobenius norms. Empty: identity.
Eigen::Matrix3d chordalMean(std::span<const Eigen::Matrix3d> rotations);

}  // namespace hexoderm
