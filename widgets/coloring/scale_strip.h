#pragma once

#include "widgets/coloring/scale_legend.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <QFont>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A scale as legends draw it, the same below the graph and in the 3D view: a bar in the scale's colours with ticks,
/// the limits with their words, arrows at the ends where values lie beyond them, and over it, where wanted, how many
/// cells lie where. Fixed ends are drawn as stops.
class ScaleStrip {
 public:
  enum class Histogram { Shown, Hidden };

  ScaleStrip(ScaleLegend legend, ColorMap map, Theme theme, const QFont& font, Histogram histogram)
      : legend_(std::move(legend)),
        map_(std::move(map)),
        colors_(Colors::of(theme)),
        font_(font),
        row_(std::ceil(QFontMetricsF(font).height())),
        has_histogram_(histogram == Histogram::Shown) {}

  /// Of what is drawn, pixels.
  [[nodiscard]] double height() const { return std::ceil(histogramHeight() + (kBarHeight + kTick + 1) * row_); }
  void setPlace(const QPointF& top_left, double width) {
    const double arrow = kArrow * row_ + 1;
    bar_ = QRectF(top_left.x() + arrow, top_left.y() + histogramHeight(), std::max(1.0, width - 2 * arrow),
                  kBarHeight * row_);
  }

  [[nodiscard]] QRectF place() const {
    const double arrow = kArrow * row_ + 1;
    return {bar_.left() - arrow, bar_.top() - histogramHeight(), bar_.width() + 2 * arrow, height()};
  }

  /// The bar alone, without its arrows.
  [[nodiscard]] const QRectF& bar() const { return bar_; }

  /// `marked`: a value that is pointed at. `probed`: a bin that is looked at, see binText().
  void paint(QPainter& painter, std::optional<double> marked, std::optional<int> probed) const {
    painter.save();
    painter.setFont(font_);
    painter.setRenderHint(QPainter::Antialiasing);
    if (has_histogram_) paintHistogram(painter, probed);
    paintBar(painter);
    paintArrows(painter);
    paintTicks(painter);
    if (marked && std::isfinite(*marked)) paintMark(painter, *marked);
    painter.restore();
  }

  /// The bin at a place; none beside the bar and its arrows.
  [[nodiscard]] std::optional<int> binAt(const QPointF& point) const {
    if (!place().contains(point)) return std::nullopt;
    const auto bins = static_cast<int>(legend_.counts.counts.size());
    if (point.x() < bar_.left()) return -1;
    if (point.x() >= bar_.right()) return point.x() < bar_.right() + 1 ? bins - 1 : bins;
    return std::min(static_cast<int>((point.x() - bar_.left()) / bar_.width() * bins), bins - 1);
  }

  /// Where a value lies; beyond the ends, on the arrows.
  [[nodiscard]] double xOf(double value) const {
    const double t = (value - legend_.range.low) / (legend_.range.high - legend_.range.low);
    const double beyond = 0.6 * kArrow * row_ / bar_.width();
    if (t < -1e-9) return bar_.left() - beyond * bar_.width();
    if (t > 1 + 1e-9) return bar_.right() + beyond * bar_.width();
    return bar_.left() + std::clamp(t, 0.0, 1.0) * bar_.width();
  }

  [[nodiscard]] const ScaleLegend& legend() const { return legend_; }

 private:
  // Shares of the height of a line of text.
  static constexpr double kBarHeight = 0.62;
  static constexpr double kHistogramHeight = 1.15;
  static constexpr double kArrow = 0.62;  // length
  static constexpr double kTick = 0.22;
  static constexpr double kMarkSize = 0.34;
  static constexpr double kMinColumn = 0.14;  // of a bin with a single cell among thousands

  [[nodiscard]] double histogramHeight() const { return (has_histogram_ ? kHistogramHeight : kMarkSize) * row_; }
  void paintHistogram(QPainter& painter, std::optional<int> probed) const {
    const std::size_t largest = legend_.counts.largest();
    const std::size_t bins = legend_.counts.counts.size();
    const double width = bar_.width() / static_cast<double>(bins);
    const double room = histogramHeight() - 2;
    painter.setPen(Qt::NoPen);
    for (std::size_t k = 0; k < bins; ++k) {
      const QRectF column(bar_.left() + static_cast<double>(k) * width, bar_.top() - room, width, room);
      if (probed == static_cast<int>(k)) painter.fillRect(column, colors_.border);
      if (legend_.counts.counts[k] == 0) continue;
      const double share = static_cast<double>(legend_.counts.counts[k]) / static_cast<double>(largest);
      const double height = room * std::max(kMinColumn, share);
      painter.fillRect(QRectF(column.left() + 0.5, bar_.top() - height, std::max(1.0, width - 1), height),
                       toQColor(onScale(map_.steps, (static_cast<double>(k) + 0.5) / static_cast<double>(bins))));
    }
  }

  void paintBar(QPainter& painter) const {
    QLinearGradient gradient(bar_.topLeft(), bar_.topRight());
    constexpr int kStops = 32;
    for (int k = 0; k <= kStops; ++k) {
      const double t = static_cast<double>(k) / kStops;
      gradient.setColorAt(t, toQColor(onScale(map_.steps, t)));
    }
    painter.setPen(QPen(colors_.text_muted, 1));
    painter.setBrush(gradient);
    painter.drawRect(bar_);
    if (!legend_.is_fixed) return;
    painter.setPen(QPen(colors_.text, 2.4, Qt::SolidLine, Qt::FlatCap));
    for (const double x : {bar_.left(), bar_.right()}) {
      painter.drawLine(QPointF(x, bar_.top() - 3), QPointF(x, bar_.bottom() + 3));
    }
  }

  void paintArrows(QPainter& painter) const {
    const double length = kArrow * row_;
    const QFontMetricsF metrics(font_);
    const auto arrow = [&](double at, double direction, const Rgb& color, std::size_t count) {
      if (count == 0) return;
      const QPolygonF tip({QPointF(at + direction, bar_.top()), QPointF(at + direction * length, bar_.center().y()),
                           QPointF(at + direction, bar_.bottom())});
      painter.setPen(QPen(colors_.text_muted, 1));
      painter.setBrush(toQColor(color));
      painter.drawPolygon(tip);
      if (!has_histogram_) return;
      const QString number = QLocale().toString(static_cast<qulonglong>(count));
      const double width = metrics.horizontalAdvance(number) + 2;
      painter.setPen(colors_.text);
      const double left = direction > 0 ? at + 1 : at - 1 - width;
      painter.drawText(QRectF(left, bar_.top() - row_ - 1, width, row_), Qt::AlignCenter, number);
    };
    arrow(bar_.left(), -1, map_.below, legend_.counts.below);
    arrow(bar_.right(), 1, map_.above, legend_.counts.above);
  }

  void paintTicks(QPainter& painter) const {
    const QFontMetricsF metrics(font_);
    const double top = bar_.bottom() + kTick * row_;
    std::vector<QRectF> taken;
    const auto write = [&](double value, const QString& text, const QColor& color) {
      const double width = metrics.horizontalAdvance(text) + 2;
      const double left = std::clamp(xOf(value) - 0.5 * width, place().left(), place().right() - width);
      const QRectF box(left, top, width, row_);
      const bool is_free =
          std::ranges::none_of(taken, [&](const QRectF& other) { return other.adjusted(-4, 0, 4, 0).intersects(box); });
      if (!is_free) return;
      taken.push_back(box);
      painter.setPen(color);
      painter.drawText(box, Qt::AlignCenter, text);
    };
    for (const ScaleLimit& limit : legend_.limits) {
      if (limit.value < legend_.range.low || limit.value > legend_.range.high) continue;
      const double x = xOf(limit.value);
      const double above = has_histogram_ ? histogramHeight() - 2 : 3;
      const auto line = QLineF(x, bar_.top() - above, x, top + 1);
      // Seen on every colour of the bar.
      painter.setPen(QPen(colors_.panel, 4, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(line);
      painter.setPen(
          QPen(colors_.text, 2, limit.kind == ScaleLimit::Kind::Goal ? Qt::SolidLine : Qt::DashLine, Qt::FlatCap));
      painter.drawLine(line);
      write(limit.value, limitWord(limit.kind) + QLatin1Char(' ') + QLocale().toString(limit.value, 'g', 6),
            colors_.text);
    }
    const auto most = static_cast<std::size_t>(
        std::clamp(bar_.width() / (metrics.horizontalAdvance(QStringLiteral("−0.00")) + 14), 2.0, 7.0));
    const ValueTicks ticks = roundTicks(legend_.range, most);
    painter.setPen(QPen(colors_.text_muted, 1));
    for (const double tick : ticks.values) {
      painter.drawLine(QPointF(xOf(tick), bar_.bottom()), QPointF(xOf(tick), top));
    }
    for (const double tick : ticks.values)
      write(tick, QLocale().toString(tick, 'f', ticks.decimals), colors_.text_muted);
  }

  void paintMark(QPainter& painter, double value) const {
    const double x = xOf(value);
    const double size = kMarkSize * row_;
    painter.setPen(QPen(colors_.panel, 3.6, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, bar_.top()), QPointF(x, bar_.bottom()));
    painter.setPen(QPen(colors_.selection, 1.6, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, bar_.top()), QPointF(x, bar_.bottom()));
    painter.setPen(QPen(colors_.panel, 1));
    painter.setBrush(colors_.selection);
    painter.drawPolygon(QPolygonF({QPointF(x - size, bar_.top() - 1.5 * size),
                                   QPointF(x + size, bar_.top() - 1.5 * size), QPointF(x, bar_.top())}));
  }

  ScaleLegend legend_;
  ColorMap map_;
  const Colors& colors_;
  QFont font_;
  double row_;  ///< height of a line of text
  bool has_histogram_;
  QRectF bar_;
};

}  // namespace hexoderm
