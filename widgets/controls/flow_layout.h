#pragma once

#include <QLayout>
#include <QList>
#include <QWidget>
#include <algorithm>
#include <optional>

namespace hexoderm {

/// Base of our layouts: it keeps their items. There may be a second group of them, which each layout puts where it
/// likes.
class ItemLayout : public QLayout {
 public:
  using QLayout::QLayout;
  ~ItemLayout() override { qDeleteAll(items_); }

  /// Items added from now on belong to the second group.
  void beginSecondGroup() { second_group_ = count(); }

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override {
    return index >= 0 && index < count() ? items_.at(index) : nullptr;
  }
  QLayoutItem* takeAt(int index) override {
    if (index < 0 || index >= count()) return nullptr;
    if (second_group_ && index < *second_group_) --*second_group_;
    return items_.takeAt(index);
  }
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }

 protected:
  /// Of items side by side; hidden ones take no room.
  [[nodiscard]] int groupWidth(int first, int end) const {
    int width = 0;
    for (int k = first; k < end; ++k) {
      if (items_.at(k)->isEmpty()) continue;
      width += items_.at(k)->sizeHint().width() + (width > 0 ? spacing() : 0);
    }
    return width;
  }

  QList<QLayoutItem*> items_;
  std::optional<int> second_group_;
};

/// Widgets in a row, from the left; in as many rows as a narrow place needs. There may be a second group of them, at
/// the right end of the row or beginning one of its own.
class FlowLayout : public ItemLayout {
  Q_OBJECT

 public:
  explicit FlowLayout(QWidget* parent = nullptr) : ItemLayout(parent) {}
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  /// All in one row.
  [[nodiscard]] QSize sizeHint() const override {
    const QMargins margins = contentsMargins();
    const int width = rowWidth() + margins.left() + margins.right();
    return {width, heightForWidth(width)};
  }

  /// One below the other.
  [[nodiscard]] QSize minimumSize() const override {
    const QMargins margins = contentsMargins();
    QSize least;
    for (const QLayoutItem* item : items_) least = least.expandedTo(item->sizeHint());
    return least.grownBy(margins);
  }

  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    arrange(rect, true);
  }

 private:
  static constexpr int kApart = 24;  // between the groups, at least

  /// Places the items where `place`; returns the height that they need.
  int arrange(const QRect& rect, bool place) const {
    const QRect room = rect.marginsRemoved(contentsMargins());
    const bool one_row = rowWidth() <= room.width();
    // Hidden items take no room.
    int row_height = 0;
    for (const QLayoutItem* item : items_) {
      if (!item->isEmpty()) row_height = std::max(row_height, item->sizeHint().height());
    }
    int x = room.left();
    int y = room.top();
    const auto begin_row = [&] {
      x = room.left();
      y += row_height + spacing();
    };
    for (int k = 0; k < count(); ++k) {
      if (k == second_group_ && one_row) x = room.left() + room.width() - groupWidth(k, count());
      if (k == second_group_ && !one_row && x > room.left()) begin_row();
      if (items_.at(k)->isEmpty()) continue;
      const QSize size = items_.at(k)->sizeHint();
      if (!one_row && x > room.left() && x + size.width() > room.left() + room.width()) begin_row();
      // A text stands in the middle of a row of buttons.
      if (place) items_.at(k)->setGeometry(QRect(QPoint(x, y + (row_height - size.height()) / 2), size));
      x += size.width() + spacing();
    }
    return y + row_height - rect.top() + contentsMargins().bottom();
  }

  /// Index of the second group's first item; the end, if there is none.
  /// Width of all items in one row.
  [[nodiscard]] int rowWidth() const {
    const int first = groupWidth(0, second_group_.value_or(count()));
    return second_group_ ? first + kApart + groupWidth(*second_group_, count()) : first;
  }
};

}  // namespace hexoderm
