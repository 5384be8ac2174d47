#include "widgets/controls/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr int kApart = 24;  // between the groups, at least

}  // namespace

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {}

FlowLayout::~FlowLayout() { qDeleteAll(items_); }

QLayoutItem* FlowLayout::itemAt(int index) const { return index >= 0 && index < count() ? items_.at(index) : nullptr; }

QLayoutItem* FlowLayout::takeAt(int index) {
  if (index < 0 || index >= count()) return nullptr;
  if (second_group_ && index < *second_group_) --*second_group_;
  return items_.takeAt(index);
}

int FlowLayout::groupWidth(int first, int end) const {
  int width = 0;
  for (int k = first; k < end; ++k) {
    if (items_.at(k)->isEmpty()) continue;
    width += items_.at(k)->sizeHint().width() + (width > 0 ? spacing() : 0);
  }
  return width;
}

int FlowLayout::rowWidth() const {
  const int first = groupWidth(0, firstGroupEnd());
  return second_group_ ? first + kApart + groupWidth(*second_group_, count()) : first;
}

QSize FlowLayout::sizeHint() const {
  const QMargins margins = contentsMargins();
  const int width = rowWidth() + margins.left() + margins.right();
  return {width, heightForWidth(width)};
}

QSize FlowLayout::minimumSize() const {
  const QMargins margins = contentsMargins();
  QSize least;
  for (const QLayoutItem* item : items_) least = least.expandedTo(item->sizeHint());
  return least.grownBy(margins);
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool place) const {
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

}  // namespace hexoderm
