#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"

#include <string>
#include <vector>

namespace hexoderm {

/// True placement of a cell, from a simulator or a measurement. Maps cell to body coordinates.
struct TrueCellPlacement {
  CellId id;
  SE3 T_b_u;
};
/// Where the cells of a simulated skin really are.
struct GroundTruth {
  std::string frame = "body";
  std::vector<TrueCellPlacement> cells;
};

}  // namespace hexoderm
