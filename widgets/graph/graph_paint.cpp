#include "widgets/graph/graph_paint.h"

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
constexpr int kSteps = 24;

CellFigures figuresOf(const GraphScene& scene) {
  return scene.reconstruction() ? makeCellFigures(*scene.reconstruction()) : CellFigures{};
}

std::int16_t stepOf(std::optional<double> value, const ColorRange& range) {
  if (!value || !std::isfinite(*value)) return GraphPaint::kPlain;
  const double t = std::clamp((*value - range.low) / (range.high - range.low), 0.0, 1.0);
  return static_cast<std::int16_t>(std::lround(t * (kSteps - 1)));
}

/// Classes without an order of their own, spread over the scale; its ends are left out.
QColor classColor(std::size_t index, std::size_t count) {
  return viridis((static_cast<double>(index) + 0.5) / static_cast<double>(std::max<std::size_t>(count, 1)));
}

void paintScale(const GraphScene& scene, GraphPaint& paint) {
  const ColoringRow& row = coloringRow(paint.coloring);
  const ColorRange range = row.range.value_or(ColorRange{});
  paint.scale = graphScaleInWords(paint.coloring);
  for (int step = 0; step < kSteps; ++step) {
    const QColor color = viridis(static_cast<double>(step) / (kSteps - 1));
    if (row.colors_links) {
      paint.strokes.push_back({color, Qt::SolidLine, false});
    } else {
      paint.fills.push_back(color);
    }
  }
  if (row.colors_links) {
    for (std::size_t k = 0; k < scene.links().size(); ++k) {
      const LinkEstimate& link = *scene.links()[k].estimate;
      paint.of_link[k] = stepOf(row.of_link(link), range);
      paint.has_unknown |= link.used && paint.of_link[k] == GraphPaint::kPlain;
    }
  } else {
    const CellFigures figures = figuresOf(scene);
    const auto values = cellValues(paint.coloring, figures, {});
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

void paintPlacedBy(const GraphScene& scene, GraphPaint& paint) {
  paint.fills = {classColor(1, 2), classColor(0, 2)};
  paint.words = {GraphPaintWords::tr("own readings"), GraphPaintWords::tr("links")};
  for (std::size_t k = 0; k < scene.cells().size(); ++k) paint.of_cell[k] = scene.cells()[k].placed_by_links ? 1 : 0;
}

void paintPatches(const GraphScene& scene, GraphPaint& paint) {
  constexpr std::size_t kMostColors = 64;  // more can't be told apart; beyond that neighbours should at least differ
  const std::size_t colors = std::min(scene.patches().size(), kMostColors);
  for (std::size_t k = 0; k < colors; ++k) {
    paint.fills.push_back(classColor(k, colors));
    paint.words.push_back(patchWord(scene.patches()[k].patch->id.value()));
  }
  if (scene.patches().size() > colors) paint.words.clear();
  for (std::size_t k = 0; k < scene.cells().size(); ++k) {
    paint.of_cell[k] = static_cast<std::int16_t>(scene.cells()[k].patch % std::max<std::size_t>(colors, 1));
  }
}

void paintBodyParts(const GraphScene& scene, GraphPaint& paint) {
  const CellFigures figures = figuresOf(scene);
  for (const std::string& name : figures.body_parts) {
    paint.fills.push_back(classColor(paint.fills.size(), figures.body_parts.size()));
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

GraphPaint paintOf(const GraphScene& scene, Coloring coloring, Theme theme) {
  GraphPaint paint;
  paint.coloring = coloring;
  paint.of_link.assign(scene.links().size(), GraphPaint::kPlain);
  paint.of_cell.assign(scene.cells().size(), GraphPaint::kPlain);
  if (isQuantity(coloring)) {
    paintScale(scene, paint);
  } else if (coloring == Coloring::LinkQuality) {
    paintQuality(scene, theme, paint);
  } else if (coloring == Coloring::PlacedBy) {
    paintPlacedBy(scene, paint);
  } else if (coloring == Coloring::Patch) {
    paintPatches(scene, paint);
  } else {
    paintBodyParts(scene, paint);
  }
  return paint;
}

bool knowsBodyParts(const GraphScene& scene) {
  return std::ranges::any_of(scene.cells(),
                             [](const GraphScene::Cell& cell) { return !cell.placement->body_part.empty(); });
}

}  // namespace hexoderm
