#include "app/window/presenters/history_presenter.h"

#include "app/window/files/earlier_panel.h"
#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "app/window/files/session_paths.h"
#include "app/window/guide/actions.h"
#include "app/window/guide/welcome_panel.h"
#include "app/window/log/event_log.h"
#include "app/window/presenters/file_presenter.h"
#include "app/window/session/session_controller.h"
#include "widgets/controls/message_bar.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>

namespace hexoderm {
namespace {

/// -1 where no session is open, as for a calibration.
int poseCountOf(const SessionController& controller) {
  return controller.session() ? static_cast<int>(controller.session()->poses().size()) : -1;
}

}  // namespace

HistoryPresenter::HistoryPresenter(const Views& views, const Lists& lists, const SessionController& controller,
                                   const WindowActions& actions, FilePresenter& files, EventLog& log)
    : views_(views), lists_(lists), controller_(controller), files_(files), log_(log) {
  connectRecent(actions);
  connectUnsaved();
}

void HistoryPresenter::connectRecent(const WindowActions& actions) {
  lists_.recent.serve(actions.recent, [this](const QString& path) { files_.openFile(path); });
  connect(&views_.welcome, &WelcomePanel::openWanted, &files_, &FilePresenter::openFile);
  connect(&views_.earlier, &EarlierPanel::openWanted, &files_, &FilePresenter::openFile);
  connect(&controller_, &SessionController::opened, this, &HistoryPresenter::noteOpened);
  connect(&controller_.file(), &SessionFile::sessionSaved, this, &HistoryPresenter::noteSaved);
  connect(&controller_, &SessionController::reconstructionChanged, this, &HistoryPresenter::notePoses);
}

void HistoryPresenter::noteOpened() {
  const QString path = controller_.session() ? controller_.file().sessionPath() : controller_.file().calibrationPath();
  if (path.isEmpty() || isInUnsavedFolder(path)) return;
  lists_.recent.note(path, poseCountOf(controller_));
}

void HistoryPresenter::noteSaved(const QString& path) { lists_.recent.note(path, poseCountOf(controller_)); }

/// The list says how many poses there are now.
void HistoryPresenter::notePoses() {
  const QString path = controller_.file().sessionPath();
  if (!controller_.session() || path.isEmpty() || lists_.recent.files().empty()) return;
  const RecentFile& newest = lists_.recent.files().front();
  const int poses = poseCountOf(controller_);
  if (newest.path == QDir::cleanPath(QFileInfo(path).absoluteFilePath()) && newest.poses != poses) {
    lists_.recent.note(path, poses);
  }
}

void HistoryPresenter::connectUnsaved() {
  connect(&lists_.unsaved, &UnsavedSessions::recoverWanted, &files_, &FilePresenter::openFile);
  connect(&controller_, &SessionController::opened, this,
          [this] { lists_.unsaved.noteOpened(controller_.file().sessionPath()); });
  connect(&lists_.unsaved, &UnsavedSessions::failed, this,
          [this](const QString& message) { views_.messages.showMessage(Tone::Bad, message); });
  connect(&lists_.unsaved, &UnsavedSessions::found, this, &HistoryPresenter::offerUnsaved);
}

void HistoryPresenter::offerUnsaved(int count) {
  if (count == 0) return;
  const UnsavedSession newest = lists_.unsaved.all().front();
  log_.add(Severity::Info, count == 1 ? tr("One session was not saved: %1").arg(newest.path)
                                      : tr("%1 sessions were not saved. The newest: %2").arg(count).arg(newest.path));
  // An operator who began with something else has not seen the welcome, which says it too.
  if ((controller_.isEmpty() && controller_.work().activity().isEmpty()) || !newest.problem.isEmpty()) return;
  views_.messages.showMessage(Tone::Caution, describeUnsaved(newest), tr("Recover"), [this, path = newest.path] {
    views_.messages.hide();
    lists_.unsaved.recover(path);
  });
}

void HistoryPresenter::search() {
  lists_.recent.check();
  lists_.unsaved.search();
}

void HistoryPresenter::refresh() {
  const bool is_connected = controller_.liveSession().source().isRunning();
  const bool is_welcome = controller_.isEmpty() && !is_connected;
  // After a key that opened something, the keys mean what the list of keys says; no neighbour gets the focus.
  if (!is_welcome && views_.welcome.isAncestorOf(QApplication::focusWidget())) views_.window.setFocus();
  views_.welcome.setVisible(is_welcome);
  // Beside what ends a connection, files would look like part of it.
  views_.earlier.setVisible(!is_welcome && !is_connected);
}

}  // namespace hexoderm
