#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <algorithm>

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

}  // namespace hexoderm
