#include "widgets/graph/graph_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexoderm {
namespace {

/// Share of the real hexagon that is drawn.
constexpr double kDrawnShare = 0.56;

QPointF toPoint(const Vector2d& point) { return {point.x(), point.y()}; }

double lengthOf(const QPointF& vector) { return std::hypot(vector.x(), vector.y()); }

QPointF unit(const QPointF& vector) {
  const double length = lengthOf(vector);
  return length > 0 ? vector / length : QPointF(1, 0);
}

double distanceToSegment(const QPointF& point, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double squared = QPointF::dotProduct(along, along);
  const double part = squared > 0 ? std::clamp(QPointF::dotProduct(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return lengthOf(point - (a + part * along));
}

/// The distance, or `reach` where it is at least that: of most segments that is cheap to see.
double distanceWithin(double reach, const QPointF& point, const QPointF& a, const QPointF& b) {
  const bool may_be_near = point.x() >= std::min(a.x(), b.x()) - reach && point.x() <= std::max(a.x(), b.x()) + reach &&
                           point.y() >= std::min(a.y(), b.y()) - reach && point.y() <= std::max(a.y(), b.y()) + reach;
  return may_be_near ? std::min(reach, distanceToSegment(point, a, b)) : reach;
}

/// a, b, ... z, aa, ab, ...: as columns of a spreadsheet are named.
QString letters(std::size_t index) {
  QString text;
  for (++index; index > 0; index = (index - 1) / 26) text.prepend(QChar('a' + static_cast<int>((index - 1) % 26)));
  return text;
}

}  // namespace

GraphScene::GraphScene(std::shared_ptr<const Reconstruction> reconstruction)
    : reconstruction_(std::move(reconstruction)) {
  if (!reconstruction_) return;
  const auto corners = reconstruction_->model->outline();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    outline_.at(k) = kDrawnShare * toPoint(corners.at(k).head<2>());
    radius_m_ = std::max(radius_m_, lengthOf(outline_.at(k)));
  }
  addCells();
  addLinks();
}

void GraphScene::addCells() {
  const Reconstruction& reconstruction = *reconstruction_;
  for (const PatchReconstruction& patch : reconstruction.patches) patches_.push_back({&patch, QRectF()});
  std::unordered_map<CellId, std::pair<std::size_t, const CellPlacement*>> placements;
  for (std::size_t k = 0; k < reconstruction.patches.size(); ++k) {
    for (const CellPlacement& cell : reconstruction.patches[k].cells)
      placements.emplace(cell.cell, std::pair(k, &cell));
  }
  cells_.reserve(reconstruction.layout.cells.size());
  index_of_.reserve(reconstruction.layout.cells.size());
  const double reach_m = std::max(reconstruction.model->reach_m(), radius_m_);
  for (const FlatCell& flat : reconstruction.layout.cells) {
    const auto found = placements.find(flat.cell);
    if (found == placements.end()) continue;
    const auto& [patch, placement] = found->second;
    index_of_.emplace(flat.cell, cells_.size());
    cells_.push_back({flat.cell,
                      placement,
                      toPoint(flat.center),
                      flat.angle_rad,
                      patch,
                      reconstruction.patches[patch].origin == flat.cell,
                      placement->placed_by == PlacedBy::Links,
                      {}});
    const QRectF around(flat.center.x() - reach_m, flat.center.y() - reach_m, 2 * reach_m, 2 * reach_m);
    patches_[patch].bounds |= around;
    bounds_ |= around;
    longest_id_ = std::max(longest_id_, toString(flat.cell).size());
  }
}

void GraphScene::addLinks() {
  std::unordered_map<PatchId, const PatchReconstruction*> patch_of;
  for (const PatchReconstruction& patch : reconstruction_->patches) patch_of.emplace(patch.id, &patch);
  links_.reserve(reconstruction_->layout.links.size());
  for (const FlatLink& flat : reconstruction_->layout.links) {
    const auto patch = patch_of.find(flat.patch);
    if (patch == patch_of.end() || flat.link >= patch->second->links.size()) continue;
    const LinkEstimate& estimate = patch->second->links[flat.link];
    const auto source = indexOf(estimate.source.cell);
    const auto target = indexOf(estimate.target.cell);
    if (!source || !target) continue;
    cells_[*source].links.push_back(links_.size());
    cells_[*target].links.push_back(links_.size());
    has_muted_links_ |= !estimate.used;
    links_.push_back({&estimate, *source, *target, toPoint(flat.from), toPoint(flat.to), flat.cut,
                      flat.cut ? letters(cut_count_++) : QString()});
  }
}

std::optional<std::size_t> GraphScene::indexOf(CellId id) const {
  const auto found = index_of_.find(id);
  return found == index_of_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> GraphScene::indexOf(LinkEnd source, LinkEnd target) const {
  const auto cell = indexOf(source.cell);
  if (!cell) return std::nullopt;
  for (const std::size_t link : cells_[*cell].links) {
    const LinkEstimate& estimate = *links_[link].estimate;
    if ((estimate.source == source && estimate.target == target) ||
        (estimate.source == target && estimate.target == source)) {
      return link;
    }
  }
  return std::nullopt;
}

QPointF GraphScene::directionFrom(std::size_t cell, const Link& link) const {
  return unit((cell == link.source ? link.from : link.to) - cells_[cell].center);
}

std::optional<std::size_t> GraphScene::cellAt(const QPointF& point) const {
  // A circle between the hexagon's inner and outer one: nobody aims at a corner.
  return cellNear(point, 0.95 * radius_m_);
}

std::optional<std::size_t> GraphScene::cellNear(const QPointF& point, double tolerance_m) const {
  std::optional<std::size_t> nearest;
  double smallest = tolerance_m;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const double distance = lengthOf(cells_[k].center - point);
    if (distance > smallest) continue;
    smallest = distance;
    nearest = k;
  }
  return nearest;
}

std::optional<std::size_t> GraphScene::linkAt(const QPointF& point, double tolerance_m) const {
  std::optional<std::size_t> nearest;
  double smallest = tolerance_m;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Link& link = links_[k];
    const QPointF& source = cells_[link.source].center;
    const QPointF& target = cells_[link.target].center;
    double distance = distanceWithin(smallest, point, source, link.from);
    distance = distanceWithin(distance, point, target, link.to);
    // The line between the patches belongs to a muted link, too; a cut one ends at its ports.
    if (!link.cut) distance = distanceWithin(distance, point, link.from, link.to);
    if (distance >= smallest) continue;
    smallest = distance;
    nearest = k;
  }
  return nearest;
}

std::optional<std::size_t> GraphScene::neighborToward(std::size_t cell, const QPointF& direction) const {
  constexpr double kLeastAgreement = 0.25;
  std::optional<std::size_t> best;
  double best_agreement = kLeastAgreement;
  for (const std::size_t index : cells_[cell].links) {
    const Link& link = links_[index];
    const double agreement = QPointF::dotProduct(directionFrom(cell, link), direction);
    if (agreement <= best_agreement) continue;
    best_agreement = agreement;
    best = link.source == cell ? link.target : link.source;
  }
  if (best) return best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    if (k == cell) continue;
    const QPointF there = cells_[k].center - cells_[cell].center;
    const double distance = lengthOf(there);
    if (QPointF::dotProduct(there, direction) < 0.5 * distance || distance >= smallest) continue;
    smallest = distance;
    best = k;
  }
  return best;
}

bool GraphScene::hasSamePlacesAs(const GraphScene& other) const {
  return std::ranges::equal(cells_, other.cells_, [](const Cell& a, const Cell& b) {
    return a.id == b.id && lengthOf(a.center - b.center) < 1e-9;
  });
}

}  // namespace hexoderm
