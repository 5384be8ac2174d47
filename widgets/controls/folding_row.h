#pragma once

#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QMap>
#include <QMenu>
#include <QToolButton>
#include <QWidget>
#include <algorithm>

namespace hexoderm {

/// Buttons in one row, from the left; those that find no room fold into a menu at its end, the last ones first. There
/// may be a second group of them, at the right end of a row that is wide enough.
class FoldingRow : public ItemLayout {
  Q_OBJECT

 public:
  /// `parent`: the widget whose layout this becomes.
  explicit FoldingRow(QWidget* parent) : ItemLayout(parent), more_(quiet(new QToolButton(parent), "moreButton")) {
    more_->setText(tr("More ▾"));
    more_->setAccessibleName(tr("More"));
    more_->setToolTip(tr("What finds no room beside this"));
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setMenu(menu_);
    more_->hide();
    menu_->setToolTipsVisible(true);
    connect(menu_, &QMenu::aboutToShow, this, &FoldingRow::fillMenu);
  }

  /// Opens the menu with what is folded; hidden while nothing is.
  [[nodiscard]] QToolButton* moreButton() const { return more_; }
  [[nodiscard]] bool isFolded(const QWidget* button) const { return folded_.contains(const_cast<QWidget*>(button)); }

  QLayoutItem* takeAt(int index) override {
    if (index >= 0 && index < count()) folded_.remove(items_.at(index)->widget());
    return ItemLayout::takeAt(index);
  }

  /// All unfolded.
  [[nodiscard]] QSize sizeHint() const override {
    const QMargins margins = contentsMargins();
    return QSize(widthOf(count()), rowHeight()).grownBy(margins);
  }

  /// All folded.
  [[nodiscard]] QSize minimumSize() const override {
    return QSize(more_->sizeHint().width(), rowHeight()).grownBy(contentsMargins());
  }

  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    const QRect room = rect.marginsRemoved(contentsMargins());
    int shown = count();
    const bool folds = widthOf(shown) > room.width();
    const int for_more = more_->sizeHint().width() + spacing();
    while (folds && shown > 0 && widthOf(shown) + for_more > room.width()) --shown;
    const int height = rowHeight();
    int x = room.left();
    for (int k = 0; k < count(); ++k) {
      QLayoutItem* item = items_.at(k);
      if (!folds && k == second_group_) x = room.left() + room.width() - groupWidth(k, count());
      if (item->isEmpty()) continue;
      fold(item->widget(), k >= shown);
      if (k >= shown) {
        item->widget()->setGeometry(0, 0, 0, 0);
        continue;
      }
      const QSize size = item->sizeHint();
      item->setGeometry(QRect(QPoint(x, room.top() + (height - size.height()) / 2), size));
      x += size.width() + spacing();
    }
    if (folds) {
      const QSize size = more_->sizeHint();
      more_->setGeometry(QRect(QPoint(x, room.top() + (height - size.height()) / 2), size));
    }
    more_->setVisible(folds);
  }

 private:
  static constexpr int kGroupsApart = 12;  // between the groups, at least

  [[nodiscard]] int rowHeight() const {
    int height = more_->sizeHint().height();
    for (const QLayoutItem* item : items_) {
      if (!item->isEmpty()) height = std::max(height, item->sizeHint().height());
    }
    return height;
  }

  /// Of the first `shown` buttons.
  [[nodiscard]] int widthOf(int shown) const {
    const int boundary = std::min(shown, second_group_.value_or(shown));
    const int first = groupWidth(0, boundary);
    const int second = groupWidth(boundary, shown);
    return first + second + (first > 0 && second > 0 ? kGroupsApart : 0);
  }

  /// A folded button is as visible as its owner wants it, but has no size, and the keyboard passes it by.
  void fold(QWidget* button, bool folded) {
    if (folded == folded_.contains(button)) return;
    if (folded) {
      folded_.insert(button, button->focusPolicy());
      button->setFocusPolicy(Qt::NoFocus);
      if (button->hasFocus()) more_->setFocus();
    } else {
      button->setFocusPolicy(folded_.take(button));
    }
  }

  void fillMenu() {
    menu_->clear();
    for (QLayoutItem* item : items_) {
      auto* button = qobject_cast<QToolButton*>(item->widget());
      if (button == nullptr || item->isEmpty() || !folded_.contains(button)) continue;
      if (button->defaultAction() != nullptr) {
        menu_->addAction(button->defaultAction());
        continue;
      }
      QAction* action = menu_->addAction(button->text().remove(QStringLiteral(" ▾")));
      action->setToolTip(button->toolTip());
      action->setEnabled(button->isEnabled());
      if (button->menu() != nullptr) {
        action->setMenu(button->menu());
        continue;
      }
      action->setCheckable(button->isCheckable());
      action->setChecked(button->isChecked());
      connect(action, &QAction::triggered, button, &QToolButton::click);
    }
  }

  QMap<QWidget*, Qt::FocusPolicy> folded_;  ///< with the policy that it has otherwise
  QToolButton* more_;
  QMenu* menu_ = named(new QMenu(more_), "moreMenu");
};

}  // namespace hexoderm
