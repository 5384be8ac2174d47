#pragma once

#include "hexoderm/solve/tree/gravity_table.h"

namespace hexoderm {

/// Judges every cell by its readings alone and takes unusable ones out of the table (Entry::usable), each with a
/// finding that names cell, pose, value and limit: no samples, the same as another cell's, dead or dead on one axis,
/// stuck, saturated, noisy, wrong norm; and poses in which most cells scattered, so that the part and not a sensor
/// moved.
void judgeCells(const SessionSnapshot& snapshot, const SkinGraph& graph, GravityTable& table,
                std::vector<Finding>& findings);

}  // namespace hexoderm
