#pragma once

#include "widgets/controls/flow_layout.h"

#include <QLayout>
#include <QRect>
#include <QSize>
#include <QWidget>
#include <algorithm>

namespace hexoderm {

/// Widgets one below the other, in as many columns of about the same height as there is room for: down the first
/// column, then down the next.
class ColumnLayout : public ItemLayout {
  Q_OBJECT

 public:
  /// `least_width`: of a column, where there is more than one.
  explicit ColumnLayout(int least_width, QWidget* parent = nullptr) : ItemLayout(parent), least_width_(least_width) {}
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  /// Of one column.
  [[nodiscard]] QSize sizeHint() const override {
    const QMargins margins = contentsMargins();
    const int width = least_width_ + margins.left() + margins.right();
    return {width, heightForWidth(width)};
  }

  [[nodiscard]] QSize minimumSize() const override {
    QSize least;
    for (const QLayoutItem* item : items_) least = least.expandedTo({item->minimumSize().width(), 0});
    return least.grownBy(contentsMargins());
  }

  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    arrange(rect, true);
  }

 private:
  static constexpr int kBetweenColumns = 24;
  static int heightIn(const QLayoutItem& item, int width) {
    return item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
  }

  /// Places the items where `place`; returns the height that they need.
  int arrange(const QRect& rect, bool place) const {
    const QRect room = rect.marginsRemoved(contentsMargins());
    const int columns = std::clamp((room.width() + kBetweenColumns) / (least_width_ + kBetweenColumns), 1, 3);
    const int width = (room.width() - (columns - 1) * kBetweenColumns) / columns;
    int total = 0;
    for (const QLayoutItem* item : items_) total += item->isEmpty() ? 0 : heightIn(*item, width) + spacing();
    const int share = total / columns;
    int column = 0;
    int y = 0;
    int highest = 0;
    for (QLayoutItem* item : items_) {
      if (item->isEmpty()) continue;
      const int height = heightIn(*item, width);
      // Where the greater part of it would lie beyond the column's share, it begins the next one.
      if (column + 1 < columns && y > 0 && y + height / 2 > share) {
        ++column;
        y = 0;
      }
      const QPoint at(room.left() + column * (width + kBetweenColumns), room.top() + y);
      if (place) item->setGeometry(QRect(at, QSize(width, height)));
      y += height + spacing();
      highest = std::max(highest, y - spacing());
    }
    return highest + contentsMargins().top() + contentsMargins().bottom();
  }

  int least_width_;
};

}  // namespace hexoderm
