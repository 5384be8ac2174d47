#pragma once

#include "widgets/coloring/scale_legend.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <QFont>
#include <QRectF>
#include <optional>

class QPainter;

namespace hexoderm {

/// A scale as legends draw it, the same below the graph and in the 3D view: a bar in the scale's colours with ticks,
/// the limits with their words, arrows at the ends where values lie beyond them, and over it, where wanted, how many
/// cells lie where. Fixed ends are drawn as stops.
class ScaleStrip {
 public:
  enum class Histogram { Shown, Hidden };

  ScaleStrip(ScaleLegend legend, ColorMap map, Theme theme, const QFont& font, Histogram histogram);

  /// Of what is drawn, pixels.
  [[nodiscard]] double height() const;
  void setPlace(const QPointF& top_left, double width);
  [[nodiscard]] QRectF place() const;
  /// The bar alone, without its arrows.
  [[nodiscard]] const QRectF& bar() const { return bar_; }

  /// `marked`: a value that is pointed at. `probed`: a bin that is looked at, see binInWords().
  void paint(QPainter& painter, std::optional<double> marked, std::optional<int> probed) const;

  /// The bin at a place; none beside the bar and its arrows.
  [[nodiscard]] std::optional<int> binAt(const QPointF& point) const;
  /// Where a value lies; beyond the ends, on the arrows.
  [[nodiscard]] double xOf(double value) const;
  [[nodiscard]] const ScaleLegend& legend() const { return legend_; }

 private:
  [[nodiscard]] double histogramHeight() const;
  void paintHistogram(QPainter& painter, std::optional<int> probed) const;
  void paintBar(QPainter& painter) const;
  void paintArrows(QPainter& painter) const;
  void paintTicks(QPainter& painter) const;
  void paintMark(QPainter& painter, double value) const;

  ScaleLegend legend_;
  ColorMap map_;
  const Colors& colors_;
  QFont font_;
  double row_;  ///< height of a line of text
  bool has_histogram_;
  QRectF bar_;
};

}  // namespace hexoderm
