#pragma once

#include <QFileDialog>

namespace hexoderm {

/// Qt's, with columns as wide as their headings are in any language.
class FileDialog : public QFileDialog {
 public:
  FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {});
};

}  // namespace hexoderm
