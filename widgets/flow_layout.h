#pragma once

#include <QLayout>
#include <QList>

namespace hexoderm {

/// Widgets in a row, two groups of them at its ends; in as many rows as a narrow place needs, the second group
/// beginning one of its own.
class FlowLayout : public QLayout {
  Q_OBJECT

 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  /// What is added from now on belongs to the second group.
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
  [[nodiscard]] int groupWidth(int first, int end) const;

  QList<QLayoutItem*> items_;
  int second_group_ = 0;
};

}  // namespace hexoderm
