#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/style/scene_colors.h"

#include <vector>

namespace hexoderm {

/// The colours of a quantity's scale.
inline const ColorMap& mapOf(Coloring coloring, const SceneColors& colors) {
  return coloringRow(coloring).center ? colors.signed_scale : colors.scale;
}

/// The colour of every cell's front face in the 3D scene, in the order of the figures; SceneColors::no_data where
/// nothing is known. `range`: of the scale, where the coloring has one.
inline std::vector<Rgb> cellColors(Coloring coloring, const CellMetrics& figures, const CellReadings& readings,
                                   const ColorRange& range, const SceneColors& colors) {
  const std::size_t count = figures.cells.size();
  std::vector<Rgb> result(count, colors.no_data);
  if (coloring == Coloring::LinkQuality) {
    for (std::size_t k = 0; k < count; ++k) {
      if (figures.quality[k]) result[k] = colors.quality.at(static_cast<std::size_t>(*figures.quality[k]));
    }
  } else if (coloring == Coloring::Patch) {
    const std::size_t patches = count > 0 ? figures.patch.back() + 1 : 0;
    for (std::size_t k = 0; k < count; ++k) result[k] = categoryColor(colors, figures.patch[k], patches);
  } else if (coloring == Coloring::BodyPart) {
    for (std::size_t k = 0; k < count; ++k) {
      if (figures.body_part[k]) result[k] = categoryColor(colors, *figures.body_part[k], figures.body_parts.size());
    }
  } else {
    const std::vector<std::optional<double>> values = cellValues(coloring, figures, readings);
    const ColorMap& map = mapOf(coloring, colors);
    for (std::size_t k = 0; k < count; ++k) {
      if (values[k]) result[k] = onMap(map, (*values[k] - range.low) / (range.high - range.low));
    }
  }
  return result;
}

}  // namespace hexoderm
