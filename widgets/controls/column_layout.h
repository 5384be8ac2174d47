#pragma once

#include <QLayout>
#include <QList>

namespace hexoderm {

/// Widgets one below the other, in as many columns of about the same height as there is room for: down the first
/// column, then down the next.
class ColumnLayout : public QLayout {
  Q_OBJECT

 public:
  /// `least_width`: of a column, where there is more than one.
  explicit ColumnLayout(int least_width, QWidget* parent = nullptr);
  ~ColumnLayout() override;

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  /// Of one column.
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  /// Places the items where `place`; returns the height that they need.
  int arrange(const QRect& rect, bool place) const;

  int least_width_;
  QList<QLayoutItem*> items_;
};

}  // namespace hexoderm
