#include "widgets/controls/column_layout.h"

#include <algorithm>

namespace hexoderm {
namespace {

constexpr int kBetweenColumns = 24;

int heightIn(const QLayoutItem& item, int width) {
  return item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
}

}  // namespace

ColumnLayout::ColumnLayout(int least_width, QWidget* parent) : QLayout(parent), least_width_(least_width) {}

ColumnLayout::~ColumnLayout() { qDeleteAll(items_); }

QLayoutItem* ColumnLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_.at(index) : nullptr;
}

QLayoutItem* ColumnLayout::takeAt(int index) { return index >= 0 && index < count() ? items_.takeAt(index) : nullptr; }

QSize ColumnLayout::sizeHint() const {
  const QMargins margins = contentsMargins();
  const int width = least_width_ + margins.left() + margins.right();
  return {width, heightForWidth(width)};
}

QSize ColumnLayout::minimumSize() const {
  QSize least;
  for (const QLayoutItem* item : items_) least = least.expandedTo({item->minimumSize().width(), 0});
  return least.grownBy(contentsMargins());
}

void ColumnLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int ColumnLayout::arrange(const QRect& rect, bool place) const {
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

}  // namespace hexoderm
