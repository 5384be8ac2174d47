#include "app/window/toolkit/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace hexoderm {
namespace {

/// A control whose value the wheel would change; null: it is none.
QWidget* valueControl(QObject* watched) {
  const bool is_one =
      qobject_cast<QAbstractSpinBox*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr ||
      (qobject_cast<QAbstractSlider*>(watched) != nullptr && qobject_cast<QScrollBar*>(watched) == nullptr);
  return is_one ? static_cast<QWidget*>(watched) : nullptr;
}

/// Also where a part of it has it, as the line that is typed into.
bool hasKeyboard(const QWidget& control) {
  const QWidget* focus = QApplication::focusWidget();
  return focus != nullptr && (focus == &control || control.isAncestorOf(focus));
}

}  // namespace

WheelGuard::WheelGuard(QCoreApplication& application) { application.installEventFilter(this); }

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
  QWidget* control = valueControl(watched);
  if (control == nullptr) return false;
  if (event->type() == QEvent::Polish) {
    // Qt would give it the focus at the first turn of the wheel.
    if (control->focusPolicy() == Qt::WheelFocus) control->setFocusPolicy(Qt::StrongFocus);
    return false;
  }
  if (hasKeyboard(*control)) return false;
  // What is ignored goes on to what is around it.
  event->ignore();
  return true;
}

}  // namespace hexoderm
