#pragma once

#include "widgets/graph/graph_scene.h"
#include "widgets/style/palette.h"

#include <QColor>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// What the colours of the graph say: of its links, or of its cells, and then the links are grey.
enum class GraphColoring {
  Quality,
  Residual,
  Deviation,
  Bend,
  Twist,
  Yaw,
  Position,
  Orientation,
  PlacedBy,
  Patch,
  BodyPart,
};

/// All of them, those of links first.
std::span<const GraphColoring> graphColorings();
bool colorsCells(GraphColoring coloring);
/// "predicted deviation" and so on, for menus (translated): what the 3D scene offers too is called the same there.
QString coloringName(GraphColoring coloring);

/// A quantity's colours: viridis from 0 to `end` (radians or metres), the same for every skin and every result, so that
/// two pictures can be compared.
struct GraphScale {
  double end = 0;
  QString title;     ///< what is measured
  QString end_text;  ///< "6° or more"
};
/// Absent for colourings by class.
std::optional<GraphScale> scaleOf(GraphColoring coloring);

/// The colours of a scene's links and cells, as indices into a few kinds of strokes and fills, so that each kind is
/// drawn at once.
struct GraphPaint {
  static constexpr int kPlain = -1;  ///< not judged by this colouring, or the figure is not known

  GraphColoring coloring = GraphColoring::Quality;
  std::vector<LinkStroke> strokes;
  std::vector<std::int16_t> of_link;  ///< per link of the scene: index into `strokes` or kPlain
  std::vector<QColor> fills;
  std::vector<std::int16_t> of_cell;  ///< per cell of the scene: index into `fills` or kPlain
  std::vector<QString> words;         ///< of strokes or fills, where these are classes and not steps of a scale
  std::optional<GraphScale> scale;    ///< of strokes or fills, where these are the steps of a scale
  bool has_unknown = false;           ///< something that the scale is for has no figure
};

/// Asks core for the figures of every cell where these are to be shown: some milliseconds for 10,000 cells.
GraphPaint paintOf(const GraphScene& scene, GraphColoring coloring, Theme theme);
/// True if at least one cell says which body part it is on.
bool knowsBodyParts(const GraphScene& scene);

}  // namespace hexoderm
