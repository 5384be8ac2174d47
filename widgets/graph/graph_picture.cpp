#include "widgets/graph/graph_picture.h"

#include <QFile>
#include <QSvgGenerator>
#include <utility>

namespace hexoderm {

GraphPicture::GraphPicture(std::shared_ptr<const GraphScene> scene, std::shared_ptr<const GraphPaint> paint,
                           GraphCamera camera, GraphStyle style, GraphMarks marks, const QRectF& legend_area)
    : scene_(std::move(scene)),
      paint_(std::move(paint)),
      camera_(camera),
      style_(std::move(style)),
      marks_(marks),
      legend_area_(legend_area) {}

void GraphPicture::draw(QPainter& painter) const {
  painter.fillRect(QRectF(QPointF(0, 0), camera_.size), Colors::of(style_.theme).panel);
  GraphPainter(*scene_, *paint_, camera_, style_).drawSheet(painter);
  if (legend_area_.isEmpty()) return;
  // In a zoomed view there is something behind it.
  const double top = legend_area_.top() - 3;
  painter.fillRect(QRectF(0, top, camera_.size.width(), camera_.size.height() - top), Colors::of(style_.theme).panel);
  GraphLegend(*paint_, marks_, style_.theme, style_.font).draw(painter, legend_area_);
}

QImage GraphPicture::image() const {
  constexpr double kFineness = 2;
  QImage image((camera_.size * kFineness).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(kFineness);
  QPainter painter(&image);
  draw(painter);
  return image;
}

bool GraphPicture::save(const QString& path) const {
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

}  // namespace hexoderm
