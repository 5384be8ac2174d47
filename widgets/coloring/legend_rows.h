#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The entries of a legend in rows, as few as there is room for, each row in the middle. Where there are several,
/// columns have one width.
class LegendRows {
 public:
  /// A sample and its word.
  struct Entry {
    QString word;
    std::function<void(QPainter& painter, double x, double y)> draw;  ///< the sample, from x on, its middle at y
    double width = 0;                                                 ///< of both
  };

  /// None.
  LegendRows() = default;
  /// In `room`, with so much between two entries; wider than the room if its widest entry is.
  LegendRows(std::vector<Entry> entries, double room, double between)
      : entries_(std::move(entries)), between_(between) {
    if (entries_.empty()) return;
    double total = -between;
    for (const Entry& entry : entries_) {
      total += entry.width + between;
      widest_ = std::max(widest_, entry.width);
    }
    const auto count = static_cast<int>(entries_.size());
    columns_ = count;
    if (total > room) {
      columns_ = std::clamp(static_cast<int>(std::floor((room + between) / (widest_ + between))), 1, count);
      const int lines = (count + columns_ - 1) / columns_;
      columns_ = (count + lines - 1) / lines;
    }
    count_ = (count + columns_ - 1) / columns_;
    width_ = count_ == 1 ? total : columns_ * (widest_ + between) - between;
  }

  /// Of rows.
  [[nodiscard]] int count() const { return count_; }
  /// Of the widest row.
  [[nodiscard]] double width() const { return width_; }

  /// Below `top`, the middle of the upper edge, in the painter's font. `to_word`: from the left of an entry.
  void paint(QPainter& painter, const QPointF& top, double row_height, double to_word, const QColor& ink) const {
    const QFontMetricsF metrics(painter.font());
    double x = 0;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const Entry& entry = entries_[k];
      const auto place = static_cast<int>(k);
      if (place % columns_ == 0) x = top.x() - 0.5 * width_;
      const double middle = top.y() + (place / columns_ + 0.5) * row_height;
      entry.draw(painter, x, middle);
      painter.setPen(ink);
      const double room = entry.width - to_word + 2;
      painter.drawText(QRectF(x + to_word, middle - 0.5 * row_height, room, row_height),
                       Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(entry.word, Qt::ElideRight, room));
      x += (count_ == 1 ? entry.width : widest_) + between_;
    }
  }

 private:
  std::vector<Entry> entries_;
  double between_ = 0;
  double widest_ = 0;
  double width_ = 0;
  int columns_ = 1;
  int count_ = 0;
};

}  // namespace hexoderm
