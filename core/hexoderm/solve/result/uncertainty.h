#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <optional>

namespace hexoderm {

/// The uncertainty of a cell's placement relative to its origin, as the verdict states it: 1.96 standard deviations
/// (95 %) along the worst axis. The orientation's is at most pi.
struct Uncertainty95 {
  double position_m = 0;
  double orientation_rad = 0;
};

/// Standard deviation of an orientation about its worst axis, rad, from the covariance of its error, rad^2. At most pi:
/// nothing can be turned further.
double rotationSigma(const Eigen::Matrix3d& covariance);

/// By a covariance as in CellPlacement::cov_t_r.
Uncertainty95 uncertaintyBy(const Matrix6d& cov_t_r);

/// Absent where no covariance is stated; zero for the origin.
std::optional<Uncertainty95> uncertaintyOf(const CellPlacement& cell);

/// The same of the cell's place in the shape, relative to the patch as a whole (CellPlacement::shape_cov_t_r). Absent
/// where it is not stated.
std::optional<Uncertainty95> shapeUncertaintyOf(const CellPlacement& cell);

}  // namespace hexoderm
