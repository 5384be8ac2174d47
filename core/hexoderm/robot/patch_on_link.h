#pragma once

#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/ids.h"

#include <optional>
#include <string>

namespace hexoderm {

/// Where a patch is on the robot: x_l = T_l_o x_o, from the patch's frame into that of a link.
struct PatchOnLink {
  CellId origin;     ///< the origin cell of the patch, whose frame is o
  std::string link;  ///< as the robot's description names it
  SE3 T_l_o;         ///< metres
  /// Order position (m, link frame) then rotation (rad, right-multiplied error in the patch frame). Absent where it is
  /// not known; the covariances of cells in the link's frame are then not known either.
  std::optional<Matrix6d> cov_t_r;
};

}  // namespace hexoderm
