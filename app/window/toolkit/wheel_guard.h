#pragma once

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QObject>
#include <QScrollBar>

class QCoreApplication;

namespace hexoderm {

/// Whoever scrolls a panel or a dialog must not change the number or the choice that happens to lie below the mouse: as
/// long as there is one of these, the wheel turns a field, a list to choose from or a slider only where that has the
/// keyboard's focus, and does not bring the focus there. Elsewhere it scrolls what is around.
class WheelGuard : public QObject {
 public:
  /// Watches all widgets of the application, those that come later too.
  explicit WheelGuard(QCoreApplication& application) { application.installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
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

 private:
  /// A control whose value the wheel would change; null: it is none.
  static QWidget* valueControl(QObject* watched) {
    const bool is_one =
        qobject_cast<QAbstractSpinBox*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr ||
        (qobject_cast<QAbstractSlider*>(watched) != nullptr && qobject_cast<QScrollBar*>(watched) == nullptr);
    return is_one ? static_cast<QWidget*>(watched) : nullptr;
  }

  /// Also where a part of it has it, as the line that is typed into.
  static bool hasKeyboard(const QWidget& control) {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && (focus == &control || control.isAncestorOf(focus));
  }
};

}  // namespace hexoderm
