#pragma once

#include "app/window/guide/actions.h"
#include "app/window/toolkit/focus_order.h"
#include "widgets/controls/step_panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QObject>
#include <vector>

namespace hexoderm {

/// Leads the keyboard from one part of the window to the next.
class Keyboard : public QObject {
  Q_OBJECT

 public:
  /// `panes`: the large parts of the window in the order in which it is read. All outlive this object.
  Keyboard(const std::vector<QWidget*>& panes, const WindowActions& actions) {
    for (QWidget* pane : panes) panes_.add(pane);
    connect(actions.next_pane, &QAction::triggered, this, [this] { panes_.moveToPane(true); });
    connect(actions.previous_pane, &QAction::triggered, this, [this] { panes_.moveToPane(false); });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*old*/, QWidget* now) { panes_.noteFocus(now); });
    qApp->installEventFilter(this);
  }

  /// What Tab and Shift+Tab do, see FocusOrder::moveToControl().
  bool moveToControl(bool forward) { return panes_.moveToControl(forward); }

  /// Space presses the button that has the focus before it captures a pose.
  bool eventFilter(QObject* watched, QEvent* event) override {
    // The heading of the step that is open has nothing to be pressed for.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
        !watched->property(StepPanel::kIsOpen).toBool() &&
        (qobject_cast<QAbstractButton*>(watched) || qobject_cast<QComboBox*>(watched) ||
         qobject_cast<QAbstractSpinBox*>(watched))) {
      event->accept();
      return true;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  FocusOrder panes_;
};

}  // namespace hexoderm
