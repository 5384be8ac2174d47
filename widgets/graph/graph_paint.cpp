#include "widgets/graph/graph_paint.h"

#include "widgets/coloring/cell_colors.h"
#include "widgets/style/color_maps.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <string>

namespace hexoderm {
namespace {

struct GraphPaintWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::GraphPaint)
};

/// Steps that a scale is drawn in; the eye tells no more apart.
constexpr int kScaleSteps = 24;

/// After the steps of the scale come the colours of what lies below and above it.
std::int16_t stepOf(std::optional<double> value, const ColorRange& range) {
  constexpr double kSlack = 1e-9;  // of a value at an end
  if (!value || !std::isfinite(*value)) return GraphPaint::kPlain;
  const double t = (*value - range.low) / (range.high - range.low);
  if (t < -kSlack) return kScaleSteps;
  if (t > 1 + kSlack) return kScaleSteps + 1;
  return static_cast<std::int16_t>(std::lround(std::clamp(t, 0.0, 1.0) * (kScaleSteps - 1)));
}

QColor classColor(std::size_t index, std::size_t count, Theme theme) {
  return toQColor(categoryColor(sceneColors(theme), index, count));
}

void paintScale(const GraphScene& scene, Theme theme, const std::optional<ColorRange>& fixed, GraphPaint& paint) {
  const ColoringRow& row = coloringRow(paint.coloring);
  const SceneColors colors = sceneColors(theme);
  const ColorMap& map = mapOf(paint.coloring, colors);
  std::vector<QColor> steps;
  for (int step = 0; step < kScaleSteps; ++step) {
    steps.push_back(toQColor(onScale(map.steps, static_cast<double>(step) / (kScaleSteps - 1))));
  }
  steps.push_back(toQColor(map.below));
  steps.push_back(toQColor(map.above));
  if (row.colors_links) {
    for (const QColor& step : steps) paint.strokes.push_back({step, Qt::SolidLine, false});
  } else {
    paint.fills = steps;
  }
  if (!scene.reconstruction()) return;
  const Reconstruction& skin = *scene.reconstruction();
  const CellMetrics figures = row.colors_links ? CellMetrics{} : makeCellMetrics(skin);
  const auto values = scaledValues(paint.coloring, skin, figures, {});
  paint.scale = makeScaleLegend(paint.coloring, values, values, fixed, skin.options);
  const ColorRange range = paint.scale->range;
  if (row.colors_links) {
    for (std::size_t k = 0; k < scene.links().size(); ++k) {
      const LinkEstimate& link = *scene.links()[k].estimate;
      paint.of_link[k] = stepOf(row.of_link(link), range);
      paint.has_unknown |= link.used && paint.of_link[k] == GraphPaint::kPlain;
    }
  } else {
    for (std::size_t k = 0; k < figures.cells.size(); ++k) {
      const std::optional<std::size_t> cell = scene.indexOf(figures.cells[k]);
      if (!cell) continue;
      paint.of_cell[*cell] = stepOf(values[k], range);
      paint.has_unknown |= paint.of_cell[*cell] == GraphPaint::kPlain;
    }
  }
}

void paintQuality(const GraphScene& scene, Theme theme, GraphPaint& paint) {
  for (const EdgeQuality quality :
       {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over}) {
    paint.strokes.push_back(linkStroke(quality, theme));
    paint.words.push_back(qualityWord(quality));
  }
  for (std::size_t k = 0; k < scene.links().size(); ++k) {
    paint.of_link[k] = static_cast<std::int16_t>(scene.links()[k].estimate->quality);
  }
}

void paintPlacedBy(const GraphScene& scene, Theme theme, GraphPaint& paint) {
  paint.fills = {classColor(0, 2, theme), classColor(1, 2, theme)};
  paint.words = {GraphPaintWords::tr("own readings"), GraphPaintWords::tr("links")};
  for (std::size_t k = 0; k < scene.cells().size(); ++k) paint.of_cell[k] = scene.cells()[k].placed_by_links ? 1 : 0;
}

void paintPatches(const GraphScene& scene, Theme theme, GraphPaint& paint) {
  constexpr std::size_t kMaxColors = 64;  // more can't be told apart; beyond that neighbours should at least differ
  const std::size_t colors = std::min(scene.patches().size(), kMaxColors);
  for (std::size_t k = 0; k < colors; ++k) {
    paint.fills.push_back(classColor(k, colors, theme));
    paint.words.push_back(patchWord(scene.patches()[k].patch->id.value()));
  }
  if (scene.patches().size() > colors) paint.words.clear();
  for (std::size_t k = 0; k < scene.cells().size(); ++k) {
    paint.of_cell[k] = static_cast<std::int16_t>(scene.cells()[k].patch % std::max<std::size_t>(colors, 1));
  }
}

void paintBodyParts(const GraphScene& scene, Theme theme, GraphPaint& paint) {
  const CellMetrics figures = scene.reconstruction() ? makeCellMetrics(*scene.reconstruction()) : CellMetrics{};
  for (const std::string& name : figures.body_parts) {
    paint.fills.push_back(classColor(paint.fills.size(), figures.body_parts.size(), theme));
    paint.words.push_back(QString::fromStdString(name));
  }
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    const std::optional<std::size_t> cell = scene.indexOf(figures.cells[k]);
    if (!cell) continue;
    if (figures.body_part[k]) paint.of_cell[*cell] = static_cast<std::int16_t>(*figures.body_part[k]);
    paint.has_unknown |= !figures.body_part[k];
  }
}

}  // namespace

GraphPaint paintOf(const GraphScene& scene, Coloring coloring, Theme theme, const std::optional<ColorRange>& fixed) {
  GraphPaint paint;
  paint.coloring = coloring;
  paint.of_link.assign(scene.links().size(), GraphPaint::kPlain);
  paint.of_cell.assign(scene.cells().size(), GraphPaint::kPlain);
  if (isQuantity(coloring)) {
    paintScale(scene, theme, fixed, paint);
  } else if (coloring == Coloring::LinkQuality) {
    paintQuality(scene, theme, paint);
  } else if (coloring == Coloring::PlacedBy) {
    paintPlacedBy(scene, theme, paint);
  } else if (coloring == Coloring::Patch) {
    paintPatches(scene, theme, paint);
  } else {
    paintBodyParts(scene, theme, paint);
  }
  return paint;
}

bool knowsBodyParts(const GraphScene& scene) {
  return std::ranges::any_of(scene.cells(),
                             [](const GraphScene::Cell& cell) { return !cell.placement->body_part.empty(); });
}

}  // namespace hexoderm
