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
class QStackedWidget;
class QTabBar;
class QTextBrowser;

namespace hexoderm {

class PackageList;

/// Asks for contents, place and format of an export, and of several patches for one where the format has one frame.
/// Or, on its second tab, for the files of a package, with what each will hold. Emits the request when it is accepted;
/// the receiver writes. Remembers the tab and the choice of a package.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `reconstruction`: what would be exported now, null if there is nothing; `suggestion`: path without an extension.
  ExportDialog(std::shared_ptr<const Reconstruction> reconstruction, const QString& suggestion,
               QWidget* parent = nullptr);

  [[nodiscard]] ExportRequest request() const;
  [[nodiscard]] PackageRequest packageRequest() const;

 signals:
  void exportRequested(const hexoderm::ExportRequest& request);
  void packageRequested(const hexoderm::PackageRequest& request);

 public slots:
  void accept() override;

 private:
  QWidget* makeFormatList();
  QWidget* makeOptions();
  /// The field of one option, which writes into options_.
  QWidget* makeOptionField(const ExportOptionDescription& option);
  QWidget* makeFileField(const ExportOptionDescription& option, QLineEdit* edit);
  void showOptions();
  QWidget* makePatchRow();
  /// The patches that can be chosen in the present format.
  void offerPatches();
  void chooseFormat();
  void choosePath();
  void check();
  [[nodiscard]] bool isPackage() const;
  void connectFields();
  /// One file, or a package.
  void chooseKind();
  void chooseContainer();
  void checkPackage();
  /// The formats whose options matter.
  [[nodiscard]] std::vector<ExportFormat> chosenFormats() const;
  [[nodiscard]] QString extension() const;
  /// What the present format and patch leave out; empty if nothing.
  [[nodiscard]] QString leftOut() const;

  std::shared_ptr<const Reconstruction> reconstruction_;
  QTabBar* kinds_;
  QStackedWidget* lists_;
  QStackedWidget* contents_;
  QListWidget* formats_;
  PackageList* package_;
  QLabel* summary_;
  QTextBrowser* preview_;
  QComboBox* container_;
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
