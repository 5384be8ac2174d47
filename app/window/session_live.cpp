// The part of SessionController about the skin that is connected and the file that the session is kept in.
#include "app/window/session_controller.h"

#include "hexoderm/reconstruction/pose_advisor.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

std::filesystem::path toPath(const QString& path) { return {path.toStdU16String()}; }

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
    emit noticed(tr("The device does not turn there: %1. Ask again for the next best pose.")
                     .arg(QString::fromStdString(outcome.text)));
  });
  connect(&undo_stack_, &QUndoStack::indexChanged, this, [this] {
    if (isLive()) live_.setEarlierPoses(enabledCaptures());
  });
}

void SessionController::connectTo(const ConnectRequest& request) {
  ++asked_count_;
  live_session_ = false;
  connect_request_ = request;
  connect_request_.continue_session = request.continue_session && isKept();
  connect_revision_ = submitted_revision_;
  LiveOptions options;
  options.address = request.address;
  options.automatic = automatic_;
  if (connect_request_.continue_session) {
    options.next_pose = session_->nextPoseId();
    options.earlier_poses = enabledCaptures();
  }
  live_.start(options);
}

void SessionController::disconnectSource() {
  live_session_ = false;
  live_.stop();
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
                      .arg(QString::fromStdString(skin.device), name_));
      return false;
    }
    demo_.reset();
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
  const std::string source = skin.device + ", " + live_.address().toStdString();
  auto session = std::make_unique<Session>(*skin.model, skin.neighbors, SourceDescription{source, "", ""});
  SessionRecorder::Open open = [path = toPath(path), first = *session] { return SessionStore::create(path, first); };
  showSession(std::move(session), nullptr, QFileInfo(path).fileName(), path);
  journal_ = std::make_unique<SessionJournal>(*this, jobs_, path, std::move(open), journalTold());
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
        QLatin1Char(' ') + tr("Nothing came from %1.").arg(QString::fromStdString(listInWords(captured.silent_cells)));
  }
  if (captured.repeats) {
    announcement.text += QLatin1Char(' ') + tr("It repeats pose %1, which is only %2° away.")
                                                .arg(QString::number(captured.repeats->value()),
                                                     QString::number(toDegrees(captured.repeat_angle_rad), 'f', 1));
  }
  announcement.remarkable = captured.repeats || !captured.silent_cells.empty();
  announcements_[pose.id] = announcement;
  undo_stack_.push(new AddPoseCommand(edited(), {captured.pose, false}));
}

void SessionController::announce(PoseId pose) {
  const auto found = announcements_.find(pose);
  if (found == announcements_.end()) return;
  const Announcement announcement = found->second;
  announcements_.erase(found);
  emit captured(announcement.text, announcement.remarkable);
}

std::vector<std::shared_ptr<const PoseCapture>> SessionController::enabledCaptures() const {
  std::vector<std::shared_ptr<const PoseCapture>> captures;
  for (const SessionPose& pose : session_->poses()) {
    if (!pose.disabled) captures.push_back(pose.capture);
  }
  return captures;
}

void SessionController::turnToNextPose() {
  if (!canTurn() || !reconstruction_ || reconstruction_->patches.empty()) return;
  start(tr("Looking for the next pose"),
        [this, seen = reconstruction_, unreachable = unreachable_, ticket = opened_count_,
         model = session_->snapshot()->model]() -> Continuation {
          const PatchReconstruction& patch =
              *std::max_element(seen->patches.begin(), seen->patches.end(),
                                [](const auto& a, const auto& b) { return a.cells.size() < b.cells.size(); });
          std::vector<Eigen::Vector3d> directions_o;
          for (const GravityDirection& gravity : patch.gravity) directions_o.push_back(gravity.g_o);
          const Eigen::Vector3d up = adviseNextPose(*model, directions_o, unreachable).up;
          return [this, ticket, up, origin = patch.origin] {
            if (ticket != opened_count_ || !isLive()) return;
            asked_up_ = up;
            asked_turn_ = live_.send(TurnTo{origin, up});
          };
        },
        {});
}

void SessionController::setAutomatic(bool automatic) {
  automatic_ = automatic;
  live_.setAutomatic(automatic);
  emit changed();
}

EditedSession SessionController::edited() {
  return {*session_, [this](StoreOperation operation) { record(std::move(operation)); }};
}

void SessionController::record(StoreOperation operation) {
  if (changed_meanwhile_) changed_meanwhile_->push_back(operation);
  if (journal_) appendToJournal(std::move(operation));
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
  changed_meanwhile_.emplace();
  startWriting(
      tr("Saving %1").arg(QFileInfo(path).fileName()),
      [this, path, copy = std::make_shared<const Session>(*session_), ticket = opened_count_]() -> Continuation {
        auto store = std::make_shared<SessionStore>(SessionStore::create(toPath(path), *copy));
        return [this, path, ticket, store, copy] {
          if (ticket != opened_count_ || !session_) return;
          was_stuck_ = false;
          journal_ = std::make_unique<SessionJournal>(*this, jobs_, path, std::move(*store), journalTold());
          session_path_ = path;
          name_ = QFileInfo(path).fileName();
          saved_at_ = QTime::currentTime();
          if (const auto operations = std::exchange(changed_meanwhile_, std::nullopt)) {
            for (const StoreOperation& operation : *operations) appendToJournal(operation);
          }
          // Captures that waited for the file before are in this one.
          for (const SessionPose& pose : copy->poses()) announce(pose.capture->id);
          emit sessionSaved(path);
        };
      });
}

}  // namespace hexoderm
