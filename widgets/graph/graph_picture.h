#pragma once

#include "widgets/graph/graph_legend.h"
#include "widgets/graph/graph_painter.h"

#include <QFile>
#include <QSvgGenerator>
#include <memory>

namespace hexoderm {

/// The graph as it is seen at one moment, without what is picked. May be drawn and written on any thread, as often as
/// one likes.
struct GraphPicture {
  std::shared_ptr<const GraphScene> scene;
  std::shared_ptr<const GraphPaint> paint;
  GraphCamera camera;
  GraphStyle style;
  GraphMarks marks;    ///< in the legend
  QRectF legend_area;  ///< empty: without a legend

  void draw(QPainter& painter) const {
    painter.fillRect(QRectF(QPointF(0, 0), camera.size), Colors::of(style.theme).panel);
    GraphPainter(*scene, *paint, camera, style).drawSheet(painter);
    if (legend_area.isEmpty()) return;
    // In a zoomed view there is something behind it.
    const double top = legend_area.top() - 3;
    painter.fillRect(QRectF(0, top, camera.size.width(), camera.size.height() - top), Colors::of(style.theme).panel);
    GraphLegend(*paint, marks, style.theme, style.font).draw(painter, legend_area);
  }

  /// Two pixels for one of the screen.
  [[nodiscard]] QImage image() const {
    constexpr double kFineness = 2;
    QImage image((camera.size * kFineness).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(kFineness);
    QPainter painter(&image);
    draw(painter);
    return image;
  }

  /// By its ending: *.svg with shapes and texts, anything else as image(). False if it could not be written.
  [[nodiscard]] bool save(const QString& path) const {
    if (!path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive)) return image().save(path);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    QSvgGenerator generator;
    generator.setOutputDevice(&file);
    generator.setSize(camera.size.toSize());
    generator.setViewBox(QRectF(QPointF(0, 0), camera.size));
    generator.setTitle(QStringLiteral("Skin graph"));
    {
      GraphPicture shapes = *this;
      shapes.style.is_vector = true;
      QPainter painter(&generator);
      shapes.draw(painter);
    }
    return file.flush() && file.error() == QFileDevice::NoError;
  }
};

}  // namespace hexoderm
