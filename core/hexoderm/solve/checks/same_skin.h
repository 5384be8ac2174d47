#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <utility>
#include <vector>

namespace hexoderm {

class SkinGraph;

/// What a calibrated skin has and the skin of today has not.
struct MissingParts {
  std::vector<CellId> cells;                       ///< ascending
  std::vector<std::pair<LinkEnd, LinkEnd>> links;  ///< of cells that are both there
};

/// Compares the skin of a calibration with what is connected today. Throws InvalidArgument, naming what differs, if
/// that is another skin: a cell model with other ports or another accelerometer, cells or links that the calibration
/// does not have, or fewer than half of its cells.
MissingParts findMissingParts(const Reconstruction& calibration, const CellModel& model, const SkinGraph& today);

}  // namespace hexoderm
