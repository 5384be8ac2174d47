#include "app/window/session/session_journal.h"

#include "app/window/files/job_queue.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <utility>
#include <vector>

namespace hexoderm {

SessionJournal::SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionRecorder::Open open,
                               Written opened, Told changed)
    : context_(context),
      jobs_(jobs),
      path_(std::move(path)),
      state_(std::make_shared<State>(State{0, {}, std::move(changed)})),
      recorder_(std::make_shared<SessionRecorder>(std::move(open), acknowledgement(std::move(opened)))) {}

SessionJournal::SessionJournal(QObject& context, JobQueue& jobs, QString path, SessionStore store, Told changed)
    : context_(context),
      jobs_(jobs),
      path_(std::move(path)),
      state_(std::make_shared<State>(State{0, {}, std::move(changed)})),
      recorder_(std::make_shared<SessionRecorder>(std::move(store))) {}

SessionJournal::~SessionJournal() {
  jobs_.add([recorder = std::move(recorder_)]() mutable { recorder.reset(); });
}

void SessionJournal::append(StoreOperation operation, Written written) {
  std::vector<StoreOperation> operations;
  operations.push_back(std::move(operation));
  recorder_->append(std::move(operations), acknowledgement(std::move(written)));
}

void SessionJournal::retry() { recorder_->retry(); }

SessionRecorder::Acknowledge SessionJournal::acknowledgement(Written written) {
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

}  // namespace hexoderm
