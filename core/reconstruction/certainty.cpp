#include "hexoderm/reconstruction/certainty.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/units.h"

#include <algorithm>

namespace hexoderm {

std::optional<Certainty95> certainty95(const CellPlacement& cell) {
  constexpr double kSigmas = 1.96;
  if (!cell.cov_t_r) return std::nullopt;
  return Certainty95{kSigmas * largestDeviation(cell.cov_t_r->topLeftCorner<3, 3>()),
                     std::min(kPi, kSigmas * largestDeviation(cell.cov_t_r->bottomRightCorner<3, 3>()))};
}

}  // namespace hexoderm
