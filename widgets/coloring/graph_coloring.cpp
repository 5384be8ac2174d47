#include "widgets/coloring/graph_coloring.h"

#include "hexoderm/reconstruction/figures/cell_figures.h"
#include "hexoderm/util/units.h"
#include "widgets/patch/patch_words.h"
#include "widgets/style/scene_colors.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <string>

namespace hexoderm {
namespace {

struct ColoringWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::GraphColoring)
};

constexpr std::array kColorings = {
    GraphColoring::Quality,  GraphColoring::Residual, GraphColoring::Deviation, GraphColoring::Bend,
    GraphColoring::Twist,    GraphColoring::Yaw,      GraphColoring::Position,  GraphColoring::Orientation,
    GraphColoring::PlacedBy, GraphColoring::Patch,    GraphColoring::BodyPart,
};

// Where the scales end: beyond what is good, so that what is good can be told apart, and where bad is bad enough.
constexpr double kResidualEnd = kResidualScaleEnd_deg * kDegree;
constexpr double kBendEnd = 30 * kDegree;
constexpr double kTwistEnd = 20 * kDegree;
constexpr double kYawEnd = 6 * kDegree;
constexpr double kPositionEnd_m = kPositionScaleEnd_mm * kMillimetre;
constexpr double kOrientationEnd = kOrientationScaleEnd_deg * kDegree;
/// Steps that a scale is drawn in; the eye tells no more apart.
constexpr int kSteps = 24;

QString degreesOrMore(double angle_rad) {
  return ColoringWords::tr("%1° or more").arg(QLocale().toString(toDegrees(angle_rad), 'f', 0));
}

std::optional<double> figureOf(GraphColoring coloring, const LinkEstimate& link) {
  switch (coloring) {
    case GraphColoring::Residual:
      return link.knownResidual();
    case GraphColoring::Deviation:
      return link.knownSigma();
    case GraphColoring::Bend:
      return link.hasFigures() ? std::optional(std::abs(link.bend_rad)) : std::nullopt;
    case GraphColoring::Twist:
      return link.hasFigures() ? std::optional(std::abs(link.twist_rad)) : std::nullopt;
    case GraphColoring::Yaw:
      return link.hasFigures() ? std::optional(std::abs(link.yaw_rad)) : std::nullopt;
    default:
      return std::nullopt;
  }
}

CellFigures figuresOf(const GraphScene& scene) {
  return scene.reconstruction() ? makeCellFigures(*scene.reconstruction()) : CellFigures{};
}

std::int16_t stepOf(std::optional<double> figure, const GraphScale& scale) {
  if (!figure || !std::isfinite(*figure)) return GraphPaint::kPlain;
  return static_cast<std::int16_t>(std::lround(std::clamp(*figure / scale.end, 0.0, 1.0) * (kSteps - 1)));
}

/// Classes without an order of their own, spread over the scale; its ends are left out.
QColor classColor(std::size_t index, std::size_t count) {
  return viridis((static_cast<double>(index) + 0.5) / static_cast<double>(std::max<std::size_t>(count, 1)));
}

void paintScale(const GraphScene& scene, GraphPaint& paint) {
  const GraphScale& scale = *paint.scale;
  for (int step = 0; step < kSteps; ++step) {
    const QColor color = viridis(static_cast<double>(step) / (kSteps - 1));
    if (colorsCells(paint.coloring)) {
      paint.fills.push_back(color);
    } else {
      paint.strokes.push_back({color, Qt::SolidLine, false});
    }
  }
  if (colorsCells(paint.coloring)) {
    const CellFigures figures = figuresOf(scene);
    const auto& values = paint.coloring == GraphColoring::Position ? figures.position_95_m : figures.orientation_95_rad;
    for (std::size_t k = 0; k < figures.cells.size(); ++k) {
      const std::optional<std::size_t> cell = scene.indexOf(figures.cells[k]);
      if (!cell) continue;
      paint.of_cell[*cell] = stepOf(values[k], scale);
      paint.has_unknown |= paint.of_cell[*cell] == GraphPaint::kPlain;
    }
  } else {
    for (std::size_t k = 0; k < scene.links().size(); ++k) {
      const LinkEstimate& link = *scene.links()[k].estimate;
      paint.of_link[k] = stepOf(figureOf(paint.coloring, link), scale);
      paint.has_unknown |= link.used && paint.of_link[k] == GraphPaint::kPlain;
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
  paint.words = {ColoringWords::tr("own readings"), ColoringWords::tr("links")};
  for (std::size_t k = 0; k < scene.cells().size(); ++k) paint.of_cell[k] = scene.cells()[k].placed_by_links ? 1 : 0;
}

void paintPatches(const GraphScene& scene, GraphPaint& paint) {
  constexpr std::size_t kMostColors = 64;  // more can't be told apart, and then neighbours should at least differ
  const std::size_t colors = std::min(scene.patches().size(), kMostColors);
  for (std::size_t k = 0; k < colors; ++k) {
    paint.fills.push_back(classColor(k, colors));
    paint.words.push_back(ColoringWords::tr("patch %1").arg(scene.patches()[k].patch->id.value() + 1));
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

std::span<const GraphColoring> graphColorings() { return kColorings; }

bool colorsCells(GraphColoring coloring) { return coloring >= GraphColoring::Position; }

QString coloringName(GraphColoring coloring) {
  switch (coloring) {
    case GraphColoring::Quality:
      return coloringName(CellColoring::LinkQuality);
    case GraphColoring::Residual:
      return coloringName(CellColoring::Residual);
    case GraphColoring::Deviation:
      return coloringName(CellColoring::Deviation);
    case GraphColoring::Bend:
      return ColoringWords::tr("bend");
    case GraphColoring::Twist:
      return ColoringWords::tr("twist");
    case GraphColoring::Yaw:
      return ColoringWords::tr("yaw");
    case GraphColoring::Position:
      return coloringName(CellColoring::PositionUncertainty);
    case GraphColoring::Orientation:
      return coloringName(CellColoring::OrientationUncertainty);
    case GraphColoring::PlacedBy:
      return ColoringWords::tr("placed by");
    case GraphColoring::Patch:
      return coloringName(CellColoring::Patch);
    case GraphColoring::BodyPart:
      return coloringName(CellColoring::BodyPart);
  }
  return {};
}

std::optional<GraphScale> scaleOf(GraphColoring coloring) {
  switch (coloring) {
    case GraphColoring::Residual:
      return GraphScale{kResidualEnd, ColoringWords::tr("residual, rms over poses"), degreesOrMore(kResidualEnd)};
    case GraphColoring::Deviation: {
      const double end = kDeviationScaleEnd_deg * kDegree;
      return GraphScale{end, coloringName(coloring), degreesOrMore(end)};
    }
    case GraphColoring::Bend:
      return GraphScale{kBendEnd, ColoringWords::tr("bend, either way"), degreesOrMore(kBendEnd)};
    case GraphColoring::Twist:
      return GraphScale{kTwistEnd, ColoringWords::tr("twist, either way"), degreesOrMore(kTwistEnd)};
    case GraphColoring::Yaw:
      return GraphScale{kYawEnd, ColoringWords::tr("yaw, either way"), degreesOrMore(kYawEnd)};
    case GraphColoring::Position:
      return GraphScale{
          kPositionEnd_m, ColoringWords::tr("position known to (95 %)"),
          ColoringWords::tr("±%1 mm or more").arg(QLocale().toString(toMillimetres(kPositionEnd_m), 'f', 0))};
    case GraphColoring::Orientation:
      return GraphScale{kOrientationEnd, ColoringWords::tr("orientation known to (95 %)"),
                        QStringLiteral("±") + degreesOrMore(kOrientationEnd)};
    default:
      return std::nullopt;
  }
}

GraphPaint paintOf(const GraphScene& scene, GraphColoring coloring, Theme theme) {
  GraphPaint paint;
  paint.coloring = coloring;
  paint.scale = scaleOf(coloring);
  paint.of_link.assign(scene.links().size(), GraphPaint::kPlain);
  paint.of_cell.assign(scene.cells().size(), GraphPaint::kPlain);
  if (paint.scale) {
    paintScale(scene, paint);
  } else if (coloring == GraphColoring::Quality) {
    paintQuality(scene, theme, paint);
  } else if (coloring == GraphColoring::PlacedBy) {
    paintPlacedBy(scene, paint);
  } else if (coloring == GraphColoring::Patch) {
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
