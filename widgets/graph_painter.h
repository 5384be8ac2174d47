#pragma once

#include "widgets/graph_scene.h"
#include "widgets/palette.h"

#include <QFont>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QSizeF>

namespace hexoderm {

/// Which part of the sheet is seen: `center` of it in the middle of the widget, `scale` pixels for a metre.
struct GraphCamera {
  QPointF center;
  double scale = 1;
  QSizeF size;

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
};

/// Draws a GraphScene with a level of detail that follows the size of the hexagons on the screen.
class GraphPainter {
 public:
  GraphPainter(const GraphScene& scene, const GraphCamera& camera, Theme theme, const QFont& font);

  /// Everything but what is picked and pointed at.
  void drawSheet(QPainter& painter) const;
  void drawCellOutline(QPainter& painter, std::size_t cell, const QColor& color, double width) const;
  void drawLinkOutline(QPainter& painter, std::size_t link, const QColor& color, double width) const;

 private:
  [[nodiscard]] bool isSeen(const QPointF& a, const QPointF& b) const;
  [[nodiscard]] QPolygonF hexagon(std::size_t cell) const;
  [[nodiscard]] QPen pen(const LinkStroke& stroke, double width) const;
  void drawLinks(QPainter& painter) const;
  void drawStrokes(QPainter& painter, const QVector<QLineF>& lines, const LinkStroke& stroke, bool in_tree) const;
  void drawMutedLink(QPainter& painter, const GraphScene::Link& link) const;
  void drawCutCurves(QPainter& painter) const;
  [[nodiscard]] QPainterPath cutCurve(const GraphScene::Link& link) const;
  void drawCells(QPainter& painter) const;
  void drawIds(QPainter& painter) const;
  void drawPorts(QPainter& painter) const;
  void drawCutMarks(QPainter& painter) const;
  void drawPatchCaptions(QPainter& painter) const;
  void addDirections(const QPointF& a, const QPointF& b, QVector<QLineF>& lines) const;

  const GraphScene& scene_;
  const GraphCamera& camera_;
  Theme theme_;
  const Colors& colors_;
  QFont font_;
  double radius_px_;      ///< of a drawn hexagon
  double separation_px_;  ///< between the two directions of a link
  QRectF seen_;           ///< the widget with a margin
};

}  // namespace hexoderm
