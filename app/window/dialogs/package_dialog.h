#pragma once

#include "app/window/session/result_files.h"

#include <QDialog>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace hexoderm {

/// A package while it is written, with a button to cancel it, and then the list of what was written.
class PackageDialog : public QDialog {
  Q_OBJECT

 public:
  /// Follows the package that `files` writes next. Both outlive the dialog, which belongs to `parent`.
  PackageDialog(ResultFiles& files, const QString& path, QWidget* parent = nullptr);

 signals:
  void folderWanted(const QString& path);

 public slots:
  /// While it is written: cancels it, and closes once nothing is left of it.
  void reject() override;

 private:
  void showWritten(const QString& path, const std::vector<PackageEntry>& entries);
  void showFailure(const QString& message);
  void finish(const QString& sentence);

  ResultFiles& files_;
  QString path_;
  bool is_running_ = true;
  QLabel* sentence_;
  QProgressBar* progress_;
  QTreeWidget* list_;
  QPushButton* cancel_;
  QPushButton* open_;
};

}  // namespace hexoderm
