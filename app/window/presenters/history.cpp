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

/// A file that is open; -1 poses where no session is, as for a calibration.
void note(const WindowParts& parts, const QString& path) {
  const Session* session = parts.controller.session();
  parts.recent.note(path, session != nullptr ? static_cast<int>(session->poses().size()) : -1);
}

/// The list says how many poses there are now.
void notePoses(const WindowParts& parts) {
  const Session* session = parts.controller.session();
  const QString path = parts.controller.file().sessionPath();
  if (session == nullptr || path.isEmpty() || parts.recent.files().empty()) return;
  const RecentFile& newest = parts.recent.files().front();
  const bool is_news = newest.poses != static_cast<int>(session->poses().size());
  if (is_news && newest.path == QDir::cleanPath(QFileInfo(path).absoluteFilePath())) note(parts, path);
}

void noteOpened(const WindowParts& parts) {
  const SessionFile& file = parts.controller.file();
  const QString path = parts.controller.session() ? file.sessionPath() : file.calibrationPath();
  if (!path.isEmpty() && !isInUnsavedFolder(path)) note(parts, path);
}

void offerUnsaved(const WindowParts& parts, int count) {
  if (count == 0) return;
  const UnsavedSession newest = parts.unsaved.all().front();
  parts.log.add(Severity::Info,
                count == 1 ? WindowParts::tr("One session was not saved: %1").arg(newest.path)
                           : WindowParts::tr("%1 sessions were not saved. The newest: %2").arg(count).arg(newest.path));
  // An operator who began with something else has not seen the welcome, which says it too.
  const SessionController& controller = parts.controller;
  if ((controller.isEmpty() && controller.work().activity().isEmpty()) || !newest.problem.isEmpty()) return;
  parts.views.messages->showMessage(Tone::Caution, describeUnsaved(newest), WindowParts::tr("Recover"),
                                    [&parts, path = newest.path] {
                                      parts.views.messages->hide();
                                      parts.unsaved.recover(path);
                                    });
}

}  // namespace

void connectHistory(const WindowParts& parts, FilePresenter& files) {
  parts.recent.serve(parts.actions.recent, [&files](const QString& path) { files.openFile(path); });
  QObject::connect(parts.views.welcome, &WelcomePanel::openWanted, &files, &FilePresenter::openFile);
  QObject::connect(parts.views.earlier, &RecentSessions::openWanted, &files, &FilePresenter::openFile);
  QObject::connect(&parts.unsaved, &UnsavedSessions::recoverWanted, &files, &FilePresenter::openFile);
  QObject::connect(&parts.controller, &SessionController::opened, &parts.wires, [&parts] {
    noteOpened(parts);
    parts.unsaved.noteOpened(parts.controller.file().sessionPath());
  });
  QObject::connect(&parts.controller.file(), &SessionFile::sessionSaved, &parts.wires,
                   [&parts](const QString& path) { note(parts, path); });
  QObject::connect(&parts.controller, &SessionController::reconstructionChanged, &parts.wires,
                   [&parts] { notePoses(parts); });
  QObject::connect(&parts.unsaved, &UnsavedSessions::failed, &parts.wires,
                   [&parts](const QString& message) { parts.views.messages->showMessage(Tone::Bad, message); });
  QObject::connect(&parts.unsaved, &UnsavedSessions::found, &parts.wires,
                   [&parts](int count) { offerUnsaved(parts, count); });
}

/// The welcome is shown as long as nothing is open.
void refreshHistory(const WindowParts& parts) {
  const bool is_connected = parts.controller.liveSession().source().isRunning();
  const bool is_welcome = parts.controller.isEmpty() && !is_connected;
  WelcomePanel* const welcome = parts.views.welcome;
  // After a key that opened something, the keys mean what the list of keys says; no neighbour gets the focus.
  if (!is_welcome && welcome->isAncestorOf(QApplication::focusWidget())) parts.window.setFocus();
  welcome->setVisible(is_welcome);
  // Beside what ends a connection, files would look like part of it.
  parts.views.earlier->setVisible(!is_welcome && !is_connected);
}

}  // namespace hexoderm
