#include "app/window/report/report_plots.h"

#include "hexoderm/base/units.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

struct ReportPlots {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPlots)
};

// In points.
constexpr double kTickText = 7;
constexpr double kTick = 2.5;
constexpr double kHairline = 0.5;
constexpr double kScaleBar = 4;

/// 1, 2 or 5 times a power of ten: at most four steps to the largest value.
double valueStep(double largest) {
  constexpr double kSteps = 4;
  for (double decade = std::pow(10.0, std::floor(std::log10(largest / kSteps)));; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * decade * kSteps >= largest * (1 - 1e-9)) return step * decade;
    }
  }
}

int decimalsOf(double width) { return std::max(0, static_cast<int>(std::ceil(-std::log10(width) - 1e-9))); }

/// Lines across a plot with their figures at its left, and what both axes are.
struct Grid {
  struct Line {
    double y;
    QString figure;
  };
  QRectF area;
  QRectF frame;  ///< of what is plotted
  std::vector<Line> lines;
  QString value;  ///< over the vertical axis
  QString axis;   ///< below the horizontal one
};

void drawGrid(const Grid& grid, QPainter& painter, const QFontMetricsF& metrics, double point) {
  const Colors& colors = Colors::of(Theme::Light);
  const QRectF& area = grid.area;
  const QRectF& frame = grid.frame;
  for (const Grid::Line& line : grid.lines) {
    painter.setPen(QPen(colors.border, kHairline * point));
    painter.drawLine(QPointF(frame.left(), line.y), QPointF(frame.right(), line.y));
    painter.setPen(colors.text_muted);
    painter.drawText(
        QRectF(area.left(), line.y - metrics.height(), frame.left() - area.left() - 3 * point, 2 * metrics.height()),
        Qt::AlignRight | Qt::AlignVCenter, line.figure);
  }
  painter.drawText(QRectF(area.left(), area.top(), area.width(), metrics.height()), Qt::AlignLeft | Qt::AlignTop,
                   grid.value);
  painter.drawText(QRectF(frame.left(), area.bottom() - metrics.height(), frame.width(), metrics.height()),
                   Qt::AlignHCenter | Qt::AlignBottom, grid.axis);
}

class HistogramPainter {
 public:
  HistogramPainter(const HistogramPlot& plot, QPainter& painter, const QRectF& area, double point)
      : plot_(plot),
        bins_(plot.distribution.bins),
        painter_(painter),
        point_(point),
        font_(reportFont(kTickText * point)),
        metrics_(font_),
        colors_(Colors::of(Theme::Light)) {
    std::size_t largest = 1;
    for (const ValueBin& bin : bins_) largest = std::max(largest, bin.count);
    step_ = static_cast<std::size_t>(std::round(valueStep(static_cast<double>(largest))));
    top_ = step_ * ((largest + step_ - 1) / step_);
    const double left = metrics_.horizontalAdvance(QLocale().toString(static_cast<qulonglong>(top_))) + 6 * point_;
    const double below = 2 * metrics_.height() + (kTick + 3) * point_ + (plot.is_legend ? kScaleBar * point_ : 0);
    const double above = metrics_.height() * (plot.marks.empty() ? 1.3 : 3.4);
    frame_ = area.adjusted(left, above, -6 * point_, -below);
    area_ = area;
  }

  void draw() {
    painter_.setFont(font_);
    drawCounts();
    drawBars();
    drawMarks();
    drawAxis();
  }

 private:
  [[nodiscard]] double x(double value) const {
    const Distribution& d = plot_.distribution;
    return frame_.left() + frame_.width() * (value - d.lower()) / (d.upper() - d.lower());
  }
  [[nodiscard]] double y(std::size_t count) const {
    return frame_.bottom() - frame_.height() * static_cast<double>(count) / static_cast<double>(top_);
  }

  void drawCounts() {
    Grid grid{area_, frame_, {}, plot_.count, plot_.axis};
    for (std::size_t count = 0; count <= top_; count += step_) {
      grid.lines.push_back({y(count), QLocale().toString(static_cast<qulonglong>(count))});
    }
    drawGrid(grid, painter_, metrics_, point_);
  }

  void drawBars() {
    const double between = bins_.size() > 1 ? kHairline * point_ : 0;
    for (const ValueBin& bin : bins_) {
      if (bin.count == 0) continue;
      const double middle = (bin.lower + bin.upper) / 2;
      const Distribution& d = plot_.distribution;
      painter_.setPen(plot_.is_legend ? QPen(colors_.text_muted, kHairline * point_ / 2) : QPen(Qt::NoPen));
      painter_.setBrush(plot_.is_legend ? reportScale((middle - d.lower()) / (d.upper() - d.lower())) : colors_.accent);
      painter_.drawRect(
          QRectF(QPointF(x(bin.lower) + between, y(bin.count)), QPointF(x(bin.upper) - between, frame_.bottom())));
    }
  }

  void drawMarks() {
    // One above the other where they are near each other.
    double free_from = frame_.left();
    int row = 0;
    for (const HistogramPlot::Mark& mark : plot_.marks) {
      const Distribution& d = plot_.distribution;
      if (bins_.empty() || mark.value < d.lower() || mark.value > d.upper()) continue;
      const double width = metrics_.horizontalAdvance(mark.word);
      const double at = std::clamp(x(mark.value), frame_.left() + width / 2, frame_.right() - width / 2);
      row = at - width / 2 < free_from ? 1 - row : 0;
      free_from = at + width / 2 + 4 * point_;
      const double base = frame_.top() - (row == 0 ? 0 : metrics_.height());
      painter_.setPen(QPen(colors_.text, 0.9 * point_, Qt::DashLine));
      painter_.drawLine(QPointF(x(mark.value), base), QPointF(x(mark.value), frame_.bottom()));
      painter_.setPen(colors_.text);
      painter_.drawText(QRectF(at - width, base - metrics_.height() - point_, 2 * width, metrics_.height()),
                        Qt::AlignHCenter | Qt::AlignVCenter, mark.word);
    }
  }

  void drawAxis() {
    double base = frame_.bottom();
    if (plot_.is_legend) {
      constexpr int kPieces = 96;
      painter_.setPen(Qt::NoPen);
      for (int k = 0; k < kPieces; ++k) {
        painter_.setBrush(reportScale((k + 0.5) / kPieces));
        painter_.drawRect(QRectF(frame_.left() + frame_.width() * k / kPieces, base, frame_.width() / kPieces * 1.2,
                                 kScaleBar * point_)
                              .intersected(QRectF(frame_.left(), base, frame_.width(), kScaleBar * point_)));
      }
      base += kScaleBar * point_;
    }
    painter_.setPen(QPen(colors_.text_muted, kHairline * point_));
    painter_.drawLine(QPointF(frame_.left(), base), QPointF(frame_.right(), base));
    if (!bins_.empty()) drawTicks(base);
  }

  void drawTicks(double base) {
    const double width = bins_.front().upper - bins_.front().lower;
    const int decimals = decimalsOf(width);
    // Every edge, or every second, fifth ... as there is room for their numbers.
    const double room = 1.6 * std::max(metrics_.horizontalAdvance(figureText(bins_.front().lower, decimals)),
                                       metrics_.horizontalAdvance(figureText(bins_.back().upper, decimals)));
    std::size_t every = 1;
    while (frame_.width() / static_cast<double>(bins_.size()) * static_cast<double>(every) < room) ++every;
    for (std::size_t k = 0; k <= bins_.size(); k += every) {
      const double value = k < bins_.size() ? bins_[k].lower : bins_.back().upper;
      painter_.setPen(QPen(colors_.text_muted, kHairline * point_));
      painter_.drawLine(QPointF(x(value), base), QPointF(x(value), base + kTick * point_));
      painter_.setPen(colors_.text);
      painter_.drawText(QRectF(x(value) - room, base + (kTick + 1) * point_, 2 * room, metrics_.height()),
                        Qt::AlignHCenter | Qt::AlignTop, figureText(value, decimals));
    }
  }

  const HistogramPlot& plot_;
  const std::vector<ValueBin>& bins_;
  QPainter& painter_;
  double point_;
  QFont font_;
  QFontMetricsF metrics_;
  const Colors& colors_;
  QRectF area_;
  QRectF frame_;
  std::size_t step_ = 1;
  std::size_t top_ = 1;
};

void drawBoxes(const BoxPlot& plot, QPainter& painter, const QRectF& area, double point) {
  const Colors& colors = Colors::of(Theme::Light);
  const QFont font = reportFont(kTickText * point);
  const QFontMetricsF metrics(font);
  double largest = 1e-9;
  for (const PoseResiduals& pose : plot.poses) largest = std::max(largest, toDegrees(pose.largest));
  const double step = valueStep(largest);
  const double top = step * std::ceil(largest / step - 1e-9);
  const int decimals = decimalsOf(step);
  const double left = metrics.horizontalAdvance(figureText(top, decimals)) + 6 * point;
  const QRectF frame = area.adjusted(left, 1.5 * metrics.height(), 0, -2.3 * metrics.height());
  const auto y = [&](double degrees) { return frame.bottom() - frame.height() * degrees / top; };
  painter.setFont(font);
  Grid grid{area, frame, {}, plot.value, plot.axis};
  for (double value = 0; value <= top * (1 + 1e-9); value += step) {
    grid.lines.push_back({y(value), figureText(value, decimals)});
  }
  drawGrid(grid, painter, metrics, point);
  const double width = frame.width() / static_cast<double>(std::max<std::size_t>(1, plot.poses.size()));
  double free_from = frame.left() - width;
  for (std::size_t k = 0; k < plot.poses.size(); ++k) {
    const PoseResiduals& pose = plot.poses[k];
    const double x = frame.left() + width * (static_cast<double>(k) + 0.5);
    const double half = std::min(width * 0.3, 8 * point);
    painter.setPen(QPen(colors.text, 0.7 * point));
    painter.drawLine(QPointF(x, y(toDegrees(pose.least))), QPointF(x, y(toDegrees(pose.largest))));
    painter.setBrush(colors.accent);
    painter.setPen(Qt::NoPen);
    painter.drawRect(QRectF(QPointF(x - half, y(toDegrees(pose.upper_quartile))),
                            QPointF(x + half, y(toDegrees(pose.lower_quartile)))));
    painter.setPen(QPen(Qt::white, 1.1 * point, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x - half, y(toDegrees(pose.median))), QPointF(x + half, y(toDegrees(pose.median))));
    const QString id = QString::number(pose.pose.value());
    const double room = metrics.horizontalAdvance(id) + 3 * point;
    if (x - room / 2 < free_from) continue;
    free_from = x + room / 2;
    painter.setPen(colors.text);
    painter.drawText(QRectF(x - room, frame.bottom() + 2 * point, 2 * room, metrics.height()),
                     Qt::AlignHCenter | Qt::AlignTop, id);
  }
}

}  // namespace

QFont reportFont(double pixels, bool is_bold) {
  QFont font(QStringLiteral("Inter"));
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(pixels))));
  if (is_bold) font.setWeight(QFont::DemiBold);
  return font;
}

QColor reportColor(Tone tone) {
  return tone == Tone::Neutral ? Colors::of(Theme::Light).text : toneColor(tone, Theme::Light);
}

QColor reportTint(const QColor& color) {
  constexpr double kShare = 0.08;
  const auto mix = [](double channel) { return 1 - kShare * (1 - channel); };
  return QColor::fromRgbF(mix(color.redF()), mix(color.greenF()), mix(color.blueF()));
}

QImage reportImage(const QSize& size, const std::function<void(QPainter& painter)>& draw) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  draw(painter);
  return image;
}

QColor reportScale(double share) { return viridis(std::clamp(share, 0.0, 1.0)); }

ReportDrawing directionsDrawing(const QString& caption, const PoseCoverage& coverage) {
  constexpr double kAspect = 0.5;
  return {caption, kAspect, [coverage](QPainter& painter, const QRectF& area, double point) {
            const Colors& colors = Colors::of(Theme::Light);
            const QFont small = reportFont(kTickText * point);
            const double line = QFontMetricsF(small).height();
            const double radius = std::min(area.width() / 4 - 6 * point, (area.height() - 2 * line) / 2);
            for (const Hemisphere side : {Hemisphere::Front, Hemisphere::Back}) {
              const bool is_front = side == Hemisphere::Front;
              const QPointF middle(area.left() + area.width() * (is_front ? 0.25 : 0.75),
                                   area.top() + radius + 2 * point);
              painter.setBrush(Qt::NoBrush);
              for (const double angle : {30 * kDegree, 60 * kDegree, 90 * kDegree}) {
                painter.setPen(QPen(angle > 1.5 ? colors.text_muted : colors.border, kHairline * point));
                painter.drawEllipse(middle, radius * discRadius(angle), radius * discRadius(angle));
              }
              painter.setPen(QPen(colors.border, kHairline * point));
              painter.drawLine(middle - QPointF(radius, 0), middle + QPointF(radius, 0));
              painter.drawLine(middle - QPointF(0, radius), middle + QPointF(0, radius));
              for (const SeenDirection& seen : coverage.seen) {
                if (seen.at.side != side) continue;
                const QPointF at = middle + radius * QPointF(seen.at.at.x(), -seen.at.at.y());
                painter.setPen(QPen(seen.enabled ? Qt::white : colors.text_muted, 0.8 * point));
                painter.setBrush(seen.enabled ? colors.accent : QColor(Qt::white));
                painter.drawEllipse(at, 5.5 * point, 5.5 * point);
                painter.setPen(seen.enabled ? textOn(colors.accent) : colors.text_muted);
                painter.setFont(reportFont(6.5 * point, true));
                painter.drawText(QRectF(at - QPointF(8 * point, 6 * point), QSizeF(16 * point, 12 * point)),
                                 Qt::AlignCenter, QString::number(seen.pose.value()));
              }
              painter.setFont(small);
              painter.setPen(colors.text_muted);
              painter.drawText(
                  QRectF(middle.x() - area.width() / 4, middle.y() + radius + 3 * point, area.width() / 2, 1.2 * line),
                  Qt::AlignCenter,
                  is_front ? ReportPlots::tr("up where the origin faces") : ReportPlots::tr("up behind it"));
            }
          }};
}

ReportDrawing boxesDrawing(BoxPlot plot) {
  constexpr double kAspect = 0.5;
  const QString caption = plot.caption;
  return {caption, kAspect, [plot = std::move(plot)](QPainter& painter, const QRectF& area, double point) {
            drawBoxes(plot, painter, area, point);
          }};
}

ReportDrawing histogramDrawing(HistogramPlot plot) {
  constexpr double kAspect = 0.5;
  const QString caption = plot.caption;
  return {caption, kAspect, [plot = std::move(plot)](QPainter& painter, const QRectF& area, double point) {
            HistogramPainter(plot, painter, area, point).draw();
          }};
}

}  // namespace hexoderm
