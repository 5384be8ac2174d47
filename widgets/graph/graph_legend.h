#pragma once

#include "widgets/coloring/legend_rows.h"
#include "widgets/coloring/scale_strip.h"
#include "widgets/graph/graph_paint.h"

#include <QCoreApplication>
#include <QFont>
#include <QRectF>
#include <vector>

class QPainter;

namespace hexoderm {

/// Marks in the graph that the legend explains besides the colours.
struct GraphMarks {
  bool tree = false;
  bool excluded = false;
};

/// The legend below the graph: each class of colours with its line or fill, or a scale with its unit
/// and limits, and the marks.
class GraphLegend {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::GraphLegend)

 public:
  GraphLegend(const GraphPaint& paint, const GraphMarks& marks, Theme theme, const QFont& font);

  /// Its height in an area of this width; 0 if it does not fit in.
  [[nodiscard]] double heightFor(double width) const;
  /// `area` is as high as heightFor() its width.
  void draw(QPainter& painter, const QRectF& area) const;

 private:
  /// None if they don't fit.
  [[nodiscard]] LegendRows rowsIn(double room) const;
  [[nodiscard]] double rowHeight() const;
  [[nodiscard]] double titleWidth() const;
  [[nodiscard]] double scaleHeight() const;
  void drawScale(QPainter& painter, const QRectF& area) const;

  std::optional<ScaleStrip> scale_;
  QString title_;
  QString note_;
  std::vector<LegendRows::Entry> entries_;
  const Colors& colors_;
  QFont font_;
};

}  // namespace hexoderm
