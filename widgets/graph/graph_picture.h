#pragma once

#include "widgets/graph/graph_legend.h"
#include "widgets/graph/graph_painter.h"

#include <QFile>
#include <QSvgGenerator>
#include <memory>
#include <utility>

namespace hexoderm {

/// The graph as it is seen at one moment, without what is picked. May be drawn and written on any thread, as often as
/// one likes.
class GraphPicture {
 public:
  /// `legend` and `marks` are drawn into `legend_area`; an empty area is for none.
  GraphPicture(std::shared_ptr<const GraphScene> scene, std::shared_ptr<const GraphPaint> paint, GraphCamera camera,
               GraphStyle style, GraphMarks marks, const QRectF& legend_area)
      : scene_(std::move(scene)),
        paint_(std::move(paint)),
        camera_(camera),
        style_(std::move(style)),
        marks_(marks),
        legend_area_(legend_area) {}

  void draw(QPainter& painter) const {
    painter.fillRect(QRectF(QPointF(0, 0), camera_.size), Colors::of(style_.theme).panel);
    GraphPainter(*scene_, *paint_, camera_, style_).drawSheet(painter);
    if (legend_area_.isEmpty()) return;
    // In a zoomed view there is something behind it.
    const double top = legend_area_.top() - 3;
    painter.fillRect(QRectF(0, top, camera_.size.width(), camera_.size.height() - top), Colors::of(style_.theme).panel);
    GraphLegend(*paint_, marks_, style_.theme, style_.font).draw(painter, legend_area_);
  }

  /// Two pixels for one of the screen.
  [[nodiscard]] QImage image() const {
    constexpr double kFineness = 2;
    QImage image((camera_.size * kFineness).toSize(), QImage::Format_RGB32);
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
    generator.setSize(camera_.size.toSize());
    generator.setViewBox(QRectF(QPointF(0, 0), camera_.size));
    generator.setTitle(QStringLiteral("Skin graph"));
    {
      GraphPicture shapes = *this;
      shapes.style_.is_vector = true;
      QPainter painter(&generator);
      shapes.draw(painter);
    }
    return file.flush() && file.error() == QFileDevice::NoError;
  }

 private:
  std::shared_ptr<const GraphScene> scene_;
  std::shared_ptr<const GraphPaint> paint_;
  GraphCamera camera_;
  GraphStyle style_;
  GraphMarks marks_;
  QRectF legend_area_;
};

}  // namespace hexoderm
