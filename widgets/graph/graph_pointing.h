#pragma once

#include "widgets/controls/selection.h"
#include "widgets/graph/graph_scene.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <cstddef>
#include <optional>

namespace hexoderm {

// Functions by which mouse and keyboard point at cells and links of the graph, and the words about the thing pointed
// at.

/// A cell or a link of a GraphScene, by index; or neither.
struct GraphHit {
  std::optional<std::size_t> cell;
  std::optional<std::size_t> link;
  friend bool operator==(const GraphHit&, const GraphHit&) = default;
  [[nodiscard]] bool isNothing() const { return !cell && !link; }
};

struct GraphPointing {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::GraphPointing)
};

inline constexpr double kGrasp_px = 7;  ///< how far off the pointer may be

/// The cell or link at a position of the view. If cells are smaller than a hand is steady, only the nearest cell.
inline GraphHit hitAt(const GraphScene& scene, const GraphCamera& camera, const QPointF& position) {
  const QPointF point = camera.toSheet(position);
  // Nobody can aim at the links between dots that are smaller than a hand is steady.
  const double radius_px = scene.radius_m() * camera.scale;
  if (radius_px < 0.6 * kGrasp_px) return {scene.cellNear(point, kGrasp_px / camera.scale), std::nullopt};
  if (const auto cell = scene.cellAt(point)) return {cell, std::nullopt};
  return {std::nullopt, scene.linkAt(point, kGrasp_px / camera.scale)};
}

/// The picked cell or link, as far as the scene shows it.
inline GraphHit pickedIn(const GraphScene& scene, const Selection& selection) {
  GraphHit hit;
  if (const auto cell = selection.cell()) hit.cell = scene.indexOf(*cell);
  if (const auto link = selection.link()) hit.link = scene.indexOf(link->first, link->second);
  return hit;
}

/// `seeks`: and turns the views to it.
inline void pickHit(const GraphScene& scene, const GraphHit& hit, Selection& selection, bool seeks) {
  if (hit.isNothing()) return selection.clear();
  if (hit.cell) {
    const CellId cell = scene.cells()[*hit.cell].id;
    return seeks ? selection.seekCell(cell) : selection.selectCell(cell);
  }
  const LinkEstimate& link = *scene.links()[*hit.link].estimate;
  return seeks ? selection.seekLink(link.source, link.target) : selection.selectLink(link.source, link.target);
}

/// The cell that an arrow key leads to from what is picked: a neighbour in the direction (unit length, y up), an end of
/// the picked link, or the origin where nothing is picked.
inline std::optional<std::size_t> cellToward(const GraphScene& scene, const GraphHit& picked,
                                             const QPointF& direction) {
  if (picked.cell) return scene.neighborToward(*picked.cell, direction);
  if (picked.link) {
    const GraphScene::Link& link = scene.links()[*picked.link];
    const QPointF along = scene.cells()[link.target].center - scene.cells()[link.source].center;
    return QPointF::dotProduct(along, direction) >= 0 ? link.target : link.source;
  }
  const auto origin = std::ranges::find(scene.cells(), true, &GraphScene::Cell::origin);
  if (origin == scene.cells().end()) return std::nullopt;
  return static_cast<std::size_t>(origin - scene.cells().begin());
}

/// The point of the sheet at which a cell, or the middle of a link, is drawn. For a cut link it is one of its ends.
/// None for nothing.
inline std::optional<QPointF> middleOf(const GraphScene& scene, const GraphHit& hit) {
  if (hit.cell) return scene.cells()[*hit.cell].center;
  if (!hit.link) return std::nullopt;
  const GraphScene::Link& link = scene.links()[*hit.link];
  return link.cut ? link.from : 0.5 * (link.from + link.to);
}

/// Empty for nothing.
inline QString toolTipOf(const GraphScene& scene, const GraphHit& hit) {
  if (hit.cell) return cellToolTip(*scene.reconstruction(), scene.cells()[*hit.cell].id);
  if (hit.link) return linkToolTip(*scene.reconstruction(), *scene.links()[*hit.link].estimate);
  return {};
}

/// The size of the skin, and what is picked in it, for screen readers.
inline QString describeGraph(const GraphScene& scene, const GraphHit& picked) {
  if (!scene.reconstruction()) return GraphPointing::tr("No skin is open.");
  QString text = words(sizeText(*scene.reconstruction()));
  if (picked.cell) {
    text += QStringLiteral(". ") + GraphPointing::tr("Picked: cell %1").arg(scene.cells()[*picked.cell].id.value());
  }
  if (picked.link) {
    const LinkEstimate& link = *scene.links()[*picked.link].estimate;
    text +=
        QStringLiteral(". ") + GraphPointing::tr("Picked: %1, %2").arg(longLinkName(link), qualityWord(link.quality));
    if (!link.used) text += QStringLiteral(", ") + GraphPointing::tr("not used");
  }
  return text;
}

}  // namespace hexoderm
