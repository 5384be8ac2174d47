#pragma once

#include "app/window/session/background_work.h"
#include "app/window/session/live_mode.h"
#include "app/window/session/live_session.h"
#include "app/window/session/result_files.h"
#include "app/window/session/session_commands.h"
#include "app/window/session/session_file.h"
#include "hexoderm/solve/reconstruction_worker.h"

#include <QObject>
#include <QUndoStack>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

/// The session that is open, with its newest result. It lives on the window's thread and never waits; a worker solves
/// every revision. It owns the parts that deal with files and the connected skin.
class SessionController : public QObject {
  Q_OBJECT

 public:
  explicit SessionController(QObject* parent = nullptr);
  ~SessionController() override;

  [[nodiscard]] SessionFile& file() { return file_; }
  [[nodiscard]] const SessionFile& file() const { return file_; }
  [[nodiscard]] ResultFiles& resultFiles() { return result_files_; }
  [[nodiscard]] LiveSession& liveSession() { return live_session_; }
  [[nodiscard]] const LiveSession& liveSession() const { return live_session_; }
  [[nodiscard]] LiveMode& liveMode() { return live_mode_; }
  [[nodiscard]] const LiveMode& liveMode() const { return live_mode_; }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }

  /// Null if nothing is open, or a calibration is.
  [[nodiscard]] const Session* session() const { return session_.get(); }
  /// The newest result; null until there is one.
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }
  /// While the first result of a large skin is being worked out, its cells as far as they are placed
  /// (SolveProgress::setPlacementsReport()): no result yet. Null before and after.
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& firstPlacements() const { return first_placements_; }
  [[nodiscard]] QUndoStack* undoStack() { return &undo_stack_; }
  [[nodiscard]] bool isEmpty() const { return !session_ && !reconstruction_; }
  [[nodiscard]] const SolverOptions& solverOptions() const { return options_; }
  [[nodiscard]] std::size_t enabledPoses() const;
  /// A change of the session has no result yet.
  [[nodiscard]] bool isSolving() const { return session_ && shown_revision_ < submitted_revision_; }
  /// The operator gave up what was being solved: the result, if there is one, is from before the last change.
  [[nodiscard]] bool wasCancelled() const { return was_cancelled_; }
  /// How far what is being solved is.
  [[nodiscard]] const SolveProgress& progress() const { return *progress_; }
  /// The shown result is that of the session as it is now: no change is being solved, none failed.
  [[nodiscard]] bool isCurrent() const {
    return reconstruction_ && (!session_ || reconstruction_->revision == submitted_revision_);
  }
  /// Counts the changes of all sessions that were open.
  [[nodiscard]] std::uint64_t submittedRevision() const { return submitted_revision_; }
  /// Place of a pose of the shown reconstruction among the session's poses, which may be ahead of it.
  [[nodiscard]] std::optional<std::size_t> sessionIndexOfPoseRow(int row) const;

  /// Place among the session's poses of the first one that should be taken again, as the result's assessment says.
  [[nodiscard]] std::optional<std::size_t> indexToRetake() const;

  /// Solves by `solve` from now on, in place of reconstruct(): for tests of what takes long.
  void setSolve(ReconstructionWorker::Solve solve);

  // For the parts.

  void showSession(std::unique_ptr<Session> session, const QString& name, const QString& path);
  void showCalibration(std::shared_ptr<const Reconstruction> calibration, const QString& path);
  /// One step for undo. `text` names it; one of a single edit has a name of its own.
  void perform(const std::vector<SessionEdit>& edits, const QString& text = {});
  /// An edit that the operator can't undo.
  void performForGood(const SessionEdit& edit);

 public slots:
  void setPoseDisabled(std::size_t index, bool disabled);
  void removePose(std::size_t index);
  /// Keeps a link out of the solution, or lets it in again.
  void setLinkMuted(LinkEnd a, LinkEnd b, bool muted);
  /// Solves anew with these.
  void setSolverOptions(const hexoderm::SolverOptions& options);
  /// Gives up what is being solved. The change stays, and so does the result from before it.
  void cancelSolving();
  /// Solves what was given up after all.
  void solveAgain();

 signals:
  /// Anything about the session, or about one of the parts, changed.
  void changed();
  void reconstructionChanged(std::shared_ptr<const hexoderm::Reconstruction> reconstruction);
  /// There are other ones, or none any more; not emitted where reconstructionChanged() takes their place.
  void firstPlacementsChanged();
  void opened(const QString& name);
  /// One message for a person, as core said it. From the parts too.
  void failed(const QString& message);
  /// Something that is no failure and should be known. From the parts too.
  void noticed(const QString& text);

 private:
  void connectParts();
  void closeCurrent();
  void submit();
  /// An edit that needs no solving: the session's robot, its joint angles or the places of patches on it.
  void noteRobot();
  void receive(const ReconstructionOutcome& outcome);
  /// On the thread that solves.
  void notePlacements(const std::shared_ptr<const Reconstruction>& placements);
  void setFirstPlacements(std::shared_ptr<const Reconstruction> placements);
  [[nodiscard]] std::unique_ptr<ReconstructionWorker> makeWorker(ReconstructionWorker::Solve solve);
  [[nodiscard]] EditedSession edited();
  [[nodiscard]] std::optional<std::size_t> indexOf(PoseId pose) const;

  std::unique_ptr<Session> session_;
  SolverOptions options_;
  std::shared_ptr<const Reconstruction> reconstruction_;
  std::shared_ptr<const Reconstruction> first_placements_;
  QUndoStack undo_stack_;
  std::uint64_t submitted_revision_ = 0;  ///< counts over all sessions, unlike the session's own
  std::uint64_t first_revision_ = 1;      ///< of the session that is open
  std::uint64_t shown_revision_ = 0;
  bool needs_solving_ = false;   ///< an edit of the present step does
  bool robot_is_newer_ = false;  ///< than in what is being solved
  bool was_cancelled_ = false;
  std::shared_ptr<SolveProgress> progress_ = std::make_shared<SolveProgress>();

  // Last, so that their threads have ended before anything they report to goes. The file leaves its end to the work.
  std::unique_ptr<ReconstructionWorker> worker_;
  BackgroundWork work_;
  ResultFiles result_files_;
  LiveSession live_session_;
  LiveMode live_mode_;
  SessionFile file_;
};

}  // namespace hexoderm
