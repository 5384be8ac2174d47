#pragma once

#include "app/window/session/background_work.h"
#include "app/window/session/live_session.h"
#include "app/window/session/result_files.h"
#include "app/window/session/session_file.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/solve/reconstruction_worker.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QObject>
#include <QUndoCommand>
#include <QUndoStack>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A session that is edited, and whoever keeps it. Both outlive the commands that refer to them.
struct EditedSession {
  Session& session;
  std::function<void(const SessionEdit&)> changed;  ///< told about every edit after it was made
};

/// An edit of a session as a step of the undo stack.
class EditCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::EditCommand)

 public:
  EditCommand(EditedSession edited, SessionEdit edit) : edited_(std::move(edited)), next_(std::move(edit)) {
    const std::vector<SessionPose>& poses = edited_.session.poses();
    if (const auto* add = std::get_if<AddPose>(&next_)) {
      setText(tr("take pose %1").arg(idOf(add->pose)));
    } else if (const auto* remove = std::get_if<RemovePose>(&next_)) {
      setText(tr("delete pose %1").arg(idOf(poses.at(remove->index))));
    } else if (const auto* set = std::get_if<SetPoseDisabled>(&next_)) {
      const QString pose = idOf(poses.at(set->index));
      setText(set->disabled ? tr("disable pose %1").arg(pose) : tr("enable pose %1").arg(pose));
    } else if (const auto* joints = std::get_if<SetJointAngles>(&next_)) {
      setText(tr("set the joint angles of pose %1").arg(idOf(poses.at(joints->index))));
    } else if (const auto* robot = std::get_if<SetRobot>(&next_)) {
      setText(robot->robot ? tr("choose the robot") : tr("remove the robot"));
    } else if (const auto* placed = std::get_if<SetPatchPlacement>(&next_)) {
      const QString cell = QString::number(placed->placement.origin.value());
      setText(tr("place the patch of cell %1").arg(cell));
    } else if (std::holds_alternative<SetSkinSide>(next_)) {
      setText(tr("say where the skin lies"));
    } else if (const auto* excluded = std::get_if<SetLinkMuted>(&next_)) {
      const QString link = shortLinkName(std::min(excluded->a, excluded->b), std::max(excluded->a, excluded->b));
      setText(excluded->muted ? tr("set link %1 aside").arg(link) : tr("take link %1 back").arg(link));
    }
  }

  void redo() override { step(); }
  void undo() override { step(); }

 private:
  static QString idOf(const SessionPose& pose) { return QString::number(pose.capture->id.value()); }

  /// Applies the next edit; its inverse is the next one then.
  void step() {
    const SessionEdit edit = std::exchange(next_, inverse(next_, edited_.session));
    apply(edit, edited_.session);
    edited_.changed(edit);
  }

  EditedSession edited_;
  SessionEdit next_;
};

/// The session that is open, with its newest result. It lives on the window's thread and never waits; a worker solves
/// every revision. It owns the parts that deal with files and the connected skin.
class SessionController : public QObject {
  Q_OBJECT

 public:
  explicit SessionController(QObject* parent = nullptr)
      : QObject(parent),
        undo_stack_(this),
        worker_(makeWorker(ReconstructionWorker::startingFromTheLast(progress_))),
        result_files_(*this, work_),
        live_session_(*this),
        live_mode_(*this),
        file_(*this, work_) {
    connect(&undo_stack_, &QUndoStack::indexChanged, this, [this] {
      if (!session_) return;
      if (std::exchange(needs_solving_, false)) {
        submit();
      } else {
        noteRobot();
      }
    });
    connect(&undo_stack_, &QUndoStack::cleanChanged, this, &SessionController::changed);
    progress_->setPlacementsReport([this](const auto& placements) { notePlacements(placements); }, kLargeSkin);
    connectParts();
  }

  ~SessionController() override {
    // The stack says so when it is cleared, and by then the worker is gone.
    disconnect(&undo_stack_, nullptr, this, nullptr);
  }

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

  [[nodiscard]] std::size_t enabledPoses() const {
    if (!session_) return 0;
    return static_cast<std::size_t>(std::ranges::count(session_->poses(), false, &SessionPose::disabled));
  }

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
  [[nodiscard]] std::optional<std::size_t> sessionIndexOfPoseRow(int row) const {
    if (!session_ || !reconstruction_ || row < 0 || static_cast<std::size_t>(row) >= reconstruction_->poses.size()) {
      return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(row);
    const PoseId id = reconstruction_->poses[index].pose;
    const std::vector<SessionPose>& poses = session_->poses();
    // Several poses of a file may carry one number; as long as nothing changed, the row says which is meant.
    return index < poses.size() && poses[index].capture->id == id ? std::optional(index) : indexOf(id);
  }

  /// Place among the session's poses of the first one that should be taken again, as the result's assessment says.
  [[nodiscard]] std::optional<std::size_t> indexToRetake() const {
    if (!session_ || !reconstruction_ || reconstruction_->assessment.retake.empty()) return std::nullopt;
    return indexOf(reconstruction_->assessment.retake.front());
  }

  /// Solves by `solve` from now on, in place of reconstruct(): for tests of what takes long.
  void setSolve(ReconstructionWorker::Solve solve) { worker_ = makeWorker(std::move(solve)); }

  // For the parts.

  void showSession(std::unique_ptr<Session> session, const QString& name, const QString& path) {
    closeCurrent();
    session_ = std::move(session);
    file_.nameSession(name, path);
    emit reconstructionChanged(nullptr);
    submit();
    emit opened(name);
  }

  void showCalibration(std::shared_ptr<const Reconstruction> calibration, const QString& path) {
    closeCurrent();
    file_.nameCalibration(path);
    reconstruction_ = std::move(calibration);
    emit reconstructionChanged(reconstruction_);
    emit opened(file_.name());
  }

  /// One step for undo. `text` names it; one of a single edit has a name of its own.
  void perform(const std::vector<SessionEdit>& edits, const QString& text = {}) {
    const bool is_macro = edits.size() > 1;
    if (is_macro) undo_stack_.beginMacro(text);
    for (const SessionEdit& edit : edits) {
      auto* command = new EditCommand(edited(), edit);
      if (!text.isEmpty()) command->setText(text);
      undo_stack_.push(command);
    }
    if (is_macro) undo_stack_.endMacro();
  }

  /// An edit that the operator can't undo.
  void performForGood(const SessionEdit& edit) {
    apply(edit, *session_);
    file_.record(edit);
    submit();
  }

 public slots:
  void setPoseDisabled(std::size_t index, bool disabled) {
    if (!session_ || index >= session_->poses().size() || session_->poses()[index].disabled == disabled) return;
    perform({SetPoseDisabled{index, disabled, {}}});
  }

  void removePose(std::size_t index) {
    if (!session_ || index >= session_->poses().size()) return;
    perform({RemovePose{index}});
  }

  /// Keeps a link out of the solution, or lets it in again.
  void setLinkMuted(LinkEnd a, LinkEnd b, bool muted) {
    if (!session_ || a == b || (session_->findMutedLink(a, b) != nullptr) == muted) return;
    perform({SetLinkMuted{a, b, muted, {}}});
  }

  /// Solves anew with these.
  void setSolverOptions(const hexoderm::SolverOptions& options) {
    options_ = options;
    if (session_) submit();
  }

  /// Gives up what is being solved. The change stays, and so does the result from before it.
  void cancelSolving() {
    if (!isSolving()) return;
    worker_->cancel();
    // What still comes of it is not looked at.
    shown_revision_ = submitted_revision_;
    was_cancelled_ = true;
    setFirstPlacements(nullptr);
    // The robot would wait for the result.
    live_session_.setRobot(false);
    emit changed();
  }

  /// Solves what was given up after all.
  void solveAgain() {
    if (session_ && was_cancelled_) submit();
  }

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
  void connectParts() {
    connect(&work_, &BackgroundWork::changed, this, &SessionController::changed);
    connect(&work_, &BackgroundWork::failed, this, &SessionController::failed);
    connect(&file_, &SessionFile::poseStored, &live_session_, &LiveSession::setStored);
    connect(&file_, &SessionFile::keptInMemoryOnly, &live_session_, [this] { live_session_.keepIn(KeptIn::Memory); });
    connect(&file_, &SessionFile::keptInFile, &live_session_, [this] { live_session_.keepIn(KeptIn::File); });
    connect(&live_session_, &LiveSession::ended, &live_mode_, [this] { live_mode_.setOn(false); });
    connect(&live_session_.source(), &LiveSource::previewChanged, &live_mode_, &LiveMode::solve);
    connect(&live_mode_, &LiveMode::toggled, this, &SessionController::changed);
  }

  void closeCurrent() {
    worker_->cancel();
    live_session_.forget();
    live_mode_.cancel();
    file_.close();
    // The stack's commands refer to the session, so they go first; while there is no session nothing is submitted.
    const std::unique_ptr<Session> old = std::move(session_);
    undo_stack_.clear();
    reconstruction_.reset();
    first_revision_ = submitted_revision_ + 1;
    shown_revision_ = submitted_revision_;
    needs_solving_ = robot_is_newer_ = was_cancelled_ = false;
    setFirstPlacements(nullptr);
  }

  void submit() {
    auto snapshot = std::make_shared<SessionSnapshot>(*session_->snapshot());
    // Sessions count their own revisions from 1; results must be told apart across sessions too.
    snapshot->revision = ++submitted_revision_;
    robot_is_newer_ = was_cancelled_ = false;
    worker_->submit(std::move(snapshot), options_);
    live_session_.noteChange();
    emit changed();
  }

  /// An edit that needs no solving: the session's robot, its joint angles or the places of patches on it.
  void noteRobot() {
    if (reconstruction_) reconstruction_ = withPlacements(*reconstruction_, *session_);
    robot_is_newer_ = isSolving();
    emit changed();
  }

  void receive(const ReconstructionOutcome& outcome) {
    if (outcome.revision < first_revision_ || outcome.revision <= shown_revision_) return;
    shown_revision_ = outcome.revision;
    if (outcome.reconstruction) {
      first_placements_.reset();
      reconstruction_ = robot_is_newer_ ? withPlacements(*outcome.reconstruction, *session_) : outcome.reconstruction;
      live_session_.noteResult();
      emit reconstructionChanged(reconstruction_);
    } else {
      setFirstPlacements(nullptr);
      emit failed(words(outcome.error));
    }
    emit changed();
  }

  /// On the thread that solves.
  void notePlacements(const std::shared_ptr<const Reconstruction>& placements) {
    QMetaObject::invokeMethod(
        this,
        [this, placements] {
          const bool is_wanted = !reconstruction_ && placements->revision >= first_revision_;
          if (is_wanted && placements->revision > shown_revision_) setFirstPlacements(placements);
        },
        Qt::QueuedConnection);
  }

  void setFirstPlacements(std::shared_ptr<const Reconstruction> placements) {
    if (first_placements_ == placements) return;
    first_placements_ = std::move(placements);
    emit changed();
    emit firstPlacementsChanged();
  }

  [[nodiscard]] std::unique_ptr<ReconstructionWorker> makeWorker(ReconstructionWorker::Solve solve) {
    const auto report = [this](ReconstructionOutcome outcome) {
      QMetaObject::invokeMethod(
          this, [this, outcome = std::move(outcome)] { receive(outcome); }, Qt::QueuedConnection);
    };
    return std::make_unique<ReconstructionWorker>(report, std::move(solve));
  }

  [[nodiscard]] EditedSession edited() {
    return {*session_, [this](const SessionEdit& edit) {
              needs_solving_ |= !isAboutRobot(edit);
              file_.record(edit);
            }};
  }

  [[nodiscard]] std::optional<std::size_t> indexOf(PoseId pose) const {
    const std::vector<SessionPose>& poses = session_->poses();
    const auto found = std::ranges::find_if(poses, [&](const SessionPose& other) { return other.capture->id == pose; });
    if (found == poses.end()) return std::nullopt;
    return static_cast<std::size_t>(found - poses.begin());
  }

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

  /// Skins of so many cells are worth a look before their result is complete; that of smaller ones is there at once.
  static constexpr std::size_t kLargeSkin = 2000;
};

}  // namespace hexoderm
