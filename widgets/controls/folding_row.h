#pragma once

#include <QLayout>
#include <QList>
#include <QMap>
#include <optional>

class QMenu;
class QToolButton;

namespace hexoderm {

/// Buttons in one row, from the left; those that find no room fold into a menu at its end, the last ones first. There
/// may be a second group of them, at the right end of a row that is wide enough.
class FoldingRow : public QLayout {
  Q_OBJECT

 public:
  /// `parent`: the widget whose layout this becomes.
  explicit FoldingRow(QWidget* parent);
  ~FoldingRow() override;

  /// Buttons added from now on belong to the second group.
  void beginSecondGroup() { second_group_ = count(); }
  /// Opens the menu with what is folded; hidden while nothing is.
  [[nodiscard]] QToolButton* moreButton() const { return more_; }
  [[nodiscard]] bool isFolded(const QWidget* button) const;

  void addItem(QLayoutItem* item) override { items_.append(item); }
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  /// All unfolded.
  [[nodiscard]] QSize sizeHint() const override;
  /// All folded.
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  [[nodiscard]] int rowHeight() const;
  [[nodiscard]] int groupWidth(int first, int end) const;
  /// Of the first `shown` buttons.
  [[nodiscard]] int widthOf(int shown) const;
  void fold(QWidget* button, bool folded);
  void fillMenu();

  QList<QLayoutItem*> items_;
  std::optional<int> second_group_;
  QMap<QWidget*, Qt::FocusPolicy> folded_;  ///< with the policy that it has otherwise
  QToolButton* more_;
  QMenu* menu_;
};

}  // namespace hexoderm
