#include "widgets/controls/action_button.h"

#include <QAction>

namespace hexoderm {

ActionButton::ActionButton(QWidget* parent) : QPushButton(parent) {
  hide();
  connect(this, &QPushButton::clicked, this, [this] {
    if (action_) action_->trigger();
  });
}

void ActionButton::setAction(QAction* action) {
  if (action_ == action) return;
  if (action_) disconnect(action_, nullptr, this, nullptr);
  action_ = action;
  if (action_) {
    connect(action_, &QAction::changed, this, &ActionButton::refresh);
    connect(action_, &QObject::destroyed, this, &QWidget::hide);
    refresh();
  }
  setVisible(action_ != nullptr);
}

void ActionButton::refresh() {
  setText(action_->iconText());
  setAccessibleName(action_->iconText());
  setEnabled(action_->isEnabled());
  setToolTip(action_->toolTip());
  setAccessibleDescription(action_->toolTip());
}

}  // namespace hexoderm
