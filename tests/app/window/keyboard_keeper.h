#pragma once

#include <QApplication>
#include <QObject>
#include <QPointer>
#include <QTimerEvent>
#include <QWidget>
#include <QWindow>

namespace hexoderm {

/// Gives the keyboard to a window of the program whenever none of them has it: what a window manager does.
///
/// The tests run on a bare X server. There, a dialog that closes leaves the keyboard nowhere, and the one request that
/// Qt makes for a window that opens, or that is left, is lost if X does not show that window yet. How often that
/// happens depends on the machine, so the request is repeated until it has come.
class KeyboardKeeper : public QObject {
 public:
  KeyboardKeeper() { startTimer(kInterval_ms); }

 protected:
  void timerEvent(QTimerEvent* /*event*/) override {
    if (QApplication::activePopupWidget() != nullptr) return;
    QWidget* active = QApplication::activeWindow();
    QWidget* dialog = QApplication::activeModalWidget();
    if (active != nullptr && !isBlockedBy(dialog, active)) {
      last_ = active;
      return;
    }
    QWidget* window = dialog != nullptr ? dialog : leftWindow();
    if (window == nullptr) return;
    if (QGuiApplication::focusWindow() == window->windowHandle()) {
      // X gave it the keyboard while the dialog was still closing, and Qt 5.15.15 forgets to tell its widgets.
      QApplication::setActiveWindow(window);
    } else {
      window->activateWindow();
    }
  }

 private:
  static constexpr int kInterval_ms = 50;

  static bool isBlockedBy(const QWidget* dialog, const QWidget* window) {
    return dialog != nullptr && dialog != window && dialog->isVisible() && dialog->parentWidget() != nullptr &&
           dialog->parentWidget()->window() == window;
  }

  /// The window that had the keyboard last, or else one that can have it.
  [[nodiscard]] QWidget* leftWindow() const {
    if (last_ && last_->isVisible()) return last_;
    for (QWidget* window : QApplication::topLevelWidgets()) {
      if (window->isVisible() && window->windowType() == Qt::Window) return window;
    }
    return nullptr;
  }

  QPointer<QWidget> last_;
};

}  // namespace hexoderm
