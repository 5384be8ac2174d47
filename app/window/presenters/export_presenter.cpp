#include "app/window/presenters/export_presenter.h"

#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/package_dialog.h"
#include "app/window/dialogs/report_title_dialog.h"
#include "app/window/guide/actions.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/report/report_pictures.h"
#include "app/window/report/report_title.h"
#include "app/window/session/session_controller.h"
#include "app/window/session/verification.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "hexoderm/session/simulated_session.h"

#include <QDir>
#include <utility>

namespace hexoderm {

ExportPresenter::ExportPresenter(QWidget& window, SessionController& controller, const Verification& verification,
                                 const WindowActions& actions, FilePresenter& files)
    : window_(window), controller_(controller), verification_(verification), files_(files) {
  connect(actions.export_to, &QAction::triggered, this, &ExportPresenter::showExportDialog);
  connect(actions.report, &QAction::triggered, this, &ExportPresenter::askForReport);
  connect(actions.report_title, &QAction::triggered, this,
          [this] { askForTitle(keptReportTitle(sessionKey()).value_or(proposedReportTitle()), tr("Keep"), [] {}); });
}

QString ExportPresenter::sessionKey() const {
  const SessionFile& file = controller_.file();
  for (const QString& path : {file.sessionPath(), file.calibrationPath()}) {
    if (!path.isEmpty()) return path;
  }
  return file.name();
}

ReportContent ExportPresenter::content() const {
  ReportContent content;
  content.reconstruction = controller_.reconstruction();
  if (!content.reconstruction) return content;
  content.name = controller_.file().name();
  content.pictures = takeReportPictures(content.reconstruction);
  content.made_at = QDateTime::currentDateTime();
  content.title = keptReportTitle(sessionKey()).value_or(ReportTitle());
  content.verify = verification_.outcome();
  const Session* session = controller_.session();
  content.simulated = isSimulated(content.reconstruction->source) || (session != nullptr && session->truth());
  return content;
}

void ExportPresenter::afterTitle(std::function<void()> proceed) {
  if (keptReportTitle(sessionKey())) {
    proceed();
    return;
  }
  askForTitle(proposedReportTitle(), tr("Continue"), std::move(proceed));
}

void ExportPresenter::askForTitle(const ReportTitle& title, const QString& button, std::function<void()> proceed) {
  auto* dialog = new ReportTitleDialog(title, controller_.file().name(), button, &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog, key = sessionKey(), proceed = std::move(proceed)] {
    keepReportTitle(key, dialog->title());
    // Another session may have been opened meanwhile; its report is another matter.
    if (key == sessionKey()) proceed();
  });
  openInTurns(dialog, Qt::NonModal);
}

void ExportPresenter::askForReport() {
  afterTitle([this] {
    files_.askForPath(tr("Write a report"), files_.suggestedName(),
                      tr("Documents (*.pdf);;Pages for the browser (*.html)"), QStringLiteral(".pdf"),
                      [this](const QString& path) { controller_.resultFiles().writeReport(content(), path); });
  });
}

void ExportPresenter::showExportDialog() {
  auto* dialog =
      new ExportDialog(controller_.reconstruction(), QDir(lastFolder()).filePath(files_.suggestedName()), &window_);
  connect(dialog, &ExportDialog::exportRequested, this, [this](const ExportRequest& request) {
    rememberFolder(request.path);
    controller_.resultFiles().exportTo(request);
  });
  connect(dialog, &ExportDialog::packageRequested, this, [this](const PackageRequest& request) {
    rememberFolder(request.path);
    if (request.hasReport()) {
      afterTitle([this, request] { startPackage(request); });
    } else {
      startPackage(request);
    }
  });
  openInTurns(dialog);
}

void ExportPresenter::startPackage(const PackageRequest& request) {
  if (!controller_.reconstruction()) return;
  auto* dialog = new PackageDialog(controller_.resultFiles(), request.path, &window_);
  connect(dialog, &PackageDialog::folderWanted, &files_, &FilePresenter::openFolderOf);
  openInTurns(dialog, Qt::WindowModal);
  controller_.resultFiles().exportPackage(request, content());
}

}  // namespace hexoderm
