#include "app/window/presenters/presenters.h"

#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "app/window/files/session_paths.h"
#include "app/window/presenters/file_presenter.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>

namespace hexoderm {
namespace {

/// -1 where no session is open, as for a calibration.
int poseCountOf(const SessionController& controller) {
  return controller.session() ? static_cast<int>(controller.session()->poses().size()) : -1;
}

/// Offers the sessions of earlier times: the recent ones, the ones that were not saved.
class HistoryPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::HistoryPresenter)

 public:
  HistoryPresenter(const WindowParts& parts, FilePresenter& files)
      : Presenter(parts), files_(files), recent_(parts.recent), unsaved_(parts.unsaved) {
    connectRecent();
    connectUnsaved();
  }

  /// The welcome is shown as long as nothing is open.
  void refresh() override {
    const bool is_connected = controller_.liveSession().source().isRunning();
    const bool is_welcome = controller_.isEmpty() && !is_connected;
    // After a key that opened something, the keys mean what the list of keys says; no neighbour gets the focus.
    if (!is_welcome && views_.welcome->isAncestorOf(QApplication::focusWidget())) window_.setFocus();
    views_.welcome->setVisible(is_welcome);
    // Beside what ends a connection, files would look like part of it.
    views_.earlier->setVisible(!is_welcome && !is_connected);
  }

 private:
  void connectRecent() {
    recent_.serve(actions_.recent, [this](const QString& path) { files_.openFile(path); });
    connect(views_.welcome, &WelcomePanel::openWanted, &files_, &FilePresenter::openFile);
    connect(views_.earlier, &EarlierPanel::openWanted, &files_, &FilePresenter::openFile);
    connect(&controller_, &SessionController::opened, this, &HistoryPresenter::noteOpened);
    connect(&controller_.file(), &SessionFile::sessionSaved, this, &HistoryPresenter::noteSaved);
    connect(&controller_, &SessionController::reconstructionChanged, this, &HistoryPresenter::notePoses);
  }

  void noteOpened() {
    const QString path =
        controller_.session() ? controller_.file().sessionPath() : controller_.file().calibrationPath();
    if (path.isEmpty() || isInUnsavedFolder(path)) return;
    recent_.note(path, poseCountOf(controller_));
  }

  void noteSaved(const QString& path) { recent_.note(path, poseCountOf(controller_)); }

  /// The list says how many poses there are now.
  void notePoses() {
    const QString path = controller_.file().sessionPath();
    if (!controller_.session() || path.isEmpty() || recent_.files().empty()) return;
    const RecentFile& newest = recent_.files().front();
    const int poses = poseCountOf(controller_);
    if (newest.path == QDir::cleanPath(QFileInfo(path).absoluteFilePath()) && newest.poses != poses) {
      recent_.note(path, poses);
    }
  }

  void connectUnsaved() {
    connect(&unsaved_, &UnsavedSessions::recoverWanted, &files_, &FilePresenter::openFile);
    connect(&controller_, &SessionController::opened, this,
            [this] { unsaved_.noteOpened(controller_.file().sessionPath()); });
    connect(&unsaved_, &UnsavedSessions::failed, this,
            [this](const QString& message) { views_.messages->showMessage(Tone::Bad, message); });
    connect(&unsaved_, &UnsavedSessions::found, this, &HistoryPresenter::offerUnsaved);
  }

  void offerUnsaved(int count) {
    if (count == 0) return;
    const UnsavedSession newest = unsaved_.all().front();
    log_.add(Severity::Info, count == 1 ? tr("One session was not saved: %1").arg(newest.path)
                                        : tr("%1 sessions were not saved. The newest: %2").arg(count).arg(newest.path));
    // An operator who began with something else has not seen the welcome, which says it too.
    if ((controller_.isEmpty() && controller_.work().activity().isEmpty()) || !newest.problem.isEmpty()) return;
    views_.messages->showMessage(Tone::Caution, describeUnsaved(newest), tr("Recover"), [this, path = newest.path] {
      views_.messages->hide();
      unsaved_.recover(path);
    });
  }

  FilePresenter& files_;
  RecentFiles& recent_;
  UnsavedSessions& unsaved_;
};

}  // namespace

std::unique_ptr<Presenter> makeHistoryPresenter(const WindowParts& parts, FilePresenter& files) {
  return std::make_unique<HistoryPresenter>(parts, files);
}

}  // namespace hexoderm
