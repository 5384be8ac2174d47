#pragma once

#include "app/window/files/job_queue.h"
#include "hexoderm/session/session_recorder.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hexoderm {

/// The file *.hexo that a session is kept in while it is worked on: every change is appended as it happens, by a thread
/// of its own. A change that can't be written waits in memory, in order, until retry() or the next change.
class SessionJournal {
 public:
  /// Called on the thread of `context` after every outcome; `why` is empty for success.
  using Told = std::function<void(const QString& why)>;
  /// Called on the thread of `context`, before Told, with what became of one change: see SessionRecorder.
  using Written = std::function<void(const StoreOutcome& outcome)>;

  /// `open` runs on the journal's thread, `opened` is told about it. `context` and `jobs` must outlive the journal;
  /// `changed` is called on the thread of `context`, as long as the journal lives, when the answers of the functions
  /// below may have changed.
  SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionRecorder::Open open, Written opened,
                 Told changed)
      : SessionJournal(context, jobs, std::move(path), std::move(changed)) {
    recorder_ = std::make_shared<SessionRecorder>(std::move(open), acknowledgement(std::move(opened)));
  }

  /// For a store that is open already.
  SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionStore store, Told changed)
      : SessionJournal(context, jobs, std::move(path), std::move(changed)) {
    recorder_ = std::make_shared<SessionRecorder>(std::move(store));
  }

  /// Closes the file on the thread of `jobs`, after one last try.
  ~SessionJournal() {
    jobs_.add([recorder = std::move(recorder_)]() mutable { recorder.reset(); });
  }

  SessionJournal(const SessionJournal&) = delete;
  SessionJournal& operator=(const SessionJournal&) = delete;

  void append(StoreOperation operation, Written written = {}) {
    std::vector<StoreOperation> operations;
    operations.push_back(std::move(operation));
    recorder_->append(std::move(operations), acknowledgement(std::move(written)));
  }

  void retry() { recorder_->retry(); }

  [[nodiscard]] const QString& path() const { return path_; }
  /// Something is not on disk yet.
  [[nodiscard]] bool isWaiting() const { return state_->waiting > 0; }
  /// The reason that a change waits for; empty if nothing went wrong.
  [[nodiscard]] const QString& problem() const { return state_->problem; }

 private:
  /// On the thread of `context`.
  struct State {
    std::size_t waiting = 0;
    QString problem;
    Told changed;
  };
  SessionJournal(QObject& context, JobQueue& jobs, QString path, Told changed)
      : context_(context),
        jobs_(jobs),
        path_(std::move(path)),
        state_(std::make_shared<State>(State{0, {}, std::move(changed)})) {}

  SessionRecorder::Acknowledge acknowledgement(Written written) {
    ++state_->waiting;
    return
        [context = &context_, weak = std::weak_ptr(state_), written = std::move(written)](const StoreOutcome& outcome) {
          QMetaObject::invokeMethod(
              context,
              [weak, written, outcome] {
                const std::shared_ptr<State> state = weak.lock();
                if (!state) return;
                state->problem = words(outcome.error);
                if (!outcome.is_kept) --state->waiting;
                if (written) written(outcome);
                // `changed` may replace the journal, and with it the function that runs.
                const Told changed = state->changed;
                changed(state->problem);
              },
              Qt::QueuedConnection);
        };
  }

  QObject& context_;
  JobQueue& jobs_;
  QString path_;
  std::shared_ptr<State> state_;
  std::shared_ptr<SessionRecorder> recorder_;  ///< its thread never touches this object
};

}  // namespace hexoderm
