#pragma once

#include "hexoderm/session/session_recorder.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

namespace hexoderm {

class JobQueue;

/// The file *.hexo that a session is kept in while it is worked on: every change is appended as it happens, by a thread
/// of its own. What can't be written waits in memory, in order, until retry() or the next change.
class SessionJournal {
 public:
  /// Told on the thread of `context` about everything that became of something: `why` is empty for success.
  using Told = std::function<void(const QString& why)>;

  /// `open` runs on the journal's thread. `context` and `jobs` must outlive the journal; `changed` is called on the
  /// thread of `context`, as long as the journal lives, when the answers of the functions below may have changed.
  SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionRecorder::Open open, Told changed);
  /// For a store that is open already.
  SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionStore store, Told changed);
  /// Closes the file on the thread of `jobs`, after one last try.
  ~SessionJournal();
  SessionJournal(const SessionJournal&) = delete;
  SessionJournal& operator=(const SessionJournal&) = delete;

  /// `written` is called once it is on disk.
  void append(StoreOperation operation, std::function<void()> written = {});
  void retry();

  [[nodiscard]] const QString& path() const { return path_; }
  /// Something is not on disk yet.
  [[nodiscard]] bool isWaiting() const { return state_->waiting > 0; }
  /// Why what waits could not be written; empty if nothing went wrong.
  [[nodiscard]] const QString& problem() const { return state_->problem; }

 private:
  /// On the thread of `context`.
  struct State {
    std::size_t waiting = 0;
    QString problem;
    Told changed;
  };
  SessionRecorder::Acknowledge acknowledgement(std::function<void()> written);

  QObject& context_;
  JobQueue& jobs_;
  QString path_;
  std::shared_ptr<State> state_;
  std::shared_ptr<SessionRecorder> recorder_;  ///< its thread never touches this object
};

}  // namespace hexoderm
