#pragma once

#include "widgets/coloring/cell_colors.h"
#include "widgets/coloring/legend_rows.h"
#include "widgets/coloring/scale_strip.h"
#include "widgets/graph/graph_paint.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <vector>

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
  GraphLegend(const GraphPaint& paint, const GraphMarks& marks, Theme theme, const QFont& font)
      : colors_(Colors::of(theme)), font_(font) {
    if (font_.pointSizeF() > 0) font_.setPointSizeF(0.9 * font_.pointSizeF());
    if (paint.scale) {
      scale_.emplace(*paint.scale, mapOf(paint.coloring, sceneColors(theme)), theme, font_,
                     ScaleStrip::Histogram::Hidden);
      title_ = graphTitle(paint.coloring);
      note_ = paint.scale->is_fixed ? tr("range fixed") : QString();
    }
    const double height = rowHeight();
    const auto add = [&](Sample sample, const LinkStroke& stroke, const QString& word) {
      const double width = (kSampleWidth + kEntrySpace) * height + QFontMetricsF(font_).horizontalAdvance(word) + 1;
      entries_.push_back({word,
                          [sample, stroke, height, &colors = colors_](QPainter& painter, double x, double y) {
                            drawSample(painter, sample, stroke, colors,
                                       QRectF(x, y - 0.5 * height, kSampleWidth * height, height));
                          },
                          width});
    };
    const bool of_cells = !coloringRow(paint.coloring).colors_links;
    const Sample of_class = of_cells ? Sample::Fill : Sample::Line;
    for (std::size_t k = 0; k < std::min(paint.words.size(), kMaxClasses); ++k) {
      add(of_class, of_cells ? LinkStroke{paint.fills[k]} : paint.strokes[k], paint.words[k]);
    }
    if (paint.words.size() > kMaxClasses || (of_cells && !scale_ && paint.words.empty() && !paint.fills.empty())) {
      add(Sample::Fill, {Qt::transparent}, tr("and so on"));
    }
    if (paint.has_unknown) add(of_class, {of_cells ? colors_.cell_fill : colors_.excluded_link}, notKnownWord());
    if (marks.excluded) add(Sample::Excluded, {colors_.excluded_link}, tr("not used"));
    if (marks.tree) add(Sample::Tree, {colors_.tree_band}, tr("shortest paths"));
    add(Sample::Origin, {colors_.text}, tr("origin"));
  }

  /// Its height in an area of this width; 0 if it does not fit in.
  [[nodiscard]] double heightFor(double width) const {
    const int rows = rowsIn(width).count();
    return rows == 0 ? 0.0 : rows * rowHeight() + scaleHeight();
  }

  /// `area` is as high as heightFor() its width.
  void draw(QPainter& painter, const QRectF& area) const {
    painter.setFont(font_);
    painter.setRenderHint(QPainter::Antialiasing);
    if (scale_) drawScale(painter, QRectF(area.topLeft(), QSizeF(area.width(), scaleHeight())));
    rowsIn(area.width())
        .paint(painter, {area.center().x(), area.top() + scaleHeight()}, rowHeight(),
               (kSampleWidth + kEntrySpace) * rowHeight(), colors_.text);
  }

 private:
  /// None if they don't fit.
  [[nodiscard]] LegendRows rowsIn(double room) const {
    const double between = kBetween * rowHeight();
    if (scale_ && titleWidth() + between + kMinBarWidth * rowHeight() > room) return {};
    const LegendRows rows(entries_, room, between);
    return rows.count() <= kMaxRows && rows.width() <= room ? rows : LegendRows();
  }

  [[nodiscard]] double rowHeight() const { return std::ceil(QFontMetricsF(font_).height() + 2); }

  [[nodiscard]] double titleWidth() const {
    const QFontMetricsF metrics(font_);
    return std::max(metrics.horizontalAdvance(title_), metrics.horizontalAdvance(note_)) + 1;
  }

  [[nodiscard]] double scaleHeight() const { return scale_ ? std::max(scale_->height(), 2 * rowHeight()) + 2 : 0.0; }

  void drawScale(QPainter& painter, const QRectF& area) const {
    const double between = kBetween * rowHeight();
    const double bar = std::min(kMaxBarWidth * rowHeight(), area.width() - titleWidth() - between);
    const double left = area.left() + 0.5 * (area.width() - titleWidth() - between - bar);
    ScaleStrip strip = *scale_;
    strip.setPlace(QPointF(left + titleWidth() + between, area.top()), bar);
    strip.paint(painter, std::nullopt, std::nullopt);
    // The title stands beside the bar, a word on its range below it.
    QRectF words(left, strip.bar().center().y() - 0.5 * rowHeight(), titleWidth(), rowHeight());
    painter.setPen(colors_.text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, title_);
    painter.setPen(colors_.text_muted);
    painter.drawText(words.translated(0, rowHeight()), Qt::AlignLeft | Qt::AlignVCenter, note_);
  }

  std::optional<ScaleStrip> scale_;
  QString title_;
  QString note_;
  std::vector<LegendRows::Entry> entries_;
  const Colors& colors_;
  QFont font_;

  // Sizes are in heights of a row, so that the legend grows with the system's font.
  static constexpr double kSampleWidth = 1.5;
  static constexpr double kEntrySpace = 0.4;
  static constexpr double kBetween = 1.0;
  static constexpr double kMinBarWidth = 6.0;
  static constexpr double kMaxBarWidth = 16.0;
  static constexpr int kMaxRows = 3;
  static constexpr std::size_t kMaxClasses = 8;

  enum class Sample { Line, Fill, Excluded, Tree, Origin };

  /// The colour of the stroke is also that of a fill.
  static void drawSample(QPainter& painter, Sample sample, const LinkStroke& stroke, const Colors& colors,
                         const QRectF& box) {
    const double y = box.center().y();
    const double thick = std::max(2.0, 0.16 * box.height());
    const QLineF line(box.left(), y, box.right(), y);
    switch (sample) {
      case Sample::Line: {
        // The strokes of both directions, like those of links.
        const double aside = 0.22 * box.height();
        drawStroke(painter, stroke, line.translated(0, -aside), 0.8 * thick);
        drawStroke(painter, stroke, line.translated(0, aside), 0.8 * thick);
        return;
      }
      case Sample::Fill:
        if (stroke.color.alpha() == 0) return;
        painter.setPen(QPen(colors.text_muted, 1));
        painter.setBrush(stroke.color);
        painter.drawRect(box.adjusted(0.2 * box.width(), 0.2 * box.height(), -0.2 * box.width(), -0.2 * box.height()));
        return;
      case Sample::Excluded: {
        drawStroke(painter, stroke, line, 0.7 * thick);
        const double arm = 0.26 * box.height();
        painter.setPen(QPen(colors.text_muted, 0.6 * thick, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(box.center() - QPointF(arm, arm), box.center() + QPointF(arm, arm));
        painter.drawLine(box.center() - QPointF(arm, -arm), box.center() + QPointF(arm, -arm));
        return;
      }
      case Sample::Tree:
        drawStroke(painter, {stroke.color}, line, 3 * thick);
        return;
      case Sample::Origin:
        painter.setPen(stroke.color);
        painter.drawText(box, Qt::AlignCenter, QStringLiteral("★"));
        return;
    }
  }
};

}  // namespace hexoderm
