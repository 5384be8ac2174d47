#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <QString>
#include <optional>
#include <vector>

class QPainter;
class QSize;

namespace hexoderm {

/// The meaning of the cells' colours, for the legend.
struct LegendContent {
  Coloring coloring = Coloring::LinkQuality;
  ColorRange range;
  bool some_unknown = false;  ///< some cells are neutral
  std::size_t patches = 0;
  std::vector<QString> body_parts;
};

/// Paints the legend along the bottom of `area`, in as many rows as its width requires: line samples of the classes,
/// swatches of categories, or a scale with name, unit and ends. Returns the height that it took.
int paintLegend(QPainter& painter, const QSize& area, const LegendContent& content, Theme theme,
                const SceneColors& colors);

/// The legend in one sentence, for screen readers.
QString legendInWords(const LegendContent& content);

}  // namespace hexoderm
