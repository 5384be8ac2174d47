#pragma once

#include "app/window/report/report.h"
#include "app/window/session/result_files.h"

#include <QObject>
#include <functional>

class QWidget;

namespace hexoderm {

class FilePresenter;
class SessionController;
class Verification;
class WindowActions;

/// Reports and exports: asks what they are to be, once for the title of a session's reports, and has them written.
class ExportPresenter : public QObject {
  Q_OBJECT

 public:
  /// All outlive the presenter; dialogs belong to `window`.
  ExportPresenter(QWidget& window, SessionController& controller, const Verification& verification,
                  const WindowActions& actions, FilePresenter& files);

 private:
  void askForReport();
  void showExportDialog();
  void startPackage(const PackageRequest& request);
  /// Calls `proceed` once it is known what stands at the head of a report; the operator is asked for it once a session.
  void afterTitle(std::function<void()> proceed);
  void askForTitle(const ReportTitle& title, const QString& button, std::function<void()> proceed);
  /// By what the title is remembered.
  [[nodiscard]] QString sessionKey() const;
  [[nodiscard]] ReportContent content() const;

  QWidget& window_;
  SessionController& controller_;
  const Verification& verification_;
  FilePresenter& files_;
};

}  // namespace hexoderm
