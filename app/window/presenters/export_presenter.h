#pragma once

#include "app/window/dialogs/export_dialog.h"
#include "app/window/dialogs/package_dialog.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/presenter.h"
#include "app/window/report/report.h"
#include "app/window/report/report_title.h"
#include "app/window/session/result_files.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/sim/simulated_session.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"

#include <QCoreApplication>
#include <QDir>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <functional>
#include <utility>

namespace hexoderm {

struct ReportPictures {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPictures)
};

/// As wide as the paper's column at the size that texts have there.
inline constexpr QSize kReportGraph(860, 400);

/// The picture that only a view can draw, the skin graph, for paper (the light colours, whatever the window has),
/// without anything that is there to be pressed. On the GUI thread. The patches are drawn with the report itself.
inline ReportPicture takeReportGraph(const std::shared_ptr<const Reconstruction>& reconstruction) {
  Selection nothing_picked;
  GraphView graph(&nothing_picked);
  graph.setPalette(qtPalette(Theme::Light));
  // Laid out as if it were shown, and not on any screen.
  graph.setAttribute(Qt::WA_DontShowOnScreen);
  graph.resize(kReportGraph);
  graph.show();
  graph.setReconstruction(reconstruction);
  graph.fit();
  return {ReportPictures::tr("Skin graph: the patches laid flat, their links by how well the poses determine them"),
          kReportGraph, [drawn = graph.picture()](QPainter& painter) { drawn.draw(painter); }};
}

/// Reports and exports: asks what they are to be, once for the title of a session's reports, and has them written.
class ExportPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ExportPresenter)

 public:
  ExportPresenter(const WindowParts& parts, const Verification& verification, FilePresenter& files)
      : Presenter(parts), verification_(verification), files_(files) {
    connect(actions.export_to, &QAction::triggered, this, &ExportPresenter::askForExport);
    connect(actions.report, &QAction::triggered, this, &ExportPresenter::askForReport);
    connect(actions.report_title, &QAction::triggered, this,
            [this] { askForTitle(keptReportTitle(sessionKey()).value_or(proposedReportTitle()), tr("Keep"), [] {}); });
  }

 private:
  /// By what the title is remembered.
  QString sessionKey() const {
    const SessionFile& file = controller.file();
    for (const QString& path : {file.sessionPath(), file.calibrationPath()}) {
      if (!path.isEmpty()) return path;
    }
    return file.name();
  }

  ReportContent content() const {
    ReportContent content;
    content.reconstruction = controller.reconstruction();
    if (!content.reconstruction) return content;
    content.name = controller.file().name();
    content.graph = takeReportGraph(content.reconstruction);
    content.made_at = QDateTime::currentDateTime();
    content.title = keptReportTitle(sessionKey()).value_or(ReportTitle());
    content.verify = verification_.outcome();
    const Session* session = controller.session();
    content.simulated = isSimulated(content.reconstruction->source) || (session != nullptr && session->truth());
    return content;
  }

  /// Calls `proceed` once it is known what stands at the head of a report; the operator is asked for it once a session.
  void afterTitle(std::function<void()> proceed) {
    if (keptReportTitle(sessionKey())) {
      proceed();
      return;
    }
    askForTitle(proposedReportTitle(), tr("Continue"), std::move(proceed));
  }

  void askForTitle(const ReportTitle& title, const QString& button, std::function<void()> proceed) {
    auto* dialog = new ReportTitleDialog(title, controller.file().name(), button, &window);
    connect(dialog, &QDialog::accepted, this, [this, dialog, key = sessionKey(), proceed = std::move(proceed)] {
      keepReportTitle(key, dialog->title());
      // Another session may have been opened meanwhile; its report is another matter.
      if (key == sessionKey()) proceed();
    });
    openInTurns(dialog, Qt::NonModal);
  }

  void askForReport() {
    afterTitle([this] {
      files_.askForPath(tr("Write a report"), files_.suggestedName(),
                        tr("Documents (*.pdf);;Pages for the browser (*.html)"), QStringLiteral(".pdf"),
                        [this](const QString& path) { controller.resultFiles().writeReport(content(), path); });
    });
  }

  /// Of what is not to be trusted the operator says first that it is to be exported all the same.
  void askForExport() {
    const auto result = controller.reconstruction();
    if (!result || result->assessment.level != VerdictLevel::NotTrusted) {
      showExportDialog();
      return;
    }
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Not to be trusted"), words(result->assessment.reason),
                                QMessageBox::Cancel, &window);
    box->setObjectName(QStringLiteral("untrustedBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* go_on = box->addButton(tr("Export all the same"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(go_on, &QPushButton::clicked, this, &ExportPresenter::showExportDialog);
    openInTurns(box);
  }

  void showExportDialog() {
    auto* dialog =
        new ExportDialog(controller.reconstruction(), QDir(lastFolder()).filePath(files_.suggestedName()), &window);
    connect(dialog, &ExportDialog::exportRequested, this, [this](const ExportRequest& request) {
      rememberFolder(request.path);
      controller.resultFiles().exportTo(request);
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

  void startPackage(const PackageRequest& request) {
    if (!controller.reconstruction()) return;
    auto* dialog = new PackageDialog(controller.resultFiles(), request.path, &window);
    connect(dialog, &PackageDialog::folderWanted, &files_, &FilePresenter::openFolderOf);
    openInTurns(dialog, Qt::WindowModal);
    controller.resultFiles().exportPackage(request, content());
  }

  const Verification& verification_;
  FilePresenter& files_;
};

}  // namespace hexoderm
