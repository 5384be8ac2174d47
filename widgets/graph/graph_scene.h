#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hexoderm {

/// The part of the sheet (metres, y up) that a view shows (pixels, y down): `center` of the sheet lies in the middle of
/// the view, `scale` pixels are a metre.
struct GraphCamera {
  QPointF center;
  double scale = 1;
  QSizeF size;  ///< of the view

  [[nodiscard]] QPointF toScreen(const QPointF& sheet) const {
    return {size.width() / 2 + (sheet.x() - center.x()) * scale, size.height() / 2 - (sheet.y() - center.y()) * scale};
  }
  [[nodiscard]] QPointF toSheet(const QPointF& screen) const {
    return {center.x() + (screen.x() - size.width() / 2) / scale,
            center.y() - (screen.y() - size.height() / 2) / scale};
  }
  [[nodiscard]] QRectF toScreen(const QRectF& sheet) const {
    return QRectF(toScreen(sheet.topLeft()), toScreen(sheet.bottomRight())).normalized();
  }

  /// Moves the sheet by so many pixels to the right and downwards.
  void pan(const QPointF& by_px) { center += QPointF(-by_px.x(), by_px.y()) / scale; }
  /// Changes the scale; the point of the sheet that is seen at `about` stays there.
  void zoomTo(double new_scale, const QPointF& about) {
    const QPointF fixed = toSheet(about);
    scale = new_scale;
    center += fixed - toSheet(about);
  }
  /// Pans no further than it takes to see the point, with a margin around it. A point that is in view already, even
  /// near the edge, moves nothing.
  void bringIntoView(const QPointF& sheet, double margin_px) {
    const QPointF at = toScreen(sheet);
    if (QRectF(QPointF(0, 0), size).contains(at)) return;
    const double margin = std::min({margin_px, size.width() / 4, size.height() / 4});
    const QPointF inside(std::clamp(at.x(), margin, size.width() - margin),
                         std::clamp(at.y(), margin, size.height() - margin));
    pan(inside - at);
  }
};

/// A Reconstruction on the sheet of FlatLayout (metres, y up), with the questions that mouse and keyboard ask of it.
/// Holds the Reconstruction that its pointers lead into.
class GraphScene {
 public:
  struct Cell {
    CellId id;
    const CellPlacement* placement = nullptr;
    QPointF center;
    double angle_rad = 0;
    std::size_t patch = 0;
    bool origin = false;
    bool placed_by_links = false;
    std::vector<std::size_t> links;
  };
  struct Link {
    const LinkEstimate* estimate = nullptr;
    std::size_t source = 0;  ///< index of the cell
    std::size_t target = 0;
    QPointF from;  ///< port points
    QPointF to;
    bool cut = false;
    QString mark;  ///< of a cut link: the letters at both of its ends
  };
  struct Patch {
    const PatchReconstruction* patch = nullptr;
    QRectF bounds;  ///< bounds of its hexagons; y up
  };

  GraphScene() = default;
  explicit GraphScene(std::shared_ptr<const Reconstruction> reconstruction)
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

  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }
  [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }
  [[nodiscard]] const QRectF& bounds() const { return bounds_; }
  /// Corners of a drawn hexagon about its centre, metres, before the cell's rotation; smaller than the real cell, so
  /// that there is room for the strokes between two of them.
  [[nodiscard]] const std::array<QPointF, 6>& outline() const { return outline_; }
  /// Centre to corner of a drawn hexagon, metres.
  [[nodiscard]] double radius_m() const { return radius_m_; }
  [[nodiscard]] bool hasExcludedLinks() const { return has_excluded_links_; }
  [[nodiscard]] std::size_t cutCount() const { return cut_count_; }
  [[nodiscard]] std::size_t longestId() const { return longest_id_; }  ///< in digits

  [[nodiscard]] std::optional<std::size_t> indexOf(CellId id) const {
    const auto found = index_of_.find(id);
    return found == index_of_.end() ? std::nullopt : std::optional(found->second);
  }

  [[nodiscard]] std::optional<std::size_t> indexOf(LinkEnd source, LinkEnd target) const {
    const auto cell = indexOf(source.cell);
    if (!cell) return std::nullopt;
    const auto ends = std::minmax(source, target);
    for (const std::size_t link : cells_[*cell].links) {
      const LinkEstimate& estimate = *links_[link].estimate;
      if (std::minmax(estimate.source, estimate.target) == ends) return link;
    }
    return std::nullopt;
  }

  /// Direction in which a link leaves one of its cells, unit length.
  [[nodiscard]] QPointF directionFrom(std::size_t cell, const Link& link) const {
    return unit((cell == link.source ? link.from : link.to) - cells_[cell].center);
  }

  /// The cell whose drawn hexagon covers the point.
  [[nodiscard]] std::optional<std::size_t> cellAt(const QPointF& point) const {
    // A circle between the hexagon's inner and outer one: nobody aims at a corner.
    return cellNear(point, 0.95 * radius_m_);
  }

  /// The nearest cell whose centre is within `tolerance_m` of the point.
  [[nodiscard]] std::optional<std::size_t> cellNear(const QPointF& point, double tolerance_m) const {
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

  /// The link that passes within `tolerance_m` of the point; of several the nearest.
  [[nodiscard]] std::optional<std::size_t> linkAt(const QPointF& point, double tolerance_m) const {
    std::optional<std::size_t> nearest;
    double smallest = tolerance_m;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const Link& link = links_[k];
      const QPointF& source = cells_[link.source].center;
      const QPointF& target = cells_[link.target].center;
      double distance = distanceWithin(smallest, point, source, link.from);
      distance = distanceWithin(distance, point, target, link.to);
      // The line between the patches belongs to an excluded link, too; a cut one ends at its ports.
      if (!link.cut) distance = distanceWithin(distance, point, link.from, link.to);
      if (distance >= smallest) continue;
      smallest = distance;
      nearest = k;
    }
    return nearest;
  }

  /// The neighbour that lies most in `direction` (unit length): one with a link if there is any, else the nearest cell.
  [[nodiscard]] std::optional<std::size_t> neighborToward(std::size_t cell, const QPointF& direction) const {
    constexpr double kMinAgreement = 0.25;
    std::optional<std::size_t> best;
    double best_agreement = kMinAgreement;
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

  /// True if both scenes have the same cells in the same places, so that a view can stay where it is.
  [[nodiscard]] bool hasSamePlacesAs(const GraphScene& other) const {
    return std::ranges::equal(cells_, other.cells_, [](const Cell& a, const Cell& b) {
      return a.id == b.id && lengthOf(a.center - b.center) < 1e-9;
    });
  }

 private:
  /// Share of the real hexagon that is drawn.
  static constexpr double kDrawnShare = 0.56;
  static QPointF toPoint(const Vector2d& point) { return {point.x(), point.y()}; }
  static double lengthOf(const QPointF& vector) { return std::hypot(vector.x(), vector.y()); }
  static QPointF unit(const QPointF& vector) {
    const double length = lengthOf(vector);
    return length > 0 ? vector / length : QPointF(1, 0);
  }

  static double distanceToSegment(const QPointF& point, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double squared = QPointF::dotProduct(along, along);
    const double part = squared > 0 ? std::clamp(QPointF::dotProduct(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return lengthOf(point - (a + part * along));
  }

  /// The distance, or `reach` where it is at least that: of most segments that is cheap to see.
  static double distanceWithin(double reach, const QPointF& point, const QPointF& a, const QPointF& b) {
    const bool may_be_near = point.x() >= std::min(a.x(), b.x()) - reach &&
                             point.x() <= std::max(a.x(), b.x()) + reach &&
                             point.y() >= std::min(a.y(), b.y()) - reach && point.y() <= std::max(a.y(), b.y()) + reach;
    return may_be_near ? std::min(reach, distanceToSegment(point, a, b)) : reach;
  }

  /// a, b, ... z, aa, ab, ...: as columns of a spreadsheet are named.
  static QString letters(std::size_t index) {
    QString text;
    for (++index; index > 0; index = (index - 1) / 26) text.prepend(QChar('a' + static_cast<int>((index - 1) % 26)));
    return text;
  }

  void addCells() {
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

  void addLinks() {
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
      has_excluded_links_ |= !estimate.used;
      links_.push_back({&estimate, *source, *target, toPoint(flat.from), toPoint(flat.to), flat.cut,
                        flat.cut ? letters(cut_count_++) : QString()});
    }
  }

  std::shared_ptr<const Reconstruction> reconstruction_;
  std::vector<Cell> cells_;
  std::vector<Link> links_;
  std::vector<Patch> patches_;
  QRectF bounds_;
  std::array<QPointF, 6> outline_;
  double radius_m_ = 0;
  bool has_excluded_links_ = false;
  std::size_t cut_count_ = 0;
  std::size_t longest_id_ = 1;
  std::unordered_map<CellId, std::size_t> index_of_;
};

}  // namespace hexoderm
