#include "hexoderm/reconstruction/result/uncertainty.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/units.h"

#include <algorithm>

namespace hexoderm {

double rotationSigma(const Eigen::Matrix3d& covariance) { return std::min(kPi, largestDeviation(covariance)); }

namespace {

std::optional<Uncertainty95> uncertaintyBy(const std::optional<Matrix6d>& cov_t_r) {
  if (!cov_t_r) return std::nullopt;
  return Uncertainty95{kSigmasFor95Percent * largestDeviation(cov_t_r->topLeftCorner<3, 3>()),
                       std::min(kPi, kSigmasFor95Percent * largestDeviation(cov_t_r->bottomRightCorner<3, 3>()))};
}

}  // namespace

std::optional<Uncertainty95> uncertaintyOf(const CellPlacement& cell) { return uncertaintyBy(cell.cov_t_r); }

std::optional<Uncertainty95> shapeUncertaintyOf(const CellPlacement& cell) { return uncertaintyBy(cell.shape_cov_t_r); }

}  // namespace hexoderm
