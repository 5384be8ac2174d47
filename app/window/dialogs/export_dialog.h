#pragma once

#include "app/window/session/session_controller.h"

#include <QDialog>
#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace hexoderm {

/// Asks for contents, place and format of an export, and of several patches for one where the format has one frame.
/// Emits the request when it is accepted; the receiver writes.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `reconstruction`: what would be exported now, null if there is nothing; `suggestion`: path without an extension.
  ExportDialog(std::shared_ptr<const Reconstruction> reconstruction, const QString& suggestion,
               QWidget* parent = nullptr);

  [[nodiscard]] ExportRequest request() const;

 signals:
  void exportRequested(const hexoderm::ExportRequest& request);

 public slots:
  void accept() override;

 private:
  QWidget* makeFormatList();
  QWidget* makeOptions();
  /// The field of one option, which writes into options_.
  QWidget* makeOptionField(const ExportOptionDescription& option);
  QWidget* makeFileField(const ExportOptionDescription& option, QLineEdit* edit);
  void showOptionsOf(const std::optional<ExportFormatDescription>& format);
  QWidget* makePatchRow();
  /// The patches that can be chosen in the present format.
  void offerPatches();
  void chooseFormat();
  void choosePath();
  void check();
  [[nodiscard]] QString extension() const;
  /// What the present format and patch leave out; empty if nothing.
  [[nodiscard]] QString leftOut() const;

  std::shared_ptr<const Reconstruction> reconstruction_;
  QListWidget* formats_;
  QLabel* summary_;
  QLineEdit* path_;
  ExportOptions options_;
  /// The row of each of exportOptions().
  struct OptionRow {
    QLabel* label;
    QWidget* field;
  };
  std::vector<OptionRow> option_rows_;
  QWidget* patch_row_ = nullptr;
  QComboBox* patch_;
  QLabel* note_;
  QPushButton* export_;
  QString extension_;
};

}  // namespace hexoderm
