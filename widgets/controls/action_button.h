#pragma once

#include <QAction>
#include <QPointer>
#include <QPushButton>

namespace hexoderm {

/// A button that is a view of an action: its text, whether it can be used and, if not, why. Hidden without an action.
class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ActionButton(QWidget* parent = nullptr);

  /// Null hides the button. The action need not outlive it.
  void setAction(QAction* action);
  [[nodiscard]] QAction* action() const { return action_; }

 private:
  void refresh();

  QPointer<QAction> action_;
};

}  // namespace hexoderm
