#pragma once

#include "widgets/plot/plot_data.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <qwt_plot.h>
#include <qwt_plot_item.h>
#include <qwt_scale_map.h>
#include <QPainter>
#include <QPixmap>
#include <QPointF>
#include <QString>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
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

  PlotPicture() {
    setZ(10);
    setRenderHint(RenderAntialiased);
  }

  /// Both outlive the item.
  void show(const PlotData* data, const Marks* marks) {
    data_ = data;
    marks_ = marks;
  }

  /// Drawn where there are no points.
  void setHint(const QString& hint) { hint_ = hint; }

  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override {
    if (data_ == nullptr || marks_ == nullptr) return;
    painter->setFont(plot()->font());
    if (data_->points.empty()) {
      painter->setPen(Colors::of(plot()->palette()).text_muted);
      painter->drawText(canvas.adjusted(12, 8, -12, -8), Qt::AlignCenter | Qt::TextWordWrap, hint_);
      return;
    }
    if (data_->choice.is_histogram) drawBars(*painter, x, y);
    drawLimits(*painter, x, y, canvas);
    if (!data_->choice.is_histogram) drawPoints(*painter, x, y);
    drawMarks(*painter, x, y, canvas);
  }

 private:
  struct PlotPictureWords {
    Q_DECLARE_TR_FUNCTIONS(hexoderm::PlotPicture)
  };

  /// Points are smaller where there are many.
  static double pointRadius(std::size_t count) {
    constexpr std::size_t kFew = 200;
    constexpr std::size_t kMany = 2000;
    return count <= kFew ? 4 : count <= kMany ? 3 : 2;
  }

  enum class PointLook { Plain, Hollow, Brushed };
  /// `outlined`: apart from others that it lies on, which among thousands would leave nothing of them.
  static void drawPoint(QPainter& painter, const QPointF& at, double radius, PointLook look, const Colors& colors,
                        bool outlined) {
    const QPen outline = outlined ? QPen(colors.panel, 1) : QPen(Qt::NoPen);
    painter.setPen(look == PointLook::Plain ? outline : QPen(colors.text_muted, 1));
    painter.setBrush(look == PointLook::Plain ? QBrush(colors.accent) : QBrush(colors.panel));
    if (look != PointLook::Brushed) {
      painter.drawEllipse(at, radius, radius);
      return;
    }
    painter.setPen(outline);
    painter.setBrush(colors.selection);
    painter.drawRect(QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)));
  }

  /// A picture of a point: thousands are drawn from one.
  static QPixmap pointStamp(double radius, PointLook look, const Colors& colors, double pixel_ratio) {
    const int side = 2 * static_cast<int>(std::ceil(radius + 1)) + 1;
    QPixmap stamp(QSize(side, side) * pixel_ratio);
    stamp.setDevicePixelRatio(pixel_ratio);
    stamp.fill(Qt::transparent);
    QPainter painter(&stamp);
    painter.setRenderHint(QPainter::Antialiasing);
    drawPoint(painter, {0.5 * side, 0.5 * side}, radius, look, colors, false);
    return stamp;
  }

  void drawLimits(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
    const Colors& colors = Colors::of(plot()->palette());
    const PlotChoice& choice = data_->choice;
    const QFontMetricsF metrics(plot()->font());
    const auto pen = [&](Qt::PenStyle style) { painter.setPen(QPen(colors.text, 1.2, style)); };
    const auto word = [&](const QPointF& at, const QString& text) {
      const QRectF box(at, QSizeF(metrics.horizontalAdvance(text) + 4, metrics.height()));
      painter.fillRect(box, colors.panel);
      painter.setPen(colors.text);
      painter.drawText(box, Qt::AlignCenter, text);
    };
    for (const PlotLimit& limit : plotLimits(choice.x)) {
      const double at = x.transform(limit.value);
      if (at < canvas.left() || at > canvas.right()) continue;
      pen(Qt::DashLine);
      painter.drawLine(QPointF(at, canvas.top()), QPointF(at, canvas.bottom()));
      const double width = metrics.horizontalAdvance(limit.word) + 4;
      word({at + 3 + width > canvas.right() ? at - 3 - width : at + 3, canvas.top() + 1}, limit.word);
    }
    if (choice.is_histogram) return;
    for (const PlotLimit& limit : plotLimits(choice.y)) {
      const double at = y.transform(limit.value);
      if (at < canvas.top() || at > canvas.bottom()) continue;
      pen(Qt::DashLine);
      painter.drawLine(QPointF(canvas.left(), at), QPointF(canvas.right(), at));
      const double above = at - metrics.height() - 1;
      word({canvas.right() - metrics.horizontalAdvance(limit.word) - 6, above < canvas.top() ? at + 1 : above},
           limit.word);
    }
    // What is predicted and what has come are compared by eye.
    const bool beside_prediction =
        choice.subject == PlotSubject::Links &&
        std::minmax(choice.x, choice.y) == std::minmax(PlotFigure(Coloring::Residual), PlotFigure(Coloring::Deviation));
    if (!beside_prediction) return;
    pen(Qt::DotLine);
    const double end = std::min(x.s2(), y.s2());
    painter.drawLine(QPointF(x.transform(0), y.transform(0)), QPointF(x.transform(end), y.transform(end)));
    const QString as_predicted = PlotPictureWords::tr("as predicted");
    const double at = 0.72 * end;
    word({std::min(x.transform(at) + 6, canvas.right() - metrics.horizontalAdvance(as_predicted) - 6), y.transform(at)},
         as_predicted);
  }

  void drawPoints(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const {
    const Colors& colors = Colors::of(plot()->palette());
    const std::vector<PlotPoint>& points = data_->points;
    const double radius = pointRadius(points.size());
    const PointLook others = anyBrushed() ? PointLook::Hollow : PointLook::Plain;
    constexpr std::size_t kAsStamps = 400;
    const double ratio = painter.device() != nullptr ? painter.device()->devicePixelRatioF() : 1;
    const bool stamped = points.size() > kAsStamps;
    const QPixmap plain = stamped ? pointStamp(radius, others, colors, ratio) : QPixmap();
    const QPixmap brushed = stamped ? pointStamp(radius, PointLook::Brushed, colors, ratio) : QPixmap();
    // What is brushed lies on top.
    for (const bool wanted : {false, true}) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (marks_->brushed[k] != wanted) continue;
        const QPointF at(x.transform(points[k].x), y.transform(points[k].y));
        if (stamped) {
          const QPixmap& stamp = wanted ? brushed : plain;
          const double half = 0.5 * stamp.width() / ratio;
          painter.drawPixmap(QPointF(std::round(at.x() - half), std::round(at.y() - half)), stamp);
        } else {
          drawPoint(painter, at, radius, wanted ? PointLook::Brushed : others, colors, true);
        }
      }
    }
  }

  void drawBars(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y) const {
    const Colors& colors = Colors::of(plot()->palette());
    std::vector<std::size_t> brushed(data_->bins.size());
    for (std::size_t k = 0; k < data_->points.size(); ++k) {
      if (!marks_->brushed[k]) continue;
      if (const auto bin = binOf(data_->bins, data_->points[k].x)) ++brushed[*bin];
    }
    for (std::size_t k = 0; k < data_->bins.size(); ++k) {
      const ValueBin& bin = data_->bins[k];
      const auto bar = [&](std::size_t count) {
        return QRectF(QPointF(x.transform(bin.lower), y.transform(static_cast<double>(count))),
                      QPointF(x.transform(bin.upper), y.transform(0)));
      };
      if (bin.count > 0) {
        painter.setPen(QPen(colors.panel, 1));
        painter.setBrush(colors.accent);
        painter.drawRect(bar(bin.count));
      }
      if (brushed[k] > 0) {
        painter.setPen(QPen(colors.selection, 1.5));
        painter.setBrush(QBrush(colors.selection, Qt::BDiagPattern));
        painter.drawRect(bar(brushed[k]));
      }
      if (marks_->bin == k) {
        painter.setPen(QPen(colors.selection, 2.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar(std::max<std::size_t>(bin.count, 1)).adjusted(-1, -1, 1, 0));
      }
    }
  }

  void drawMarks(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
    const Colors& colors = Colors::of(plot()->palette());
    const auto ring = [&](std::size_t point, double radius, const QPen& pen) {
      const PlotPoint& marked = data_->points[point];
      const double height = data_->choice.is_histogram ? canvas.bottom() - 6 : y.transform(marked.y);
      const QPointF at(x.transform(marked.x), height);
      painter.setBrush(Qt::NoBrush);
      painter.setPen(pen);
      painter.drawEllipse(at, radius, radius);
      return at;
    };
    const double radius = pointRadius(data_->points.size());
    if (marks_->hovered) ring(*marks_->hovered, radius + 3, QPen(colors.text_muted, 1.5));
    if (!marks_->picked) return;
    ring(*marks_->picked, radius + 4.5, QPen(colors.panel, 4.5));
    const QPointF at = ring(*marks_->picked, radius + 4.5, QPen(colors.selection, 2.2));
    QFont bold = plot()->font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    const QFontMetricsF metrics(bold);
    const QSizeF size(metrics.horizontalAdvance(marks_->picked_word) + 6, metrics.height());
    const double aside = radius + 8;
    const double left = at.x() + aside + size.width() > canvas.right() ? at.x() - aside - size.width() : at.x() + aside;
    const QRectF box(QPointF(left, std::clamp(at.y() - 0.5 * size.height(), canvas.top(),
                                              std::max(canvas.top(), canvas.bottom() - size.height()))),
                     size);
    painter.fillRect(box, colors.panel);
    painter.setPen(colors.text);
    painter.drawText(box, Qt::AlignCenter, marks_->picked_word);
  }

  [[nodiscard]] bool anyBrushed() const { return std::ranges::find(marks_->brushed, true) != marks_->brushed.end(); }

  const PlotData* data_ = nullptr;
  const Marks* marks_ = nullptr;
  QString hint_;
};

}  // namespace hexoderm
