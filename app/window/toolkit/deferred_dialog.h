#pragma once

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QTimer>

namespace hexoderm {

/// A timer, for other posted events would be served in the same turn.
inline constexpr int kNextTurn_ms = 1;

/// Keeps keys and clicks from a window, which would be taken for its own although they came after a dialog was asked
/// for: the key that opens it, hit twice, or a name typed ahead.
class InputHold : public QObject {
 public:
  InputHold(const QWidget* window, QObject* parent) : QObject(parent), window_(window) {
    qApp->installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    switch (event->type()) {
      case QEvent::Shortcut:  // an action's, whose window it does not tell
        return true;
      case QEvent::ShortcutOverride:
      case QEvent::KeyPress:
      case QEvent::MouseButtonPress:
      case QEvent::MouseButtonDblClick:
      case QEvent::Wheel: {
        const auto* widget = qobject_cast<const QWidget*>(watched);
        return widget && widget->window() == window_;
      }
      default:
        return false;
    }
  }

 private:
  const QWidget* window_;
};

/// Shows a window in front of the others, with the keyboard; one that is shown already, too.
inline void bringToFront(QWidget* window) {
  window->show();
  window->raise();
  window->activateWindow();
}

/// Opens a dialog in a later turn of the event loop than the one that has made it, and deletes it in a later one than
/// the one that has closed it, so that clicks and keys wait for one of them at a time. Until a modal dialog is there,
/// its parent's window takes no keys and no clicks, as it will not after that.
inline void openInTurns(QDialog* dialog, Qt::WindowModality modality = Qt::WindowModal) {
  const bool is_modal = modality != Qt::NonModal;
  dialog->setWindowModality(modality);
  InputHold* hold =
      is_modal && dialog->parentWidget() ? new InputHold(dialog->parentWidget()->window(), dialog) : nullptr;
  QTimer::singleShot(kNextTurn_ms, dialog, [dialog, is_modal, hold] {
    if (is_modal) {
      dialog->show();
    } else {
      bringToFront(dialog);
    }
    delete hold;
  });
  QObject::connect(dialog, &QDialog::finished, dialog,
                   [dialog] { QTimer::singleShot(kNextTurn_ms, dialog, &QObject::deleteLater); });
}

}  // namespace hexoderm
