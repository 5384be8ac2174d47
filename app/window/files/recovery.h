#pragma once

#include "app/window/files/job_queue.h"
#include "app/window/files/recent_files.h"
#include "app/window/files/session_paths.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/session/session_store.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A session that was worked on and never saved, left over by a program that was killed or a machine that was switched
/// off.
struct UnsavedSession {
  QString path;
  std::int64_t edited_at_ms = 0;  ///< milliseconds since 1970, UTC; of a file that can't be read, the file's
  std::size_t poses = 0;
  std::size_t cells = 0;
  QString source;   ///< "Simulated x17 on ..."
  QString problem;  ///< why it can't be read; empty if it can
};

/// How long a session that was discarded can be taken back, and the folder that it lies in.
inline constexpr int kDaysUntilDiscardedGoes = 7;
inline const QString kDiscardedFolder = QStringLiteral("discarded");

/// The sessions `*.hexo` in a folder that no living process has open, the newest first; those without poses are not
/// worth a question and left out. Changes nothing. Reads every file: not on the GUI thread.
inline std::vector<UnsavedSession> findUnsavedSessions(const QString& folder) {
  std::vector<UnsavedSession> found;
  for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.hexo")}, QDir::Files)) {
    UnsavedSession unsaved;
    unsaved.path = file.absoluteFilePath();
    unsaved.edited_at_ms = file.lastModified().toMSecsSinceEpoch();
    try {
      if (isSessionStoreInUse(toPath(unsaved.path))) continue;
      const SessionStore store = SessionStore::openReadOnly(toPath(unsaved.path));
      const Session session = store.readSession();
      if (session.poses().empty()) continue;
      unsaved.edited_at_ms = store.editedAtMs();
      unsaved.poses = session.poses().size();
      unsaved.cells = session.neighbors().size();
      unsaved.source = words(session.source().text);
    } catch (const Error& error) {
      unsaved.problem = words(error);
    }
    found.push_back(std::move(unsaved));
  }
  std::ranges::sort(found, std::ranges::greater(), &UnsavedSession::edited_at_ms);
  return found;
}

/// Moves the file, with what SQLite keeps beside it, to `discarded/` in its folder; returns where it is now. Throws
/// StorageError. restoreDiscarded() takes it back.
inline QString discardUnsaved(const QString& path) {
  const QFileInfo file(path);
  const QDir folder(file.dir().filePath(kDiscardedFolder));
  if (!QDir().mkpath(folder.path())) {
    throw StorageError(located(folder.path().toStdString(), message("the folder cannot be made")));
  }
  const QString to = freePath(folder, file.completeBaseName());
  // The week begins now, whenever the session was worked on; without that it might be gone at the next start.
  std::error_code error;
  std::filesystem::last_write_time(toPath(path), std::filesystem::file_time_type::clock::now(), error);
  if (error) {
    throw StorageError(located(path.toStdString(), message("cannot be put away for a while: {}", systemReason(error))));
  }
  moveSessionStore(toPath(path), toPath(to));
  return to;
}

inline QString restoreDiscarded(const QString& discarded_path) {
  const QFileInfo file(discarded_path);
  QDir folder = file.dir();
  folder.cdUp();
  const QString to = freePath(folder, file.completeBaseName());
  moveSessionStore(toPath(discarded_path), toPath(to));
  return to;
}

/// Removes for good what was discarded more than a week ago.
inline void removeOldDiscarded(const QString& folder) {
  const QDir discarded(QDir(folder).filePath(kDiscardedFolder));
  const QDateTime limit = QDateTime::currentDateTime().addDays(-kDaysUntilDiscardedGoes);
  for (const QFileInfo& file : discarded.entryInfoList({QStringLiteral("*.hexo")}, QDir::Files)) {
    if (file.lastModified() < limit) removeSessionStore(toPath(file.absoluteFilePath()));
  }
}

/// The sessions that were not saved, as they were found at the start, and what the operator made of them since. Works
/// on files elsewhere than on the GUI thread.
class UnsavedSessions : public QObject {
  Q_OBJECT

 public:
  /// `jobs` must outlive this object.
  UnsavedSessions(JobQueue& jobs, QString folder, QObject* parent = nullptr)
      : QObject(parent), jobs_(jobs), folder_(std::move(folder)) {}

  /// Looks what there is; changed() and found() follow.
  void search() {
    jobs_.addFor(this, [folder = folder_] {
      removeOldDiscarded(folder);
      return [sessions = findUnsavedSessions(folder)](UnsavedSessions& self) {
        self.sessions_ = sessions;
        emit self.changed();
        emit self.found(static_cast<int>(self.sessions_.size()));
      };
    });
  }

  /// All sessions, including those that were discarded since.
  [[nodiscard]] const std::vector<UnsavedSession>& all() const { return sessions_; }

  [[nodiscard]] static bool isDiscarded(const UnsavedSession& session) {
    return QFileInfo(session.path).dir().dirName() == kDiscardedFolder;
  }

  /// recoverWanted() asks for it to be opened; until it is, it stays in the list.
  void recover(const QString& path) {
    const bool is_known = std::ranges::find(sessions_, path, &UnsavedSession::path) != sessions_.end();
    if (is_known) emit recoverWanted(QString(path));  // which may be of a session that goes meanwhile
  }

  /// It goes from the list, if it is there.
  void noteOpened(const QString& path) {
    const auto isIt = [&](const UnsavedSession& session) { return session.path == path; };
    if (std::erase_if(sessions_, isIt) > 0) emit changed();
  }

  /// Puts it away for a week; takeBack() until then.
  void discard(const QString& path) { move(path, &discardUnsaved); }
  void takeBack(const QString& path) { move(path, &restoreDiscarded); }

 signals:
  void found(int count);
  void changed();
  void recoverWanted(const QString& path);
  void failed(const QString& message);

 private:
  /// Changes where the session's file is, on the thread of the jobs.
  void move(const QString& path, QString (*how)(const QString&)) {
    jobs_.addFor(this, [path, how] {
      QString now;
      QString problem;
      try {
        now = how(path);
      } catch (const Error& error) {
        problem = words(error);
      }
      return [path, now, problem](UnsavedSessions& self) {
        if (!problem.isEmpty()) {
          emit self.failed(problem);
          return;
        }
        for (UnsavedSession& session : self.sessions_) {
          if (session.path == path) session.path = now;
        }
        emit self.changed();
      };
    });
  }

  JobQueue& jobs_;
  QString folder_;
  std::vector<UnsavedSession> sessions_;
};

/// "A session of today, 14:32 with 3 poses of 17 cells was not saved."
inline QString describeUnsaved(const UnsavedSession& session) {
  const QString when = timeText(session.edited_at_ms);
  if (!session.problem.isEmpty()) {
    return UnsavedSessions::tr("A session of %1 was not saved and can't be read: %2").arg(when, session.problem);
  }
  return UnsavedSessions::tr("A session of %1 with %2 of %3 cells was not saved.")
      .arg(when, posesText(session.poses))
      .arg(session.cells);
}

/// Says which sessions were not saved, each with "Recover" and "Discard", which can be undone. Hidden as long as there
/// are none.
class RecoveryList : public QWidget {
  Q_OBJECT

 public:
  /// `sessions` must outlive the list.
  explicit RecoveryList(UnsavedSessions& sessions, QWidget* parent = nullptr) : QWidget(parent), sessions_(sessions) {
    setNames(this, QStringLiteral("recoveryList"), tr("Sessions that were not saved"));
    layout_->setContentsMargins(0, 0, 0, 8);
    layout_->setSpacing(8);
    connect(&sessions_, &UnsavedSessions::changed, this, [this] {
      rebuild();
      setVisible(!sessions_.all().empty());
    });
    rebuild();
    setHidden(sessions_.all().empty());
  }

 private:
  void rebuild() {
    clearRows(*layout_);
    for (const UnsavedSession& session : sessions_.all()) {
      QWidget* row = makeRow(session);
      layout_->addWidget(row);
      row->show();
    }
  }

  [[nodiscard]] QWidget* makeRow(const UnsavedSession& session) {
    auto* row = styledAs(new QFrame, "card");
    const bool is_discarded = UnsavedSessions::isDiscarded(session);
    auto* text = new QLabel(is_discarded ? tr("Discarded; it is kept for %1 days.").arg(kDaysUntilDiscardedGoes)
                                         : describeUnsaved(session));
    text->setObjectName(QStringLiteral("unsavedText"));
    setPlainParagraph(text);
    text->setToolTip(session.source);
    const auto button = [&](const char* name, const QString& words, const QString& tip) {
      auto* made = new QPushButton(words);
      setNames(made, QLatin1String(name), words);
      made->setAccessibleDescription(text->text());
      made->setToolTip(tip);
      return made;
    };
    auto* layout = spaced(new QHBoxLayout(row), {12, 8, 8, 8});
    layout->addWidget(text, 1);
    const QString path = session.path;
    if (is_discarded) {
      auto* undo = button("undoDiscardButton", tr("Undo"), tr("Take the session back"));
      connect(undo, &QPushButton::clicked, &sessions_, [this, path] { sessions_.takeBack(path); });
      layout->addWidget(undo);
      return row;
    }
    auto* recover = button("recoverButton", tr("Recover"),
                           session.problem.isEmpty() ? tr("Open it and go on where it ended") : session.problem);
    recover->setEnabled(session.problem.isEmpty());
    connect(recover, &QPushButton::clicked, &sessions_, [this, path] { sessions_.recover(path); });
    layout->addWidget(recover);
    auto* discard = button("discardButton", tr("Discard"),
                           tr("Put it away; it can be taken back for %1 days").arg(kDaysUntilDiscardedGoes));
    connect(discard, &QPushButton::clicked, &sessions_, [this, path] { sessions_.discard(path); });
    layout->addWidget(discard);
    return row;
  }

  UnsavedSessions& sessions_;
  QVBoxLayout* layout_ = new QVBoxLayout(this);
};

/// The sessions of earlier times, for the step Connect: those that were not saved, and the newest of the recent files.
class RecentSessions : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive the panel.
  RecentSessions(RecentFiles& recent, UnsavedSessions& unsaved, QWidget* parent = nullptr) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(new RecoveryList(unsaved));
    auto* title = styledAs(new QLabel(tr("Recent").toUpper()), "caption");
    layout->addWidget(title);
    constexpr std::size_t kShown = 3;
    constexpr int kTitleCharacters = 22;
    auto* list = new RecentList(recent, kShown, kTitleCharacters);
    connect(list, &RecentList::openWanted, this, &RecentSessions::openWanted);
    layout->addWidget(list);
  }

 signals:
  void openWanted(const QString& path);
};

}  // namespace hexoderm
