#pragma once

#include "widgets/controls/panel_parts.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QTreeView>
#include <algorithm>
#include <functional>

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

/// Qt's, with columns as wide as their headings are in any language.
class FileDialog : public QFileDialog {
 public:
  FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {})
      : QFileDialog(parent, title, folder, filter) {
    // There is none if the system's own dialog is shown.
    for (const auto* files : findChildren<QTreeView*>()) {
      QHeaderView* header = files->header();
      header->ensurePolished();
      for (int k = 0; k < header->count(); ++k) {
        header->resizeSection(k, std::max(header->sectionSize(k), header->sectionSizeHint(k)));
      }
    }
  }
};

/// Asks for a file that is there, or for a folder, and hands over the one that is chosen. `name`: of the dialog, by
/// which it is found. Nothing is taken any more once `receiver` is gone.
inline void askForFile(QWidget* parent, const char* name, const QString& title, const QString& folder,
                       const QString& filter, const QObject* receiver, const std::function<void(const QString&)>& take,
                       QFileDialog::FileMode mode = QFileDialog::ExistingFile) {
  auto* dialog = named(new FileDialog(parent, title, folder, filter), name);
  dialog->setFileMode(mode);
  dialog->setOption(QFileDialog::ShowDirsOnly, mode == QFileDialog::Directory);
  QObject::connect(dialog, &QFileDialog::fileSelected, receiver, take);
  openInTurns(dialog);
}

/// The button that a dialog is answered by in most cases, also with Return. All `buttons` answer it.
inline QPushButton* addPrimaryButton(QDialog* dialog, QDialogButtonBox* buttons, const QString& text,
                                     const char* name) {
  QPushButton* button = named(buttons->addButton(text, QDialogButtonBox::AcceptRole), name);
  button->setProperty("primary", true);
  button->setDefault(true);
  // The button box has already had it styled as any other.
  button->style()->unpolish(button);
  button->style()->polish(button);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  return button;
}

}  // namespace hexoderm
