#pragma once

#include "widgets/coloring/cell_coloring.h"
#include "widgets/style/palette.h"

#include <QString>
#include <optional>
#include <vector>

class QPainter;
class QSize;

namespace hexoderm {

/// The meaning of the cells' colours, for the legend.
struct LegendContent {
  CellColoring coloring = CellColoring::LinkQuality;
  ColorRange range;
  bool some_unknown = false;  ///< some cells are neutral
  std::size_t patches = 0;
  std::vector<QString> body_parts;
};

/// Paints it along the bottom of `area`, in as many rows as the width asks for: line samples of the classes, swatches
/// of categories, a scale with name, unit and ends. Returns the height that it took.
int paintLegend(QPainter& painter, const QSize& area, const LegendContent& content, Theme theme,
                const SceneColors& colors);

/// The same in one sentence, for screen readers.
QString legendInWords(const LegendContent& content);

}  // namespace hexoderm
