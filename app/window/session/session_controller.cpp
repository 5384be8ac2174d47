#include "app/window/session/session_controller.h"

#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

/// Skins of so many cells are worth a look before their result is complete; that of smaller ones is there at once.
constexpr std::size_t kLargeSkin = 2000;

}  // namespace

SessionController::SessionController(QObject* parent)
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

std::unique_ptr<ReconstructionWorker> SessionController::makeWorker(ReconstructionWorker::Solve solve) {
  const auto report = [this](ReconstructionOutcome outcome) {
    QMetaObject::invokeMethod(
        this, [this, outcome = std::move(outcome)] { receive(outcome); }, Qt::QueuedConnection);
  };
  return std::make_unique<ReconstructionWorker>(report, std::move(solve));
}

void SessionController::setSolve(ReconstructionWorker::Solve solve) { worker_ = makeWorker(std::move(solve)); }

SessionController::~SessionController() {
  // The stack says so when it is cleared, and by then the worker is gone.
  disconnect(&undo_stack_, nullptr, this, nullptr);
}

void SessionController::connectParts() {
  connect(&work_, &BackgroundWork::changed, this, &SessionController::changed);
  connect(&work_, &BackgroundWork::failed, this, &SessionController::failed);
  connect(&file_, &SessionFile::changed, this, &SessionController::changed);
  connect(&file_, &SessionFile::failed, this, &SessionController::failed);
  connect(&file_, &SessionFile::noticed, this, &SessionController::noticed);
  connect(&file_, &SessionFile::poseStored, &live_session_, &LiveSession::setStored);
  connect(&file_, &SessionFile::keptInMemoryOnly, &live_session_, [this] { live_session_.keepIn(KeptIn::Memory); });
  connect(&file_, &SessionFile::keptInFile, &live_session_, [this] { live_session_.keepIn(KeptIn::File); });
  connect(&live_session_, &LiveSession::changed, this, &SessionController::changed);
  connect(&live_session_, &LiveSession::failed, this, &SessionController::failed);
  connect(&live_session_, &LiveSession::noticed, this, &SessionController::noticed);
  connect(&live_session_, &LiveSession::ended, &live_mode_, [this] { live_mode_.setOn(false); });
  connect(&live_session_.source(), &LiveSource::previewChanged, &live_mode_, &LiveMode::solve);
  connect(&live_mode_, &LiveMode::toggled, this, &SessionController::changed);
  connect(&live_mode_, &LiveMode::noticed, this, &SessionController::noticed);
}

std::size_t SessionController::enabledPoses() const {
  if (!session_) return 0;
  return static_cast<std::size_t>(std::ranges::count(session_->poses(), false, &SessionPose::disabled));
}

std::optional<std::size_t> SessionController::indexOf(PoseId pose) const {
  const std::vector<SessionPose>& poses = session_->poses();
  const auto found = std::ranges::find_if(poses, [&](const SessionPose& other) { return other.capture->id == pose; });
  if (found == poses.end()) return std::nullopt;
  return static_cast<std::size_t>(found - poses.begin());
}

std::optional<std::size_t> SessionController::sessionIndexOfPoseRow(int row) const {
  if (!session_ || !reconstruction_ || row < 0 || static_cast<std::size_t>(row) >= reconstruction_->poses.size()) {
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(row);
  const PoseId id = reconstruction_->poses[index].pose;
  const std::vector<SessionPose>& poses = session_->poses();
  // Several poses of a file may carry one number; as long as nothing changed, the row says which is meant.
  return index < poses.size() && poses[index].capture->id == id ? std::optional(index) : indexOf(id);
}

std::optional<std::size_t> SessionController::indexToRetake() const {
  if (!session_ || !reconstruction_ || reconstruction_->assessment.retake.empty()) return std::nullopt;
  return indexOf(reconstruction_->assessment.retake.front());
}

EditedSession SessionController::edited() {
  return {*session_, [this](const SessionEdit& edit) {
            needs_solving_ |= !isAboutRobot(edit);
            file_.record(edit);
          }};
}

void SessionController::perform(const std::vector<SessionEdit>& edits, const QString& text) {
  const bool is_macro = edits.size() > 1;
  if (is_macro) undo_stack_.beginMacro(text);
  for (const SessionEdit& edit : edits) {
    auto* command = new EditCommand(edited(), edit);
    if (!text.isEmpty()) command->setText(text);
    undo_stack_.push(command);
  }
  if (is_macro) undo_stack_.endMacro();
}

void SessionController::performForGood(const SessionEdit& edit) {
  apply(edit, *session_);
  file_.record(edit);
  submit();
}

void SessionController::setPoseDisabled(std::size_t index, bool disabled) {
  if (!session_ || index >= session_->poses().size() || session_->poses()[index].disabled == disabled) return;
  perform({SetPoseDisabled{index, disabled, {}}});
}

void SessionController::removePose(std::size_t index) {
  if (!session_ || index >= session_->poses().size()) return;
  perform({RemovePose{index}});
}

void SessionController::setLinkMuted(LinkEnd a, LinkEnd b, bool muted) {
  if (!session_ || a == b || (session_->findMutedLink(a, b) != nullptr) == muted) return;
  perform({SetLinkMuted{a, b, muted, {}}});
}

void SessionController::closeCurrent() {
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

void SessionController::showSession(std::unique_ptr<Session> session, const QString& name, const QString& path) {
  closeCurrent();
  session_ = std::move(session);
  file_.nameSession(name, path);
  emit reconstructionChanged(nullptr);
  submit();
  emit opened(name);
}

void SessionController::showCalibration(std::shared_ptr<const Reconstruction> calibration, const QString& path) {
  closeCurrent();
  file_.nameCalibration(path);
  reconstruction_ = std::move(calibration);
  emit reconstructionChanged(reconstruction_);
  emit opened(file_.name());
}

void SessionController::submit() {
  auto snapshot = std::make_shared<SessionSnapshot>(*session_->snapshot());
  // Sessions count their own revisions from 1; results must be told apart across sessions too.
  snapshot->revision = ++submitted_revision_;
  robot_is_newer_ = was_cancelled_ = false;
  worker_->submit(std::move(snapshot), options_);
  live_session_.noteChange();
  emit changed();
}

void SessionController::noteRobot() {
  if (reconstruction_) reconstruction_ = withPlacements(*reconstruction_, *session_);
  robot_is_newer_ = isSolving();
  emit changed();
}

void SessionController::setSolverOptions(const SolverOptions& options) {
  options_ = options;
  if (session_) submit();
}

void SessionController::cancelSolving() {
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

void SessionController::solveAgain() {
  if (session_ && was_cancelled_) submit();
}

void SessionController::receive(const ReconstructionOutcome& outcome) {
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

void SessionController::notePlacements(const std::shared_ptr<const Reconstruction>& placements) {
  QMetaObject::invokeMethod(
      this,
      [this, placements] {
        const bool is_wanted = !reconstruction_ && placements->revision >= first_revision_;
        if (is_wanted && placements->revision > shown_revision_) setFirstPlacements(placements);
      },
      Qt::QueuedConnection);
}

void SessionController::setFirstPlacements(std::shared_ptr<const Reconstruction> placements) {
  if (first_placements_ == placements) return;
  first_placements_ = std::move(placements);
  emit changed();
  emit firstPlacementsChanged();
}

}  // namespace hexoderm
