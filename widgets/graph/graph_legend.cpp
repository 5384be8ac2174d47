#include "widgets/graph/graph_legend.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

// Sizes are in heights of a row, so that the legend grows with the system's font.
constexpr double kSampleWidth = 1.5;
constexpr double kEntrySpace = 0.4;
constexpr double kBetween = 1.0;
constexpr double kBarWidth = 6.0;
constexpr int kMostRows = 3;
constexpr std::size_t kMostClasses = 8;

}  // namespace

GraphLegend::GraphLegend(const GraphPaint& paint, const GraphMarks& marks, Theme theme, const QFont& font)
    : scale_(paint.scale), colors_(Colors::of(theme)), font_(font) {
  if (font_.pointSizeF() > 0) font_.setPointSizeF(0.9 * font_.pointSizeF());
  const bool of_cells = !coloringRow(paint.coloring).colors_links;
  for (std::size_t k = 0; k < std::min(paint.words.size(), kMostClasses); ++k) {
    entries_.push_back({of_cells ? Sample::Fill : Sample::Line,
                        of_cells ? LinkStroke{paint.fills[k], Qt::SolidLine, false} : paint.strokes[k],
                        paint.words[k]});
  }
  if (paint.words.size() > kMostClasses || (of_cells && !scale_ && paint.words.empty() && !paint.fills.empty())) {
    entries_.push_back({Sample::Fill, {Qt::transparent, Qt::SolidLine, false}, tr("and so on")});
  }
  if (paint.has_unknown) {
    entries_.push_back({of_cells ? Sample::Fill : Sample::Line,
                        {of_cells ? colors_.cell_fill : colors_.muted_link, Qt::SolidLine, false},
                        notKnownWord()});
  }
  if (marks.muted) entries_.push_back({Sample::Muted, {colors_.muted_link, Qt::SolidLine, false}, tr("not used")});
  if (marks.tree) entries_.push_back({Sample::Tree, {colors_.tree_band, Qt::SolidLine, false}, tr("shortest paths")});
  entries_.push_back({Sample::Origin, {colors_.text, Qt::SolidLine, false}, tr("origin")});
}

double GraphLegend::rowHeight() const { return std::ceil(QFontMetricsF(font_).height() + 2); }

double GraphLegend::widthOf(const Entry& entry) const {
  return (kSampleWidth + kEntrySpace) * rowHeight() + QFontMetricsF(font_).horizontalAdvance(entry.word) + 1;
}

double GraphLegend::scaleWidth() const {
  const QFontMetricsF metrics(font_);
  const double words = metrics.horizontalAdvance(scale_->title) + metrics.horizontalAdvance(scale_->low) +
                       metrics.horizontalAdvance(scale_->high);
  return words + (kBarWidth + 2 * kEntrySpace + kBetween) * rowHeight();
}

GraphLegend::Arrangement GraphLegend::arrange(double width) const {
  const auto count = static_cast<int>(entries_.size());
  if (scale_ && scaleWidth() > width) return {};
  double total = (count - 1) * kBetween * rowHeight();
  double widest = 0;
  for (const Entry& entry : entries_) {
    total += widthOf(entry);
    widest = std::max(widest, widthOf(entry));
  }
  if (total <= width) return {1, count, 0};
  const double column = widest + kBetween * rowHeight();
  for (int rows = 2; rows <= kMostRows; ++rows) {
    const int columns = (count + rows - 1) / rows;
    if (columns * column - kBetween * rowHeight() <= width) return {rows, columns, column};
  }
  return {};
}

double GraphLegend::heightFor(double width) const {
  const Arrangement arrangement = arrange(width);
  return arrangement.rows == 0 ? 0.0 : (arrangement.rows + (scale_ ? 1 : 0)) * rowHeight();
}

void GraphLegend::draw(QPainter& painter, const QRectF& area) const {
  painter.setFont(font_);
  painter.setRenderHint(QPainter::Antialiasing);
  QRectF rest = area;
  if (scale_) {
    drawScale(painter, QRectF(area.topLeft(), QSizeF(area.width(), rowHeight())));
    rest.setTop(area.top() + rowHeight());
  }
  drawEntries(painter, rest);
}

void GraphLegend::drawScale(QPainter& painter, const QRectF& row) const {
  constexpr int kStops = 16;
  const QFontMetricsF metrics(font_);
  double x = row.left() + 0.5 * (row.width() - scaleWidth());
  const auto write = [&](const QString& text, const QColor& color) {
    const double width = metrics.horizontalAdvance(text) + 1;
    painter.setPen(color);
    painter.drawText(QRectF(x, row.top(), width, row.height()), Qt::AlignLeft | Qt::AlignVCenter, text);
    x += width - 1;
  };
  write(scale_->title, colors_.text);
  x += kBetween * rowHeight();
  write(scale_->low, colors_.text_muted);
  x += kEntrySpace * rowHeight();
  const QRectF bar(x, row.top() + 0.25 * row.height(), kBarWidth * rowHeight(), 0.5 * row.height());
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int k = 0; k <= kStops; ++k) {
    const double t = static_cast<double>(k) / kStops;
    gradient.setColorAt(t, viridis(t));
  }
  painter.setPen(QPen(colors_.border, 1));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  x = bar.right() + kEntrySpace * rowHeight();
  write(scale_->high, colors_.text_muted);
}

void GraphLegend::drawEntries(QPainter& painter, const QRectF& area) const {
  const Arrangement arrangement = arrange(area.width());
  if (arrangement.rows == 0) return;
  double total = 0;
  if (arrangement.column_width > 0) {
    total = arrangement.columns * arrangement.column_width - kBetween * rowHeight();
  } else {
    for (const Entry& entry : entries_) total += widthOf(entry) + kBetween * rowHeight();
    total -= kBetween * rowHeight();
  }
  const double left = area.left() + 0.5 * (area.width() - total);
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
