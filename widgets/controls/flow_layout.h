#pragma once

#include <QLayout>
#include <QList>
#include <optional>

namespace hexoderm {

/// Widgets in a row, from the left; in as many rows as a narrow place needs. There may be a second group of them, at
/// the right end of the row or beginning one of its own.
class FlowLayout : public QLayout {
  Q_OBJECT

 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  /// Items added from now on belong to the second group.
  void beginSecondGroup() { second_group_ = count(); }

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  /// All in one row.
  [[nodiscard]] QSize sizeHint() const override;
  /// One below the other.
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  /// Places the items where `place`; returns the height that they need.
  int arrange(const QRect& rect, bool place) const;
  /// Index of the second group's first item; the end, if there is none.
  [[nodiscard]] int firstGroupEnd() const { return second_group_.value_or(count()); }
  [[nodiscard]] int groupWidth(int first, int end) const;
  /// Width of all items in one row.
  [[nodiscard]] int rowWidth() const;

  QList<QLayoutItem*> items_;
  std::optional<int> second_group_;
};

}  // namespace hexoderm
