#pragma once

#include "widgets/plot/plot_data.h"

#include <qwt_plot_item.h>
#include <QString>
#include <optional>
#include <vector>

namespace hexoderm {

/// All that is drawn of a plot but its scales and grid: points or bars, limits, and what is brushed, picked and pointed
/// at. No meaning hangs on hue: points that are brushed are filled squares among hollow circles, bars are hatched as
/// far as they are brushed.
class PlotPicture : public QwtPlotItem {
 public:
  struct Marks {
    std::vector<bool> brushed;          ///< per point
    std::optional<std::size_t> picked;  ///< index of the point
    std::optional<std::size_t> hovered;
    std::optional<std::size_t> bin;  ///< where the keyboard is in a histogram
    QString picked_word;             ///< written beside it
  };

  PlotPicture();

  /// Both outlive the item.
  void show(const PlotData* data, const Marks* marks);
  /// Drawn where there are no points.
  void setHint(const QString& hint) { hint_ = hint; }

  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  void drawLimits(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;
  void drawPoints(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const;
  void drawBars(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const;
  void drawMarks(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;
  [[nodiscard]] bool anyBrushed() const;

  const PlotData* data_ = nullptr;
  const Marks* marks_ = nullptr;
  QString hint_;
};

}  // namespace hexoderm
