#pragma once

#include <QLayout>
#include <QList>
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

}  // namespace hexoderm
