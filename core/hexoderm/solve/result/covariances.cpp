#include "hexoderm/solve/result/covariances.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <algorithm>

namespace hexoderm {

double rotationSigma(const Eigen::Matrix3d& covariance) { return std::min(kPi, largestDeviation(covariance)); }

Uncertainty95 uncertaintyBy(const Matrix6d& cov_t_r) {
  return {kSigmasFor95Percent * largestDeviation(cov_t_r.topLeftCorner<3, 3>()),
          std::min(kPi, kSigmasFor95Percent * largestDeviation(cov_t_r.bottomRightCorner<3, 3>()))};
}

std::optional<Uncertainty95> uncertaintyOf(const CellPlacement& cell) {
  return cell.cov_t_r ? std::optional(uncertaintyBy(*cell.cov_t_r)) : std::nullopt;
}

std::optional<Uncertainty95> shapeUncertaintyOf(const CellPlacement& cell) {
  return cell.shape_cov_t_r ? std::optional(uncertaintyBy(*cell.shape_cov_t_r)) : std::nullopt;
}

}  // namespace hexoderm
