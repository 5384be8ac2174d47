#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"

namespace hexoderm {

/// Relative covariance of any two cells of a patch. Holds the factor of the information matrix, so it exists for a
/// fresh joint reconstruction only, not for one read from a file.
class PlacementCovariance {
 public:
  PlacementCovariance() = default;
  virtual ~PlacementCovariance() = default;
  PlacementCovariance(const PlacementCovariance&) = delete;
  PlacementCovariance& operator=(const PlacementCovariance&) = delete;

  /// Covariance of T_a_b, the placement of b in a's frame: order position (m, frame of a) then rotation (rad,
  /// right-multiplied error in the frame of b). Costs a few triangular solves with the sparse factor. Zero for a = b.
  /// Throws InvalidArgument if a cell is not in the patch.
  [[nodiscard]] virtual Matrix6d relative(CellId a, CellId b) const = 0;
  /// Covariance between the errors of two cells as CellPlacement::cov_t_r states them of each: relative to the origin,
  /// whose own are zero; rows a, columns b. Costs and throws as relative().
  [[nodiscard]] virtual Matrix6d together(CellId a, CellId b) const = 0;
};

}  // namespace hexoderm
