#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/graph/graph_scene.h"
#include "widgets/style/palette.h"

#include <QColor>
#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

namespace hexoderm {

/// Which of the colours of widgets/style a scene's links and cells have, as indices into a few kinds of
/// strokes and fills, so that each kind is drawn at once. A colouring of cells leaves the links grey.
struct GraphPaint {
  static constexpr int kPlain = -1;  ///< not judged by this colouring, or the value is not known

  Coloring coloring = Coloring::LinkQuality;
  std::vector<LinkStroke> strokes;
  std::vector<std::int16_t> of_link;  ///< per link of the scene: index into `strokes` or kPlain
  std::vector<QColor> fills;
  std::vector<std::int16_t> of_cell;  ///< per cell of the scene: index into `fills` or kPlain
  std::vector<QString> words;         ///< of strokes or fills, where these are classes and not steps of a scale
  std::optional<ScaleLegend> scale;   ///< of strokes or fills, where these are the steps of a scale
  bool has_unknown = false;           ///< a link or cell that the colouring is for has no value
};

/// Asks core for the figures of every cell where these are to be shown: some milliseconds for 10,000 cells.
/// `fixed`: the scale's range, where the operator has fixed it.
GraphPaint paintOf(const GraphScene& scene, Coloring coloring, Theme theme,
                   const std::optional<ColorRange>& fixed = std::nullopt);
/// True if at least one cell says which body part it is on.
bool knowsBodyParts(const GraphScene& scene);

}  // namespace hexoderm
