#pragma once

#include "hexoderm/io/export_selection.h"

#include <string>
#include <unordered_map>

namespace hexoderm {

// Functions shared by the exporters.

/// Class of each cell's worst used link; cells without a used link are not in the map.
std::unordered_map<CellId, EdgeQuality> worstUsedQuality(const Reconstruction& reconstruction);

/// The frame of the points, for files that say it: "in the frame of cell 7, the origin of the patch", "in the frame of
/// link r_forearm".
std::string frameText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// The placement with its rotation made orthogonal to rounding: files may state rotations with few decimals, and
/// quaternions and angles can only say true ones.
SE3 rigid(const SE3& T);

}  // namespace hexoderm
