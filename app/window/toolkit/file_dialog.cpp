#include "app/window/toolkit/file_dialog.h"

#include <QHeaderView>
#include <QTreeView>
#include <algorithm>

namespace hexoderm {

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

}  // namespace hexoderm
