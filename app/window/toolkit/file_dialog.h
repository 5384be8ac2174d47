#pragma once

#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/controls/panel_parts.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QPushButton>
#include <QStyle>
#include <QTreeView>
#include <algorithm>
#include <functional>

namespace hexoderm {

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

/// The button that a dialog is answered by in most cases, also with Return.
inline QPushButton* addPrimaryButton(QDialogButtonBox* buttons, const QString& text, const char* name) {
  QPushButton* button = named(buttons->addButton(text, QDialogButtonBox::AcceptRole), name);
  button->setProperty("primary", true);
  button->setDefault(true);
  // The button box has already had it styled as any other.
  button->style()->unpolish(button);
  button->style()->polish(button);
  return button;
}

}  // namespace hexoderm
