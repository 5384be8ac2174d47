// The part of MainWindow that asks: which file, save first, close now.
#include "app/window/dialogs/export_dialog.h"
#include "app/window/guide/guide_window.h"
#include "app/window/main_window/main_window.h"
#include "app/window/main_window/window_shell.h"
#include "app/window/report/report_pictures.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "app/window/toolkit/file_dialog.h"
#include "widgets/controls/message_bar.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QLayout>
#include <QMessageBox>
#include <QMimeData>
#include <QStandardPaths>
#include <QTimer>
#include <QUrl>
#include <utility>

namespace hexoderm {
namespace {

const QString kSessionExtension = QStringLiteral(".session.json");
const QString kJournalExtension = QStringLiteral(".hexo");
const QString kCalibrationExtension = QStringLiteral(".calibration.json");

/// The one local file of a drag, if that is what is dragged.
QString droppedFile(const QMimeData* data) {
  return data->urls().size() == 1 && data->urls().front().isLocalFile() ? data->urls().front().toLocalFile()
                                                                        : QString();
}

/// Layouts have not caught up with a text that has just changed, inner ones ask outer ones for room; and a theme that
/// was just chosen may still wait for its turn.
void settle() {
  finishTheme();
  constexpr int kNested = 4;
  for (int k = 0; k < kNested; ++k) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

}  // namespace

void MainWindow::openFile(const QString& path) {
  rememberFolder(path);
  afterAskingToSave([this, path] { controller_.file().openFile(path); });
}

void MainWindow::startDemo() {
  afterAskingToSave([this] { controller_.liveSession().startDemo(); });
}

void MainWindow::askToOpen() {
  auto* dialog = new FileDialog(this, tr("Open a session or a calibration"), lastFolder());
  dialog->setObjectName(QStringLiteral("openDialog"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters({tr("Sessions and calibrations (*.hexo *.json *.xml)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openFile);
  openInTurns(dialog);
}

QString MainWindow::suggestedName() const {
  if (controller_.liveSession().isDemo() && controller_.file().sessionPath().isEmpty()) return QStringLiteral("demo");
  QString name = controller_.file().name();
  for (const QString& extension :
       {kSessionExtension, kJournalExtension, kCalibrationExtension, QStringLiteral(".xml")}) {
    if (name.endsWith(extension)) name.chop(extension.size());
  }
  return name;
}

void MainWindow::askForPath(const QString& title, const QString& name, const QString& filter, const QString& extension,
                            std::function<void(QString)> chosen) {
  auto* dialog = new FileDialog(this, title, lastFolder(), filter);
  dialog->setObjectName(QStringLiteral("saveDialog"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(extension.mid(1));
  dialog->selectFile(name + extension);
  connect(dialog, &QFileDialog::fileSelected, this, [chosen = std::move(chosen)](const QString& path) {
    rememberFolder(path);
    chosen(path);
  });
  // The name's extension follows the filter: "Sessions (*.hexo)".
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, name](const QString& chosen_filter) {
    const QString suffix = chosen_filter.section(QStringLiteral("(*."), 1).section(QLatin1Char(')'), 0, 0);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(name + QLatin1Char('.') + suffix);
  });
  connect(dialog, &QFileDialog::rejected, this, [this] { after_saving_ = nullptr; });
  openInTurns(dialog);
}

void MainWindow::saveSession(bool always_ask) {
  if (!controller_.session()) return;
  if (!always_ask && (controller_.file().isKept() || controller_.file().sessionPath().endsWith(kSessionExtension))) {
    controller_.file().saveSession(controller_.file().sessionPath());
    return;
  }
  askForPath(tr("Save the session"), suggestedName(),
             tr("Sessions (*.session.json);;Sessions that keep every change (*.hexo)"), kSessionExtension,
             [this](const QString& path) { controller_.file().saveSession(path); });
}

void MainWindow::saveCalibration() {
  askForPath(tr("Save the calibration"), suggestedName(), tr("Calibrations (*.calibration.json)"),
             kCalibrationExtension, [this](const QString& path) {
               controller_.resultFiles().exportTo({std::nullopt, path, {}});
             });
}

void MainWindow::showExportDialog() {
  auto* dialog = new ExportDialog(QDir(lastFolder()).filePath(suggestedName()), this);
  connect(dialog, &ExportDialog::exportRequested, this, [this](const ExportRequest& request) {
    rememberFolder(request.path);
    controller_.resultFiles().exportTo(request);
  });
  openInTurns(dialog);
}

void MainWindow::askForReport() {
  askForPath(tr("Write a report"), suggestedName(), tr("Documents (*.pdf);;Pages for the browser (*.html)"),
             QStringLiteral(".pdf"), [this](const QString& path) {
               if (!controller_.reconstruction()) return;
               controller_.resultFiles().writeReport(takeReportPictures(controller_.reconstruction()), path);
             });
}

QImage MainWindow::picture() {
  // The 3D view draws when there is time; until then a picture of the window would show its last state.
  settle();
  patch_view_->waitUntilUpToDate();
  patch_view_->drawNow();
  return pictureAsDrawn();
}

QImage MainWindow::pictureAsDrawn() {
  settle();
  return grab().toImage();
}

void MainWindow::savePicture() {
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QDir folder(QDir(pictures).exists() ? pictures : lastFolder());
  const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
  const QString path = folder.filePath(QStringLiteral("hexoderm-%1.png").arg(stamp));
  patch_view_->whenUpToDate([this, path] {
    // In two turns, because both take their time without a graphics card. A pause of 0 would be none: what is posted
    // comes before everything that waits.
    settle();
    patch_view_->drawNow();
    QTimer::singleShot(1, this, [this, path] { controller_.resultFiles().saveImage(pictureAsDrawn(), path); });
  });
}

void MainWindow::saveGraph() {
  askForPath(tr("Save a picture of the graph"), suggestedName() + tr("-graph"),
             tr("Vector graphics (*.svg);;Pictures (*.png)"), QStringLiteral(".svg"), [this](const QString& path) {
               controller_.resultFiles().savePicture(
                   [picture = graph_view_->picture(), path] { return picture.save(path); }, path);
             });
}

void MainWindow::showDone(const QString& text, const QString& path) {
  message_bar_->showMessage(Tone::Good, text, tr("Open folder"), [this, path] {
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
      message_bar_->showMessage(Tone::Caution,
                                tr("No program to show folders was found. The folder is %1.").arg(folder));
    }
  });
}

void MainWindow::afterAskingToSave(std::function<void()> proceed) {
  if (!controller_.file().hasUnsavedChanges()) {
    proceed();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved poses"),
                              tr("Save the session first? Its latest changes are not on disk yet."),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("unsavedBox"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setDefaultButton(QMessageBox::Save);
  box->setEscapeButton(QMessageBox::Cancel);
  connect(box, &QMessageBox::finished, this, [this, proceed = std::move(proceed)](int answer) {
    if (answer == QMessageBox::Discard) {
      proceed();
    } else if (answer == QMessageBox::Save) {
      after_saving_ = proceed;
      saveSession(false);
    }
  });
  box->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_close_ && controller_.file().hasUnsavedChanges()) {
    event->ignore();
    if (findChild<QMessageBox*>(QStringLiteral("unsavedBox"))) return;
    afterAskingToSave([this] {
      may_close_ = true;
      close();
    });
    return;
  }
  if (controller_.file().isWriting()) {
    // A file that is being written is finished first; it takes moments, and nothing waits for it here.
    event->ignore();
    close_when_written_ = true;
    return;
  }
  rememberLayout();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = droppedFile(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  openFile(path);
}

void MainWindow::buildShell() {
  shell_ = std::make_unique<WindowShell>(WindowShell::Window{
      *this, controller_, actions_, *message_bar_, [this](const QString& path) { openFile(path); },
      [this](ThemeChoice choice) { setThemeChoice(choice, true); },
      [this] {
        return static_cast<ThemeChoice>(actions_.themes->actions().indexOf(actions_.themes->checkedAction()));
      }});
}

void MainWindow::showGuide() {
  const QString page = guidePageFor(controller_);
  auto* guide = findChild<GuideWindow*>();
  if (guide == nullptr) {
    guide = new GuideWindow(this, page);
    guide->setAttribute(Qt::WA_DeleteOnClose);
    guide->setKeys(*findChild<QMenuBar*>());
  }
  guide->showPage(page);
  guide->show();
  guide->raise();
  guide->activateWindow();
}

void MainWindow::showAbout() {
  QMessageBox* box = new QMessageBox(QMessageBox::NoIcon, tr("About Hexoderm"),
                                     tr("<b>Hexoderm %1</b><p>Finds out where every cell of a robot's artificial skin "
                                        "is.</p><p>BSD 3-Clause licence.</p>")
                                         .arg(QLatin1String(HEXODERM_VERSION)),
                                     QMessageBox::Close, this);
  // The text is indented for an icon; the same room on the other side.
  constexpr int kIndent = 20;
  QMargins margins = box->layout()->contentsMargins();
  margins.setRight(margins.right() + kIndent);
  box->layout()->setContentsMargins(margins);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace hexoderm
