#pragma once

#include <Eigen/Core>

namespace hexoderm {

/// Standard deviation along the worst direction of a 3 x 3 covariance: the root of its largest eigenvalue, within 1e-7
/// of it. 0 where rounding leaves nothing positive.
double largestDeviation(const Eigen::Matrix3d& covariance);

}  // namespace hexoderm
