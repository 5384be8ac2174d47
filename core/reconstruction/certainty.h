#pragma once

#include "hexoderm/reconstruction/reconstruction.h"

#include <optional>

namespace hexoderm {

/// What a placement is known to at 95 %: 1.96 standard deviations along its worst direction, relative to the origin.
struct Certainty95 {
  double position_m = 0;
  double orientation_rad = 0;  ///< half a turn at most
};

/// Absent where no covariance is stated.
std::optional<Certainty95> certainty95(const CellPlacement& cell);

}  // namespace hexoderm
