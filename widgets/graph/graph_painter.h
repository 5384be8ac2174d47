#pragma once

#include "widgets/graph/graph_camera.h"
#include "widgets/graph/graph_paint.h"
#include "widgets/graph/graph_scene.h"
#include "widgets/style/palette.h"

#include <QFont>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

namespace hexoderm {

/// The style that a graph is drawn in, on the screen and in files.
struct GraphStyle {
  Theme theme = Theme::Light;
  QFont font;
  bool marks_tree = true;
  bool has_text = true;    ///< IDs, ports, captions; pictures that are compared go without
  bool is_vector = false;  ///< everything is a shape of its own, as files that can be enlarged want it
};

/// Draws a GraphScene with a level of detail that follows the size of the hexagons on the screen, and how many of them
/// there are: thousands are drawn from one stamp, without smoothing.
class GraphPainter {
 public:
  /// All must outlive the painter.
  GraphPainter(const GraphScene& scene, const GraphPaint& paint, const GraphCamera& camera, const GraphStyle& style);

  /// Everything but what is picked and pointed at.
  void drawSheet(QPainter& painter) const;
  void drawCellOutline(QPainter& painter, std::size_t cell, const QColor& color, double width) const;
  void drawLinkOutline(QPainter& painter, std::size_t link, const QColor& color, double width) const;
  /// A hexagon inside the cell's own, in black or white, whichever is seen on its colour.
  void drawBrushMark(QPainter& painter, std::size_t cell) const;
  /// The area of these outlines, so that nothing else needs to be drawn anew.
  [[nodiscard]] QRectF outlineBounds(std::size_t cell) const;
  [[nodiscard]] QRectF linkOutlineBounds(std::size_t link) const;

 private:
  /// A cell's looks: its fill and whether it is the origin or was placed by its links.
  struct CellKind {
    std::int16_t fill = GraphPaint::kPlain;
    bool origin = false;
    bool by_links = false;
  };

  [[nodiscard]] bool isSeen(const QPointF& a, const QPointF& b) const;
  template <class Draw>
  void forEachPiece(const GraphScene::Link& link, Draw draw) const;
  [[nodiscard]] QPolygonF hexagon(const QPointF& center, double angle_rad) const;
  [[nodiscard]] QPolygonF hexagon(std::size_t cell) const;
  [[nodiscard]] CellKind kindOf(std::size_t cell) const;
  [[nodiscard]] QColor fillColor(std::int16_t fill) const;
  [[nodiscard]] QColor fillOf(std::size_t cell) const { return fillColor(paint_.of_cell[cell]); }
  void choosePens(QPainter& painter, const CellKind& kind) const;
  void drawLinks(QPainter& painter) const;
  void drawTree(QPainter& painter) const;
  void drawStrokes(QPainter& painter, const QVector<QLineF>& lines, const LinkStroke& stroke) const;
  void drawExcludedLinks(QPainter& painter) const;
  void drawCutCurves(QPainter& painter) const;
  [[nodiscard]] QPainterPath cutCurve(const GraphScene::Link& link) const;
  void drawCells(QPainter& painter) const;
  [[nodiscard]] bool dotsAreUnderLinks() const;
  void drawDots(QPainter& painter) const;
  void drawOriginsAsDots(QPainter& painter) const;
  void drawStamps(QPainter& painter) const;
  [[nodiscard]] QImage stamp(const CellKind& kind, double angle_rad, double pixel_ratio) const;
  void drawIds(QPainter& painter) const;
  void drawPorts(QPainter& painter) const;
  void drawCutMarks(QPainter& painter) const;
  void drawPatchCaptions(QPainter& painter) const;
  void addDirections(const QPointF& a, const QPointF& b, QVector<QLineF>& lines) const;

  const GraphScene& scene_;
  const GraphPaint& paint_;
  const GraphCamera& camera_;
  const GraphStyle& style_;
  const Colors& colors_;
  double radius_px_;      ///< radius of a drawn hexagon
  double separation_px_;  ///< between the two directions of a link
  QRectF seen_;           ///< the widget with a margin
  bool is_crowded_;       ///< so many are seen that each must be cheap
};

}  // namespace hexoderm
