#pragma once

#include "app/window/session/session_controller.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace hexoderm {

/// Asks for contents, place and format of an export. Emits the request when it is accepted; the receiver writes.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `suggestion`: path without an extension.
  explicit ExportDialog(const QString& suggestion, QWidget* parent = nullptr);

  [[nodiscard]] ExportRequest request() const;

 signals:
  void exportRequested(const hexoderm::ExportRequest& request);

 public slots:
  void accept() override;

 private:
  QWidget* makeFormatList();
  QWidget* makeOptions();
  void chooseFormat();
  void choosePath();
  void check();
  [[nodiscard]] QString extension() const;

  QListWidget* formats_;
  QLabel* summary_;
  QLineEdit* path_;
  QStackedWidget* options_;
  QComboBox* stl_unit_;
  QLineEdit* urdf_robot_;
  QLineEdit* urdf_parent_;
  QLineEdit* urdf_prefix_;
  QComboBox* urdf_links_;
  QLabel* note_;
  QPushButton* export_;
  QString extension_;
};

}  // namespace hexoderm
