#pragma once

#include "widgets/graph/graph_camera.h"
#include "widgets/graph/graph_scene.h"

#include <QString>
#include <cstddef>
#include <optional>

namespace hexoderm {

class Selection;

// Functions by which mouse and keyboard point at cells and links of the graph, and the words about the thing pointed
// at.

/// A cell or a link of a GraphScene, by index; or neither.
struct GraphHit {
  std::optional<std::size_t> cell;
  std::optional<std::size_t> link;
  friend bool operator==(const GraphHit&, const GraphHit&) = default;
  [[nodiscard]] bool isNothing() const { return !cell && !link; }
};

/// The cell or link at a position of the view. If cells are smaller than a hand is steady, only the nearest cell.
GraphHit hitAt(const GraphScene& scene, const GraphCamera& camera, const QPointF& position);
/// The picked cell or link, as far as the scene shows it.
GraphHit pickedIn(const GraphScene& scene, const Selection& selection);
void pickHit(const GraphScene& scene, const GraphHit& hit, Selection& selection);
/// The cell that an arrow key leads to from what is picked: a neighbour in the direction (unit length, y up), an end of
/// the picked link, or the origin where nothing is picked.
std::optional<std::size_t> cellToward(const GraphScene& scene, const GraphHit& picked, const QPointF& direction);

/// The point of the sheet at which a cell, or the middle of a link, is drawn. For a cut link it is one of its ends.
/// None for nothing.
std::optional<QPointF> middleOf(const GraphScene& scene, const GraphHit& hit);

/// Empty for nothing.
QString toolTipOf(const GraphScene& scene, const GraphHit& hit);
/// The size of the skin, and what is picked in it, for screen readers.
QString describeGraph(const GraphScene& scene, const GraphHit& picked);

}  // namespace hexoderm
