#include "widgets/graph/graph_legend.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

// Sizes are in heights of a row, so that the legend grows with the system's font.
constexpr double kSampleWidth = 1.5;
constexpr double kEntrySpace = 0.4;
constexpr double kBetween = 1.0;
constexpr double kMinBarWidth = 6.0;
constexpr double kMaxBarWidth = 16.0;
constexpr int kMaxRows = 3;
constexpr std::size_t kMaxClasses = 8;

enum class Sample { Line, Fill, Excluded, Tree, Origin };

/// The colour of the stroke is also that of a fill.
void drawSample(QPainter& painter, Sample sample, const LinkStroke& stroke, const Colors& colors, const QRectF& box) {
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

}  // namespace

GraphLegend::GraphLegend(const GraphPaint& paint, const GraphMarks& marks, Theme theme, const QFont& font)
    : colors_(Colors::of(theme)), font_(font) {
  if (font_.pointSizeF() > 0) font_.setPointSizeF(0.9 * font_.pointSizeF());
  if (paint.scale) {
    scale_.emplace(*paint.scale, graphMap(paint.coloring, theme), theme, font_, ScaleStrip::Histogram::Hidden);
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

double GraphLegend::rowHeight() const { return std::ceil(QFontMetricsF(font_).height() + 2); }

double GraphLegend::titleWidth() const {
  const QFontMetricsF metrics(font_);
  return std::max(metrics.horizontalAdvance(title_), metrics.horizontalAdvance(note_)) + 1;
}

double GraphLegend::scaleHeight() const { return scale_ ? std::max(scale_->height(), 2 * rowHeight()) + 2 : 0.0; }

LegendRows GraphLegend::rowsIn(double room) const {
  const double between = kBetween * rowHeight();
  if (scale_ && titleWidth() + between + kMinBarWidth * rowHeight() > room) return {};
  const LegendRows rows(entries_, room, between);
  return rows.count() <= kMaxRows && rows.width() <= room ? rows : LegendRows();
}

double GraphLegend::heightFor(double width) const {
  const int rows = rowsIn(width).count();
  return rows == 0 ? 0.0 : rows * rowHeight() + scaleHeight();
}

void GraphLegend::draw(QPainter& painter, const QRectF& area) const {
  painter.setFont(font_);
  painter.setRenderHint(QPainter::Antialiasing);
  if (scale_) drawScale(painter, QRectF(area.topLeft(), QSizeF(area.width(), scaleHeight())));
  rowsIn(area.width())
      .paint(painter, {area.center().x(), area.top() + scaleHeight()}, rowHeight(),
             (kSampleWidth + kEntrySpace) * rowHeight(), colors_.text);
}

void GraphLegend::drawScale(QPainter& painter, const QRectF& area) const {
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

}  // namespace hexoderm
