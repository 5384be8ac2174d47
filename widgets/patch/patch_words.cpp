#include "widgets/patch/patch_words.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/units.h"
#include "widgets/verify/verify_words.h"
#include "widgets/words/formatting.h"

#include <QCoreApplication>
#include <QLocale>

namespace hexoderm {
namespace {

struct SceneWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SceneWords)
};

/// "0.35 mm", "12.0 mm"
QString millimetres(double length_m) { return millimetresInWords(length_m, length_m < kMillimetre ? 2 : 1); }

/// A number with as few decimals as the ends of the scales have.
QString endNumber(double value) { return QLocale().toString(value, 'g', 6); }

QString enlarged(double factor) {
  return factor > 1 ? SceneWords::tr("drawn %1 times as large").arg(endNumber(factor))
                    : SceneWords::tr("true to scale");
}

}  // namespace

QString coloringName(CellColoring coloring) {
  switch (coloring) {
    case CellColoring::LinkQuality:
      return SceneWords::tr("link quality");
    case CellColoring::Residual:
      return SceneWords::tr("residual");
    case CellColoring::Deviation:
      return SceneWords::tr("predicted deviation");
    case CellColoring::PositionUncertainty:
      return SceneWords::tr("position uncertainty");
    case CellColoring::OrientationUncertainty:
      return SceneWords::tr("orientation uncertainty");
    case CellColoring::PathDistance:
      return SceneWords::tr("distance from the origin");
    case CellColoring::SurfaceDistance:
      return SceneWords::tr("distance from the fitted surface");
    case CellColoring::Patch:
      return SceneWords::tr("patch");
    case CellColoring::BodyPart:
      return SceneWords::tr("body part");
    case CellColoring::ReadingX:
      return SceneWords::tr("reading x");
    case CellColoring::ReadingY:
      return SceneWords::tr("reading y");
    case CellColoring::ReadingZ:
      return SceneWords::tr("reading z");
    case CellColoring::ReadingNorm:
      return SceneWords::tr("reading, norm");
    case CellColoring::Temperature:
      return SceneWords::tr("temperature");
  }
  return {};
}

QString coloringTitle(CellColoring coloring) {
  switch (coloring) {
    case CellColoring::Residual:
      return SceneWords::tr("worst link's residual, °");
    case CellColoring::Deviation:
      return SceneWords::tr("worst link's predicted deviation, °");
    case CellColoring::PositionUncertainty:
      return SceneWords::tr("position uncertainty (95 %), mm");
    case CellColoring::OrientationUncertainty:
      return SceneWords::tr("orientation uncertainty (95 %), °");
    case CellColoring::PathDistance:
      return SceneWords::tr("distance from the origin along the path, mm");
    case CellColoring::SurfaceDistance:
      return SceneWords::tr("distance from the fitted surface, mm");
    case CellColoring::ReadingX:
      return SceneWords::tr("newest reading along x, g");
    case CellColoring::ReadingY:
      return SceneWords::tr("newest reading along y, g");
    case CellColoring::ReadingZ:
      return SceneWords::tr("newest reading along z, g");
    case CellColoring::ReadingNorm:
      return SceneWords::tr("norm of the newest reading, g");
    case CellColoring::Temperature:
      return SceneWords::tr("temperature, °C");
    case CellColoring::LinkQuality:
    case CellColoring::Patch:
    case CellColoring::BodyPart:
      break;
  }
  return coloringName(coloring);
}

QString lowEndInWords(CellColoring coloring, const ColorRange& range) {
  switch (coloring) {
    case CellColoring::SurfaceDistance:
    case CellColoring::ReadingX:
    case CellColoring::ReadingY:
    case CellColoring::ReadingZ:
    case CellColoring::ReadingNorm:
    case CellColoring::Temperature:
      return SceneWords::tr("%1 or less").arg(endNumber(range.low));
    default:
      return endNumber(range.low);
  }
}

QString highEndInWords(CellColoring coloring, const ColorRange& range) {
  return coloring == CellColoring::PathDistance ? endNumber(range.high)
                                                : SceneWords::tr("%1 or more").arg(endNumber(range.high));
}

QString whyNoColoring(CellColoring coloring, bool has_values) {
  if (has_values) return {};
  switch (coloring) {
    case CellColoring::Residual:
    case CellColoring::Deviation:
      return SceneWords::tr("No link was measured yet");
    case CellColoring::PositionUncertainty:
    case CellColoring::OrientationUncertainty:
      return SceneWords::tr("This result states no uncertainties");
    case CellColoring::PathDistance:
      return SceneWords::tr("This result holds no paths from the origin");
    case CellColoring::SurfaceDistance:
      return SceneWords::tr("No surface was fitted yet");
    case CellColoring::BodyPart:
      return SceneWords::tr("The skin does not say which body part its cells are on");
    case CellColoring::ReadingX:
    case CellColoring::ReadingY:
    case CellColoring::ReadingZ:
    case CellColoring::ReadingNorm:
      return SceneWords::tr("There are no readings: connect a skin");
    case CellColoring::Temperature:
      return SceneWords::tr("The skin sends no temperatures");
    case CellColoring::LinkQuality:
    case CellColoring::Patch:
      break;
  }
  return {};
}

QString itemName(SceneItem item) {
  switch (item) {
    case SceneItem::Ports:
      return SceneWords::tr("&Ports");
    case SceneItem::Ids:
      return SceneWords::tr("Cell &IDs");
    case SceneItem::Axes:
      return SceneWords::tr("A&xes");
    case SceneItem::Gravity:
      return SceneWords::tr("&Gravity");
    case SceneItem::Links:
      return SceneWords::tr("&Links by quality");
    case SceneItem::Tree:
      return SceneWords::tr("Shortest-path t&ree");
    case SceneItem::Ellipsoids:
      return SceneWords::tr("&Uncertainty ellipsoids");
    case SceneItem::Truth:
      return SceneWords::tr("&Truth");
    case SceneItem::Surface:
      return SceneWords::tr("Fitted &surface");
    case SceneItem::Loop:
      return SceneWords::tr("L&oop gap");
    case SceneItem::Comparison:
      return SceneWords::tr("&Differences to the other calibration");
  }
  return {};
}

QString itemTip(SceneItem item) {
  switch (item) {
    case SceneItem::Ports:
      return SceneWords::tr("Discs where a link joins a neighbour, rings where a port is free");
    case SceneItem::Ids:
      return SceneWords::tr("Each cell's number, on faces that look at you");
    case SceneItem::Axes:
      return SceneWords::tr("The directions of the patch's frame, which is the origin cell's");
    case SceneItem::Gravity:
      return SceneWords::tr("Where gravity points in the picked pose");
    case SceneItem::Links:
      return SceneWords::tr("Every link in the colour and line style of its class; muted links are crossed");
    case SceneItem::Tree:
      return SceneWords::tr("The links by which every cell is reached from the origin on the shortest way");
    case SceneItem::Ellipsoids:
      return SceneWords::tr("The region that holds each cell's centre with 95 % probability, relative to the origin");
    case SceneItem::Truth:
      return SceneWords::tr("Where the simulated cells really are, moved onto the result as well as possible");
    case SceneItem::Surface:
      return SceneWords::tr("The surface fitted to the cells, with each cell's distance from it");
    case SceneItem::Loop:
      return SceneWords::tr("The gap between the two ports where the loop should close");
    case SceneItem::Comparison:
      return SceneWords::tr("From where each cell was to where it is now");
  }
  return {};
}

QString whyNotShown(SceneItem item, Availability availability) {
  switch (availability) {
    case Availability::Available:
      return {};
    case Availability::NoSkin:
      return SceneWords::tr("There is no skin yet");
    case Availability::TooManyCells:
      return SceneWords::tr("This skin has too many cells to draw them: at most %1")
          .arg(QLocale().toString(static_cast<int>(item == SceneItem::Ellipsoids ? SceneOverlays::kMaxEllipsoids
                                                                                 : SceneOverlays::kMaxCells)));
    case Availability::NoData:
      break;
  }
  switch (item) {
    case SceneItem::Ellipsoids:
      return SceneWords::tr("This result states no uncertainties");
    case SceneItem::Truth:
      return SceneWords::tr("Only of a simulated skin is the truth known");
    case SceneItem::Surface:
      return SceneWords::tr("No surface was fitted yet");
    case SceneItem::Loop:
      return SceneWords::tr("No loop was evaluated yet");
    case SceneItem::Comparison:
      return SceneWords::tr("No comparison was made yet");
    default:
      return {};
  }
}

QStringList notesInWords(const SceneNotes& notes, const std::optional<SurfaceEvaluation>& surface,
                         const std::optional<LoopEvaluation>& loop) {
  QStringList lines;
  if (notes.tree) lines << SceneWords::tr("broad lines: the shortest-path tree");
  if (notes.ellipsoid_factor) lines << SceneWords::tr("ellipsoids: 95 %, %1").arg(enlarged(*notes.ellipsoid_factor));
  if (notes.truth) lines << SceneWords::tr("outlines: the truth, moved onto the result");
  if (notes.distance_factor && surface) {
    QString line =
        surface->radius_m
            ? SceneWords::tr("%1, radius %2").arg(surfaceKindWord(surface->kind), millimetres(*surface->radius_m))
            : surfaceKindWord(surface->kind);
    line += SceneWords::tr("; rms distance %1, lines %2")
                .arg(millimetres(surface->rms_m), enlarged(*notes.distance_factor));
    lines << line;
  }
  if (notes.loop_factor && loop) {
    lines << SceneWords::tr("loop gap: %1, %2 % of the loop; the arrow %3")
                 .arg(millimetres(loop->length_m), figureInWords(loop->percent, 1), enlarged(*notes.loop_factor));
  }
  if (notes.shift_factor) lines << SceneWords::tr("arrows: from before to now, %1").arg(enlarged(*notes.shift_factor));
  return lines;
}

QString distanceInWords(CellId a, CellId b, const std::optional<CellDistance>& distance) {
  const QString from = QString::fromStdString(toString(a));
  const QString to = QString::fromStdString(toString(b));
  if (!distance) {
    return SceneWords::tr("Cells %1 and %2 are in different patches: how these lie to each other is not known")
        .arg(from, to);
  }
  const QString angle = degreesInWords(distance->angle_rad);
  if (!distance->sigma_m) {
    return SceneWords::tr("Cells %1 and %2: %3 apart, their faces %4 to each other")
        .arg(from, to, millimetres(distance->length_m), angle);
  }
  return SceneWords::tr("Cells %1 and %2: %3 ± %4 (95 %) apart, their faces %5 to each other")
      .arg(from, to, millimetres(distance->length_m), millimetres(kSigmasFor95Percent * *distance->sigma_m), angle);
}

}  // namespace hexoderm
