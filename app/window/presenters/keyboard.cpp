#include "app/window/presenters/keyboard.h"

#include "app/window/guide/actions.h"
#include "widgets/controls/step_panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace hexoderm {

Keyboard::Keyboard(const std::vector<QWidget*>& panes, const WindowActions& actions) {
  for (QWidget* pane : panes) panes_.add(pane);
  connect(actions.next_pane, &QAction::triggered, this, [this] { panes_.moveToPane(true); });
  connect(actions.previous_pane, &QAction::triggered, this, [this] { panes_.moveToPane(false); });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*old*/, QWidget* now) { panes_.noteFocus(now); });
  qApp->installEventFilter(this);
}

bool Keyboard::eventFilter(QObject* watched, QEvent* event) {
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

}  // namespace hexoderm
