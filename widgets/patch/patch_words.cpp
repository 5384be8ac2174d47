#include "widgets/patch/patch_words.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"
#include "widgets/scene/scene_overlays.h"
#include "widgets/style/of_enum.h"
#include "widgets/words/formatting.h"
#include "widgets/words/surface_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace hexoderm {
namespace {

struct PatchWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchWords)
};

/// "0.35 mm", "12.0 mm"
QString millimetres(double length_m) { return millimetresText(length_m, length_m < kMillimetre ? 2 : 1); }

/// That the patches beside the largest are drawn anywhere.
QString notPlacedText(const SceneNotes& notes) {
  constexpr std::size_t kNamed = 6;
  const std::vector<CellId>& origins = notes.not_placed;
  if (origins.size() > kNamed || !notes.frames) {
    return PatchWords::tr("%1 patches beside the largest: how they lie to it and to each other is not known")
        .arg(origins.size());
  }
  if (origins.size() == 1) {
    return PatchWords::tr("dashed frame: patch of cell %1, not placed against the others").arg(origins.front().value());
  }
  QStringList names;
  for (const CellId origin : origins) names << QString::number(origin.value());
  return PatchWords::tr("dashed frames: patches of cells %1, not placed against the others")
      .arg(names.join(QStringLiteral(", ")));
}

QString enlarged(double factor) {
  return factor > 1 ? PatchWords::tr("drawn %1 times as large").arg(QLocale().toString(factor, 'g', 6))
                    : PatchWords::tr("true to scale");
}

}  // namespace

QString itemName(SceneItem item) {
  return ofEnum(
      item, {PatchWords::tr("&Ports"), PatchWords::tr("Cell &IDs"), PatchWords::tr("A&xes"), PatchWords::tr("&Gravity"),
             PatchWords::tr("&Links by quality"), PatchWords::tr("Shortest-path t&ree"),
             PatchWords::tr("&Uncertainty ellipsoids"), PatchWords::tr("&Truth"), PatchWords::tr("Fitted &surface"),
             PatchWords::tr("L&oop gap"), PatchWords::tr("&Differences to the other calibration")});
}

QString itemTip(SceneItem item) {
  return ofEnum(
      item, {PatchWords::tr("Discs where a link joins a neighbour, rings where a port is free"),
             PatchWords::tr("Each cell's number, on faces that look at you"),
             PatchWords::tr("The directions of the patch's frame, which is the origin cell's"),
             PatchWords::tr("Where gravity points in the picked pose"),
             PatchWords::tr("Every link in the colour and line style of its class; muted links are crossed"),
             PatchWords::tr("The links by which every cell is reached from the origin on the shortest way"),
             PatchWords::tr("The region that holds each cell's centre with 95 % probability, relative to the origin"),
             PatchWords::tr("Where the simulated cells really are, moved onto the result as well as possible"),
             PatchWords::tr("The surface fitted to the cells, with each cell's distance from it"),
             PatchWords::tr("The gap between the two ports where the loop should close"),
             PatchWords::tr("From where each cell was to where it is now")});
}

QString whyNotShown(SceneItem item, Availability availability) {
  switch (availability) {
    case Availability::Available:
      return {};
    case Availability::NoSkin:
      return PatchWords::tr("There is no skin yet");
    case Availability::TooManyCells:
      return PatchWords::tr("This skin has too many cells to draw them: at most %1")
          .arg(QLocale().toString(static_cast<int>(item == SceneItem::Ellipsoids ? SceneOverlays::kMaxEllipsoids
                                                                                 : SceneOverlays::kMaxCells)));
    case Availability::NoData:
      break;
  }
  const QString always;
  return ofEnum(
      item, {always, always, always, always, always, always, PatchWords::tr("This result states no uncertainties"),
             PatchWords::tr("Only of a simulated skin is the truth known"), PatchWords::tr("No surface was fitted yet"),
             PatchWords::tr("No loop was evaluated yet"), PatchWords::tr("No comparison was made yet")});
}

QStringList notesText(const SceneNotes& notes, const PatchOverlays& overlays) {
  QStringList lines;
  if (!notes.not_placed.empty()) lines << notPlacedText(notes);
  if (notes.tree) lines << PatchWords::tr("broad lines: the shortest-path tree");
  if (notes.ellipsoid_factor) lines << PatchWords::tr("ellipsoids: 95 %, %1").arg(enlarged(*notes.ellipsoid_factor));
  if (notes.truth) lines << PatchWords::tr("outlines: the truth, moved onto the result");
  if (const SurfaceEvaluation* surface = overlays.surface.get(); notes.distance_factor && surface != nullptr) {
    QString line =
        surface->radius_m
            ? PatchWords::tr("%1, radius %2").arg(surfaceKindWord(surface->kind), millimetres(*surface->radius_m))
            : surfaceKindWord(surface->kind);
    line += PatchWords::tr("; rms distance %1, lines %2")
                .arg(millimetres(surface->rms_m), enlarged(*notes.distance_factor));
    lines << line;
  }
  if (const LoopEvaluation* loop = overlays.loop.get(); notes.loop_factor && loop != nullptr) {
    lines << PatchWords::tr("loop gap: %1, %2 % of the loop; the arrow %3")
                 .arg(millimetres(loop->length_m), figureText(loop->percent, 1), enlarged(*notes.loop_factor));
  }
  if (notes.shift_factor) lines << PatchWords::tr("arrows: from before to now, %1").arg(enlarged(*notes.shift_factor));
  return lines;
}

QString distanceText(CellId a, CellId b, const std::optional<CellDistance>& distance) {
  const QString from = QString::fromStdString(toString(a));
  const QString to = QString::fromStdString(toString(b));
  if (!distance) {
    return PatchWords::tr("Cells %1 and %2 are in different patches: how these lie to each other is not known")
        .arg(from, to);
  }
  const QString angle = degreesText(distance->angle_rad);
  if (!distance->sigma_m) {
    return PatchWords::tr("Cells %1 and %2: %3 apart, their faces %4 to each other")
        .arg(from, to, millimetres(distance->length_m), angle);
  }
  return PatchWords::tr("Cells %1 and %2: %3 ± %4 (95 %) apart, their faces %5 to each other")
      .arg(from, to, millimetres(distance->length_m), millimetres(kSigmasFor95Percent * *distance->sigma_m), angle);
}

}  // namespace hexoderm
