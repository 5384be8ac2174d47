#pragma once

#include <Eigen/Core>

namespace hexoderm {

/// Standard deviation along the worst direction of a 3 x 3 covariance: the root of its largest eigenvalue, within 1e-7
/// of it. 0 where rounding leaves nothing positive.
double largestDeviation(const Eigen::Matrix3d& covariance);

/// Times the deviation along an axis: what is within with 95 % probability, along that axis.
inline constexpr double kSigmasFor95Percent = 1.96;

/// The region that holds a normally distributed point with 95 % probability, as the image of the unit sphere: x = A s
/// with |s| <= 1. The columns of A are the semi-axes, the longest last, sqrt(7.815) = 2.795 deviations long (chi square
/// with three degrees of freedom): more than kSigmasFor95Percent, which is about one direction only.
Eigen::Matrix3d ellipsoid95(const Eigen::Matrix3d& covariance);

}  // namespace hexoderm
