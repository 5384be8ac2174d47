// The part of SessionController about the skin that is connected and the file that the session is kept in.
#include "app/window/files/session_paths.h"
#include "app/window/session/session_controller.h"

#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

std::set<CellId> cellsOf(const NeighborList& neighbors) {
  std::set<CellId> cells;
  for (const CellReport& cell : neighbors) cells.insert(cell.id);
  return cells;
}

}  // namespace

void SessionController::connectLive() {
  connect(&live_, &LiveSource::skinDescribed, this, &SessionController::showSkin);
  connect(&live_, &LiveSource::poseCaptured, this, &SessionController::addCapture);
  connect(&live_, &LiveSource::failed, this, &SessionController::failed);
  connect(&live_, &LiveSource::statusChanged, this, &SessionController::changed);
  connect(&live_, &LiveSource::commandAnswered, this, [this](const CommandOutcome& outcome) {
    if (asked_turn_ == 0 || outcome.command != asked_turn_) return;
    asked_turn_ = 0;
    if (outcome.done) return;
    unreachable_.push_back(asked_up_);
    emit noticed(
        tr("The device does not turn there: %1. The next best pose is advised instead.").arg(words(outcome.message)));
    adviseAnew();
  });
  connect(&live_, &LiveSource::previewChanged, this, &SessionController::solveMoment);
  connect(&undo_stack_, &QUndoStack::indexChanged, this, [this] {
    if (recapturing_ && !indexOf(*recapturing_)) recapturing_.reset();
    if (isLive()) live_.setEarlierPoses(enabledCaptures());
  });
}

void SessionController::connectTo(const ConnectRequest& request) {
  ++asked_count_;
  forgetSource();
  connect_request_ = request;
  connect_request_.continue_session = request.continue_session && isKept();
  connect_revision_ = submitted_revision_;
  LiveOptions options;
  options.address = request.address;
  options.recorder = recorder_options_;
  options.recorder.automatic = automatic_;
  if (connect_request_.continue_session) {
    options.next_pose = session_->nextPoseId();
    options.earlier_poses = enabledCaptures();
  }
  live_.start(options);
}

void SessionController::disconnectSource() {
  forgetSource();
  live_.stop();
}

void SessionController::forgetSource() {
  live_session_ = false;
  robot_ = false;
  recapturing_.reset();
  lit_.reset();
  asked_turn_ = 0;
  unreachable_.clear();
  setLiveMode(false);
  adviseAnew();
}

void SessionController::showSkin(const SkinDescription& skin) {
  if (live_session_) {
    if (skin.neighbors == session_->neighbors()) return;
    replaceSkin(skin);
    emit noticed(tr("The device says that its cells or links have changed; the poses stay."));
  } else if (!beginLiveSession(skin)) {
    disconnectSource();
  }
}

bool SessionController::beginLiveSession(const SkinDescription& skin) {
  if (connect_request_.continue_session) {
    if (!isKept()) return false;
    if (cellsOf(skin.neighbors) != cellsOf(session_->neighbors())) {
      emit failed(tr("%1 has other cells than the session %2, so nothing was added. Connect it with a session of its "
                     "own.")
                      .arg(words(skin.device), name_));
      return false;
    }
    demo_ = false;
    live_session_ = true;
    if (skin.neighbors != session_->neighbors()) {
      replaceSkin(skin);
      emit noticed(tr("The links are others than those of the session; the poses stay."));
    }
    emit changed();
    return true;
  }
  if (hasUnsavedChanges() && submitted_revision_ != connect_revision_) {
    emit failed(
        tr("The session that is open was changed while the skin was being connected, so it stays. Save it, and "
           "connect again."));
    return false;
  }
  const QString path = connect_request_.path;
  const Message source = inRow({skin.device, Message::verbatim(live_.address().toStdString())}, ", ");
  auto session = std::make_unique<Session>(*skin.model, skin.neighbors, SourceDescription{source, "", ""});
  if (skin.truth) session->setTruth(*skin.truth);
  if (path.isEmpty()) {
    showSession(std::move(session), connect_request_.demo ? tr("Demo skin (simulated)") : live_.address(), {});
    beginScratch(connect_request_.demo ? QStringLiteral("demo") : QStringLiteral("live"));
  } else {
    SessionRecorder::Open open = [path = toPath(path), first = *session] { return SessionStore::create(path, first); };
    showSession(std::move(session), QFileInfo(path).fileName(), path);
    journal_ = std::make_unique<SessionJournal>(*this, jobs_, path, std::move(open), journalTold());
  }
  demo_ = connect_request_.demo;
  live_session_ = true;
  emit changed();
  return true;
}

void SessionController::replaceSkin(const SkinDescription& skin) {
  session_->setSkin(*skin.model, skin.neighbors);
  record(SetSkin{skin.model, skin.neighbors});
  submit();
}

void SessionController::addCapture(const CapturedPose& captured) {
  if (!isLive()) return;
  const PoseCapture& pose = *captured.pose;
  Announcement announcement;
  const QString cells = pose.samples.size() == 1 ? tr("1 cell") : tr("%1 cells").arg(pose.samples.size());
  announcement.text = tr("Pose %1 captured: %2.").arg(QString::number(pose.id.value()), cells);
  if (!captured.silent_cells.empty()) {
    announcement.text +=
        QLatin1Char(' ') + tr("Nothing came from %1.").arg(words(Message("{}", {captured.silent_cells})));
  }
  if (captured.repeats) {
    announcement.text += QLatin1Char(' ') + tr("It repeats pose %1, which is only %2° away.")
                                                .arg(QString::number(captured.repeats->value()),
                                                     figureInWords(toDegrees(captured.repeat_angle_rad), 1));
  }
  announcement.remarkable = captured.repeats || !captured.silent_cells.empty();
  announcements_[pose.id] = announcement;
  const std::shared_ptr<const PoseCapture> labelled = withLabel(captured.pose);
  if (const auto replaced = recapturing_ ? indexOf(*recapturing_) : std::nullopt) {
    // One step for undo: the pose that was there, back in its place.
    undo_stack_.beginMacro(tr("recapture pose %1").arg(recapturing_->value()));
    undo_stack_.push(new RemovePoseCommand(edited(), *replaced));
    undo_stack_.push(new AddPoseCommand(edited(), {labelled, false}, *replaced));
    recapturing_.reset();
    undo_stack_.endMacro();
  } else {
    undo_stack_.push(new AddPoseCommand(edited(), {labelled, false}));
  }
  // Where no file keeps the session, there is none to wait for.
  if (!journal_) announce(pose.id);
}

void SessionController::announce(PoseId pose) {
  const auto found = announcements_.find(pose);
  if (found == announcements_.end()) return;
  const Announcement announcement = found->second;
  announcements_.erase(found);
  emit captured(announcement.text, announcement.remarkable);
}

std::shared_ptr<const PoseCapture> SessionController::withLabel(std::shared_ptr<const PoseCapture> pose) const {
  if (!pose->label.empty() || !reconstruction_) return pose;
  auto labelled = std::make_shared<PoseCapture>(*pose);
  labelled->label = poseLabel(*reconstruction_, *pose);
  return labelled;
}

std::optional<std::size_t> SessionController::indexOf(PoseId pose) const {
  if (!session_) return std::nullopt;
  const std::vector<SessionPose>& poses = session_->poses();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (poses[k].capture->id == pose) return k;
  }
  return std::nullopt;
}

void SessionController::announceAll() {
  while (!announcements_.empty()) announce(announcements_.begin()->first);
}

std::vector<std::shared_ptr<const PoseCapture>> SessionController::enabledCaptures() const {
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  for (const SessionPose& pose : session_->poses()) {
    if (!pose.disabled) captures.push_back(pose.capture);
  }
  return captures;
}

EditedSession SessionController::edited() {
  return {*session_, [this](StoreOperation operation) { record(std::move(operation)); }};
}

void SessionController::record(StoreOperation operation) {
  std::erase_if(saves_under_way_, [](const auto& save) { return save.expired(); });
  for (const auto& save : saves_under_way_) {
    if (const auto changed_meanwhile = save.lock()) changed_meanwhile->push_back(operation);
  }
  if (journal_) {
    appendToJournal(std::move(operation));
  } else if (!scratch_fails_) {
    // The first change of a session that came from a file; the change is in the session already.
    beginScratch(suggestedScratchName());
  }
}

void SessionController::beginScratch(const QString& name) {
  scratch_path_ = newScratchPath(name);
  SessionRecorder::Open open = [path = toPath(scratch_path_), first = *session_] {
    return SessionStore::create(path, first);
  };
  journal_ = std::make_unique<SessionJournal>(*this, jobs_, scratch_path_, std::move(open), journalTold());
}

QString SessionController::suggestedScratchName() const {
  QString name = demo_ ? QStringLiteral("demo") : QFileInfo(name_).fileName().section(QLatin1Char('.'), 0, 0);
  name.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9_-]+")), QStringLiteral("_"));
  return name.isEmpty() ? QStringLiteral("session") : name.left(40);
}

void SessionController::dropJournal() {
  journal_.reset();
  if (scratch_path_.isEmpty()) return;
  // After the journal has closed it, which happens on the same thread.
  jobs_.addEssential([path = toPath(std::exchange(scratch_path_, {}))] { removeSessionStore(path); });
}

void SessionController::appendToJournal(StoreOperation operation) {
  std::function<void()> written;
  if (const auto* add = std::get_if<AddPose>(&operation)) {
    written = [this, id = add->pose.capture->id] { announce(id); };
  }
  journal_->append(std::move(operation), std::move(written));
  emit changed();
}

SessionJournal::Told SessionController::journalTold() {
  return [this](const QString& why) {
    if (!scratch_path_.isEmpty()) {
      if (why.isEmpty()) return;
      // The session can go on without; what the operator was to be told when it was written is told now.
      scratch_fails_ = true;
      dropJournal();
      announceAll();
      emit noticed(tr("Until it is saved, this session is kept in memory only. %1").arg(why));
      emit changed();
      return;
    }
    if (why.isEmpty()) {
      saved_at_ = QTime::currentTime();
      if (!journal_->isWaiting() && std::exchange(was_stuck_, false)) emit sessionSaved(journal_->path());
    } else if (journal_->isWaiting()) {
      was_stuck_ = true;
      emit journalStuck(why);
    } else {
      emit failed(why);
    }
    emit changed();
  };
}

void SessionController::retryWriting() {
  if (!journal_) return;
  if (isJournalStuck()) {
    journal_->retry();
  } else {
    emit sessionSaved(journal_->path());
  }
}

void SessionController::saveAsJournal(const QString& path) {
  auto changed_meanwhile = std::make_shared<std::vector<StoreOperation>>();
  saves_under_way_.push_back(changed_meanwhile);
  startWriting(tr("Saving %1").arg(QFileInfo(path).fileName()),
               [this, path, changed_meanwhile = std::move(changed_meanwhile),
                copy = std::make_shared<const Session>(*session_), ticket = opened_count_]() -> Continuation {
                 auto store = std::make_shared<SessionStore>(SessionStore::create(toPath(path), *copy));
                 return [this, path, ticket, store, copy, changed_meanwhile] {
                   if (ticket != opened_count_ || !session_) return;
                   was_stuck_ = false;
                   dropJournal();
                   journal_ = std::make_unique<SessionJournal>(*this, jobs_, path, std::move(*store), journalTold());
                   session_path_ = path;
                   name_ = QFileInfo(path).fileName();
                   saved_at_ = QTime::currentTime();
                   for (const StoreOperation& operation : std::exchange(*changed_meanwhile, {}))
                     appendToJournal(operation);
                   // Captures that waited for the file before are in this one.
                   for (const SessionPose& pose : copy->poses()) announce(pose.capture->id);
                   emit sessionSaved(path);
                 };
               });
}

}  // namespace hexoderm
