// The part of MainWindow about the keyboard: who has it, and where it goes.
#include "app/window/main_window/main_window.h"
#include "widgets/capture/live_strip.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/card_dock.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <initializer_list>

namespace hexoderm {

void MainWindow::connectKeys() {
  // As one reads the window: from the top, and from left to right.
  for (QWidget* pane : std::initializer_list<QWidget*>{banner_, message_bar_, live_strip_, step_panel_,
                                                       docks_->centralWidget(), graph_dock_, coverage_dock_, pose_dock_,
                                                       docks_->findChild<CardDock*>(QStringLiteral("detailsDock"))}) {
    panes_.add(pane);
  }
  connect(actions_.next_pane, &QAction::triggered, this, [this] { panes_.moveToPane(true); });
  connect(actions_.previous_pane, &QAction::triggered, this, [this] { panes_.moveToPane(false); });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*old*/, QWidget* now) { panes_.noteFocus(now); });
  qApp->installEventFilter(this);
}

bool MainWindow::focusNextPrevChild(bool next) {
  return panes_.moveToControl(next) || QMainWindow::focusNextPrevChild(next);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // Space presses the button that has the focus before it takes a pose; the head of the step that is open has nothing
  // to be pressed for.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
      !watched->property(StepPanel::kIsOpen).toBool() &&
      (qobject_cast<QAbstractButton*>(watched) || qobject_cast<QComboBox*>(watched) ||
       qobject_cast<QAbstractSpinBox*>(watched))) {
    event->accept();
    return true;
  }
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace hexoderm
