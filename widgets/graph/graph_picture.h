#pragma once

#include "widgets/graph/graph_legend.h"
#include "widgets/graph/graph_painter.h"

#include <memory>

namespace hexoderm {

/// The graph as it is seen at one moment, without what is picked. May be drawn and written on any thread, as often as
/// one likes.
class GraphPicture {
 public:
  /// `legend` and `marks` are drawn into `legend_area`; an empty area is for none.
  GraphPicture(std::shared_ptr<const GraphScene> scene, std::shared_ptr<const GraphPaint> paint, GraphCamera camera,
               GraphStyle style, GraphMarks marks, const QRectF& legend_area);

  void draw(QPainter& painter) const;
  /// Two pixels for one of the screen.
  [[nodiscard]] QImage image() const;
  /// By its ending: *.svg with shapes and texts, anything else as image(). False if it could not be written.
  [[nodiscard]] bool save(const QString& path) const;

 private:
  std::shared_ptr<const GraphScene> scene_;
  std::shared_ptr<const GraphPaint> paint_;
  GraphCamera camera_;
  GraphStyle style_;
  GraphMarks marks_;
  QRectF legend_area_;
};

}  // namespace hexoderm
