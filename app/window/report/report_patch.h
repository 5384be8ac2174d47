#pragma once

#include "app/window/report/report_blocks.h"
#include "hexoderm/solve/metrics/distribution.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <QString>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// The values that the cells of a patch are coloured by, in the unit of the axis, in the order of its cells.
struct PatchColoring {
  QString axis;                               ///< "uncertainty of the shape (95 %), mm"
  bool is_of_shape = false;                   ///< else relative to the origin
  std::vector<std::optional<double>> values;  ///< absent where none is stated
  Distribution distribution;                  ///< of those that are; its ends are those of the scale
  std::optional<std::size_t> worst;           ///< the cell with the largest
};

/// By the uncertainty of the shape, or where none is stated by that of the position relative to the origin.
PatchColoring patchColoring(const PatchReconstruction& patch);

/// The patch from its four sides (see PatchSides), drawn as shapes: prisms in parallel projection, all to one scale,
/// with a bar of a length that is said, the axes of the patch's frame, and the IDs of cells that are large enough for
/// them. Cells that face away are grey, those without a reading of their own hatched; the one that is known least well
/// has a thick outline, and its ID and the origin's are there in any case.
std::vector<ReportDrawing> patchDrawings(const std::shared_ptr<const Reconstruction>& reconstruction, std::size_t patch,
                                         const PatchColoring& coloring);

}  // namespace hexoderm
