#include "widgets/coloring/cell_colors.h"

namespace hexoderm {

std::vector<Rgb> cellColors(Coloring coloring, const CellFigures& figures, const CellReadings& readings,
                            const SceneColors& colors) {
  const std::size_t count = figures.cells.size();
  std::vector<Rgb> result(count, colors.neutral);
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
    const ColorRange range = colorRange(coloring, values);
    for (std::size_t k = 0; k < count; ++k) {
      if (values[k]) result[k] = onScale(colors.scale, (*values[k] - range.low) / (range.high - range.low));
    }
  }
  return result;
}

}  // namespace hexoderm
