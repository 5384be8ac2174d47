#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/style/scene_colors.h"

#include <vector>

namespace hexoderm {

/// The colours of a quantity's scale.
const ColorMap& mapOf(Coloring coloring, const SceneColors& colors);

/// The colour of every cell's front face in the 3D scene, in the order of the figures; SceneColors::no_data where
/// nothing is known. `range`: of the scale, where the coloring has one.
std::vector<Rgb> cellColors(Coloring coloring, const CellFigures& figures, const CellReadings& readings,
                            const ColorRange& range, const SceneColors& colors);

}  // namespace hexoderm
