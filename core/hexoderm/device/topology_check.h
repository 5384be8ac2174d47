#pragma once

#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"

#include <vector>

namespace hexoderm {

/// What is wrong with a topology as a device sent it, one offence a cell or link; none for one that SkinGraph takes as
/// it is. Links to interfaces and between body parts are as they should be.
std::vector<ProtocolViolation> offencesOf(const CellModel& model, const NeighborList& neighbors);

}  // namespace hexoderm
