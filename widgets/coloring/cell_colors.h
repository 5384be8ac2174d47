#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/style/scene_colors.h"

#include <vector>

namespace hexoderm {

/// The colour of every cell's front face in the 3D scene, in the order of the figures; neutral where nothing is known.
std::vector<Rgb> cellColors(Coloring coloring, const CellFigures& figures, const CellReadings& readings,
                            const SceneColors& colors);

}  // namespace hexoderm
