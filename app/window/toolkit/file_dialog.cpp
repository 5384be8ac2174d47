#include "app/window/toolkit/file_dialog.h"

#include "app/window/toolkit/deferred_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QStyle>
#include <QTreeView>
#include <algorithm>

namespace hexoderm {

namespace {

void ask(FileDialog* dialog, const char* name, QFileDialog::FileMode mode, const QObject* receiver,
         const std::function<void(const QString&)>& take) {
  dialog->setObjectName(QLatin1String(name));
  dialog->setFileMode(mode);
  dialog->setOption(QFileDialog::ShowDirsOnly, mode == QFileDialog::Directory);
  QObject::connect(dialog, &QFileDialog::fileSelected, receiver, take);
  openInTurns(dialog);
}

}  // namespace

FileDialog::FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter)
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

void askForFile(QWidget* parent, const char* name, const QString& title, const QString& folder, const QString& filter,
                const QObject* receiver, const std::function<void(const QString&)>& take) {
  ask(new FileDialog(parent, title, folder, filter), name, QFileDialog::ExistingFile, receiver, take);
}

void askForFolder(QWidget* parent, const char* name, const QString& title, const QString& folder,
                  const QObject* receiver, const std::function<void(const QString&)>& take) {
  ask(new FileDialog(parent, title, folder), name, QFileDialog::Directory, receiver, take);
}

QPushButton* addPrimaryButton(QDialogButtonBox* buttons, const QString& text, const char* name) {
  QPushButton* button = buttons->addButton(text, QDialogButtonBox::AcceptRole);
  button->setObjectName(QLatin1String(name));
  button->setProperty("primary", true);
  button->setDefault(true);
  // The button box has already had it styled as any other.
  button->style()->unpolish(button);
  button->style()->polish(button);
  return button;
}

}  // namespace hexoderm
