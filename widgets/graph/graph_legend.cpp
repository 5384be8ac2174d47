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

}  // namespace

GraphLegend::GraphLegend(const GraphPaint& paint, const GraphMarks& marks, Theme theme, const QFont& font)
    : colors_(Colors::of(theme)), font_(font) {
  if (font_.pointSizeF() > 0) font_.setPointSizeF(0.9 * font_.pointSizeF());
  if (paint.scale) {
    scale_.emplace(*paint.scale, graphMap(paint.coloring, theme), theme, font_, ScaleStrip::Histogram::Hidden);
    title_ = graphTitle(paint.coloring);
    note_ = paint.scale->is_fixed ? tr("range fixed") : QString();
  }
  const bool of_cells = !coloringRow(paint.coloring).colors_links;
  for (std::size_t k = 0; k < std::min(paint.words.size(), kMaxClasses); ++k) {
    entries_.push_back({of_cells ? Sample::Fill : Sample::Line,
                        of_cells ? LinkStroke{paint.fills[k]} : paint.strokes[k], paint.words[k]});
  }
  if (paint.words.size() > kMaxClasses || (of_cells && !scale_ && paint.words.empty() && !paint.fills.empty())) {
    entries_.push_back({Sample::Fill, {Qt::transparent}, tr("and so on")});
  }
  if (paint.has_unknown) {
    entries_.push_back(
        {of_cells ? Sample::Fill : Sample::Line, {of_cells ? colors_.cell_fill : colors_.muted_link}, notKnownWord()});
  }
  if (marks.muted) entries_.push_back({Sample::Muted, {colors_.muted_link}, tr("not used")});
  if (marks.tree) entries_.push_back({Sample::Tree, {colors_.tree_band}, tr("shortest paths")});
  entries_.push_back({Sample::Origin, {colors_.text}, tr("origin")});
}

double GraphLegend::rowHeight() const { return std::ceil(QFontMetricsF(font_).height() + 2); }

double GraphLegend::widthOf(const Entry& entry) const {
  return (kSampleWidth + kEntrySpace) * rowHeight() + QFontMetricsF(font_).horizontalAdvance(entry.word) + 1;
}

double GraphLegend::titleWidth() const {
  const QFontMetricsF metrics(font_);
  return std::max(metrics.horizontalAdvance(title_), metrics.horizontalAdvance(note_)) + 1;
}

double GraphLegend::scaleHeight() const { return scale_ ? std::max(scale_->height(), 2 * rowHeight()) + 2 : 0.0; }

GraphLegend::Arrangement GraphLegend::arrange(double room) const {
  const auto count = static_cast<int>(entries_.size());
  const double between = kBetween * rowHeight();
  if (scale_ && titleWidth() + between + kMinBarWidth * rowHeight() > room) return {};
  double total = -between;
  double column = 0;
  for (const Entry& entry : entries_) {
    total += widthOf(entry) + between;
    column = std::max(column, widthOf(entry) + between);
  }
  if (total <= room) return {1, count, 0, total};
  for (int rows = 2; rows <= kMaxRows; ++rows) {
    const int columns = (count + rows - 1) / rows;
    if (columns * column - between <= room) return {rows, columns, column, columns * column - between};
  }
  return {};
}

double GraphLegend::heightFor(double width) const {
  const Arrangement arrangement = arrange(width);
  return arrangement.rows == 0 ? 0.0 : arrangement.rows * rowHeight() + scaleHeight();
}

void GraphLegend::draw(QPainter& painter, const QRectF& area) const {
  painter.setFont(font_);
  painter.setRenderHint(QPainter::Antialiasing);
  QRectF rest = area;
  if (scale_) {
    drawScale(painter, QRectF(area.topLeft(), QSizeF(area.width(), scaleHeight())));
    rest.setTop(area.top() + scaleHeight());
  }
  drawEntries(painter, rest);
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

void GraphLegend::drawEntries(QPainter& painter, const QRectF& area) const {
  const Arrangement arrangement = arrange(area.width());
  if (arrangement.rows == 0) return;
  const double left = area.left() + 0.5 * (area.width() - arrangement.width);
  double x = left;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const int row = static_cast<int>(k) / arrangement.columns;
    const int column = static_cast<int>(k) % arrangement.columns;
    if (arrangement.column_width > 0) x = left + column * arrangement.column_width;
    const QRectF box(x, area.top() + row * rowHeight(), widthOf(entries_[k]), rowHeight());
    drawSample(painter, entries_[k], QRectF(box.topLeft(), QSizeF(kSampleWidth * rowHeight(), rowHeight())));
    painter.setPen(colors_.text);
    painter.drawText(box.adjusted((kSampleWidth + kEntrySpace) * rowHeight(), 0, 1, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, entries_[k].word);
    x = box.right() + kBetween * rowHeight();
  }
}

void GraphLegend::drawSample(QPainter& painter, const Entry& entry, const QRectF& box) const {
  const double y = box.center().y();
  const double thick = std::max(2.0, 0.16 * box.height());
  const QLineF line(box.left(), y, box.right(), y);
  switch (entry.sample) {
    case Sample::Line: {
      // The strokes of both directions, like those of links.
      const double aside = 0.22 * box.height();
      drawStroke(painter, entry.stroke, line.translated(0, -aside), 0.8 * thick);
      drawStroke(painter, entry.stroke, line.translated(0, aside), 0.8 * thick);
      return;
    }
    case Sample::Fill:
      if (entry.stroke.color.alpha() == 0) return;
      painter.setPen(QPen(colors_.text_muted, 1));
      painter.setBrush(entry.stroke.color);
      painter.drawRect(box.adjusted(0.2 * box.width(), 0.2 * box.height(), -0.2 * box.width(), -0.2 * box.height()));
      return;
    case Sample::Muted: {
      drawStroke(painter, entry.stroke, line, 0.7 * thick);
      const double arm = 0.26 * box.height();
      painter.setPen(QPen(colors_.text_muted, 0.6 * thick, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(box.center() - QPointF(arm, arm), box.center() + QPointF(arm, arm));
      painter.drawLine(box.center() - QPointF(arm, -arm), box.center() + QPointF(arm, -arm));
      return;
    }
    case Sample::Tree:
      drawStroke(painter, {entry.stroke.color}, line, 3 * thick);
      return;
    case Sample::Origin:
      painter.setPen(entry.stroke.color);
      painter.drawText(box, Qt::AlignCenter, QStringLiteral("★"));
      return;
  }
}

}  // namespace hexoderm
