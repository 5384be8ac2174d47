#pragma once

#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/ids.h"

#include <string>
#include <vector>

namespace hexoderm {

/// Where the cells really are, as a simulator or a measurement knows it. Maps cell to body coordinates.
struct TrueCellPlacement {
  CellId id;
  SE3 T_b_u;
};
struct GroundTruth {
  std::string frame = "body";
  std::vector<TrueCellPlacement> cells;
};

}  // namespace hexoderm
