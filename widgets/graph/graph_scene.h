#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <QPointF>
#include <QRectF>
#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace hexoderm {

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
  explicit GraphScene(std::shared_ptr<const Reconstruction> reconstruction);

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
  [[nodiscard]] bool hasMutedLinks() const { return has_muted_links_; }
  [[nodiscard]] std::size_t cutCount() const { return cut_count_; }
  [[nodiscard]] std::size_t longestId() const { return longest_id_; }  ///< in digits

  [[nodiscard]] std::optional<std::size_t> indexOf(CellId id) const;
  [[nodiscard]] std::optional<std::size_t> indexOf(LinkEnd source, LinkEnd target) const;
  /// Direction in which a link leaves one of its cells, unit length.
  [[nodiscard]] QPointF directionFrom(std::size_t cell, const Link& link) const;

  /// The cell whose drawn hexagon covers the point.
  [[nodiscard]] std::optional<std::size_t> cellAt(const QPointF& point) const;
  /// The nearest cell whose centre is within `tolerance_m` of the point.
  [[nodiscard]] std::optional<std::size_t> cellNear(const QPointF& point, double tolerance_m) const;
  /// The link that passes within `tolerance_m` of the point; of several the nearest.
  [[nodiscard]] std::optional<std::size_t> linkAt(const QPointF& point, double tolerance_m) const;
  /// The neighbour that lies most in `direction` (unit length): one with a link if there is any, else the nearest cell.
  [[nodiscard]] std::optional<std::size_t> neighborToward(std::size_t cell, const QPointF& direction) const;
  /// True if both scenes have the same cells in the same places, so that a view can stay where it is.
  [[nodiscard]] bool hasSamePlacesAs(const GraphScene& other) const;

 private:
  void addCells();
  void addLinks();

  std::shared_ptr<const Reconstruction> reconstruction_;
  std::vector<Cell> cells_;
  std::vector<Link> links_;
  std::vector<Patch> patches_;
  QRectF bounds_;
  std::array<QPointF, 6> outline_;
  double radius_m_ = 0;
  bool has_muted_links_ = false;
  std::size_t cut_count_ = 0;
  std::size_t longest_id_ = 1;
  std::unordered_map<CellId, std::size_t> index_of_;
};

}  // namespace hexoderm
