#pragma once

#include "app/window/files/job_queue.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/session/session_recorder.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <QObject>
#include <QString>
#include <QTime>
#include <cstdint>
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

class BackgroundWork;
class SessionController;

/// The file that the open session is kept in.
///
/// A session *.hexo is kept: every edit is written to it as it happens. Any other session has a scratch file from its
/// first edit on, so that a killed program loses nothing, and is saved on the operator's request. If not even a scratch
/// file can be written, the session is in memory only, and the operator is told.
class SessionFile : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this object.
  SessionFile(SessionController& controller, BackgroundWork& work);
  ~SessionFile() override;

  /// The name of what is open: its file's, or where it came from.
  [[nodiscard]] QString name() const { return name_; }
  /// The file to which Save writes without asking; empty if it must ask.
  [[nodiscard]] QString sessionPath() const { return session_path_; }
  /// The file that the open calibration was read from; empty if none is open.
  [[nodiscard]] QString calibrationPath() const { return calibration_path_; }
  /// Every change is written to sessionPath() as it happens.
  [[nodiscard]] bool isKept() const;
  /// For a session that is kept, only changes that could not be written count.
  [[nodiscard]] bool hasUnsavedChanges() const;
  [[nodiscard]] bool isWriting() const;
  /// When the session was last saved, or its file last written to; invalid if it never was.
  [[nodiscard]] QTime savedAt() const { return saved_at_; }

  // For the other parts of the session.

  /// The file that is being opened is not to be shown any more.
  void cancelOpening() { ++asked_count_; }
  /// Nothing is open any more; a scratch file goes.
  void close();
  void nameSession(const QString& name, const QString& path);
  void nameCalibration(const QString& path);
  /// Makes a new file of the session that is open, and keeps it there.
  void keepIn(const QString& path);
  void keepInScratch(const QString& name);
  /// An edit that the session just got.
  void record(const SessionEdit& edit);

 public slots:
  void openFile(const QString& path);
  /// A session of a simulated robot: a forearm with two patches and an elbow, in eight poses.
  void openRobotDemo();
  void saveSession(const QString& path);
  /// Writes what could not be written.
  void retryWriting();

 signals:
  void sessionSaved(const QString& path);
  /// The file can't be written; changes wait in memory. retryWriting() tries again.
  void journalStuck(const QString& why);
  /// The outcome of storing an added pose.
  void poseStored(hexoderm::PoseId pose, const hexoderm::StoreOutcome& outcome);
  /// No file keeps the session until it is saved; the operator was told.
  void keptInMemoryOnly();
  /// A session that was in memory only has a file that every change is written to.
  void keptInFile();

 private:
  [[nodiscard]] bool isJournalStuck() const;
  void append(const SessionEdit& edit);
  void dropJournal();
  [[nodiscard]] SessionJournal::Told told();
  void tellStored(const std::vector<SessionPose>& poses);
  void saveAsJson(const QString& path);
  void saveAsJournal(const QString& path);
  [[nodiscard]] QString suggestedScratchName() const;

  SessionController& controller_;
  BackgroundWork& work_;
  QString name_;
  QString session_path_;
  QString calibration_path_;
  QTime saved_at_;
  QString scratch_path_;        ///< path of the journal, if it is only kept until the session is saved
  bool scratch_fails_ = false;  ///< told once
  bool was_stuck_ = false;      ///< the operator was told that something is not on disk
  /// For each new file that the session is being copied into, the edits since then. They belong to the job that makes
  /// the file, so that they go with a job that fails.
  std::vector<std::weak_ptr<std::vector<SessionEdit>>> saves_under_way_;
  std::uint64_t asked_count_ = 0;   ///< the last request to open something; answers to earlier ones are dropped
  std::uint64_t opened_count_ = 0;  ///< which session or calibration this is; late answers for others are dropped
  std::unique_ptr<SessionJournal> journal_;
};

}  // namespace hexoderm
