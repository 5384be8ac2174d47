// The part of SessionController about what the operator does next: the advised pose, a device that turns itself, a pose
// that is taken again, and the skin as it is at this moment.
#include "app/window/session/session_controller.h"
#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/words/words.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

namespace hexoderm {
std::size_t SessionController::enabledPoses() const {
  if (!session_) return 0;
  return static_cast<std::size_t>(std::count_if(session_->poses().begin(), session_->poses().end(),
                                                [](const SessionPose& pose) { return !pose.disabled; }));
}

bool SessionController::wantsMorePoses() const {
  if (!isLive() || live_.status().state == SourceState::Ended) return false;
  return !reconstruction_ || !enoughPoses(*reconstruction_);
}

void SessionController::adviseAnew() {
  const std::uint64_t ticket = ++advice_asked_;
  if (!isLive() || !reconstruction_ || !largestPatch(*reconstruction_)) {
    if (std::exchange(next_pose_, std::nullopt)) emit nextPoseChanged();
    return;
  }
  advice_jobs_.add([this, ticket, seen = reconstruction_, unreachable = unreachable_] {
    std::vector<Eigen::Vector3d> directions_o;
    for (const GravityDirection& gravity : largestPatch(*seen)->gravity) directions_o.push_back(gravity.g_o);
    const PoseAdvice advice = adviseNextPose(*seen->model, directions_o, unreachable);
    const std::optional<NextPose> next = describeNextPose(advice, *seen);
    const bool wanted = next && next->isWanted();
    QMetaObject::invokeMethod(
        this,
        [this, ticket, advice, wanted] {
          if (ticket != advice_asked_) return;
          next_pose_ = advice;
          next_pose_wanted_ = wanted;
          emit nextPoseChanged();
          letRobotTurn();
        },
        Qt::QueuedConnection);
  });
}

void SessionController::sendTurn(const Eigen::Vector3d& up_o) {
  asked_up_ = up_o;
  asked_turn_ = live_.send(TurnTo{largestPatch(*reconstruction_)->origin, up_o});
}

void SessionController::turnToNextPose() {
  if (canTurn() && next_pose_) sendTurn(next_pose_->up);
}

void SessionController::turnTo(const Eigen::Vector3d& up_o) {
  if (!canTurn() || !reconstruction_ || !largestPatch(*reconstruction_)) return;
  asked_turn_ = 0;
  live_.send(TurnTo{largestPatch(*reconstruction_)->origin, up_o.normalized()});
  if (std::exchange(robot_, false)) emit changed();
}

void SessionController::skipPose() {
  if (!next_pose_) return;
  unreachable_.push_back(next_pose_->up);
  adviseAnew();
}

void SessionController::setRobot(bool on) {
  robot_ = on && canTurn();
  if (robot_) {
    setAutomatic(true);
    letRobotTurn();
  }
  emit changed();
}

void SessionController::letRobotTurn() {
  // The first pose is taken where the part lies.
  if (!robot_ || !canTurn() || !next_pose_ || !isCurrent() || session_->poses().empty()) return;
  if (!wantsMorePoses() || enabledPoses() >= kMostPosesByItself) {
    robot_ = false;
    emit changed();
    return;
  }
  sendTurn(next_pose_->up);
}

void SessionController::setAutomatic(bool automatic) {
  automatic_ = automatic;
  live_.setAutomatic(automatic);
  emit changed();
}

void SessionController::recapturePose(std::size_t index) {
  if (!isLive() || index >= session_->poses().size()) return;
  const PoseId pose = session_->poses()[index].capture->id;
  recapturing_ = pose;
  emit changed();
  if (!canTurn() || !reconstruction_) return;
  const PatchReconstruction* patch = largestPatch(*reconstruction_);
  if (!patch) return;
  const auto gravity = std::find_if(patch->gravity.begin(), patch->gravity.end(),
                                    [&](const GravityDirection& direction) { return direction.pose == pose; });
  if (gravity != patch->gravity.end()) sendTurn(gravity->g_o);
}

void SessionController::cancelRecapture() {
  if (!std::exchange(recapturing_, std::nullopt)) return;
  emit changed();
}

void SessionController::lightCell(std::optional<CellId> cell) {
  if (!isLive() || !live_.skin() || !live_.skin()->can_light_cells || cell == lit_) return;
  if (lit_) live_.send(SetLed{*lit_, 0, 0, 0});
  if (cell) live_.send(SetLed{*cell, 255, 255, 255});
  lit_ = cell;
  emit changed();
}

void SessionController::setLiveMode(bool on) {
  if (live_mode_ == (on && isLive())) return;
  live_mode_ = on && isLive();
  moment_fails_ = false;
  emit liveModeChanged(live_mode_);
  emit changed();
}

void SessionController::solveMoment() {
  if (!live_mode_ || !session_ || live_.preview().means.empty()) return;
  auto moment = std::make_shared<SessionSnapshot>(*session_->snapshot());
  auto capture = std::make_shared<PoseCapture>();
  capture->id = PoseId(1);
  capture->label = tr("now").toStdString();
  for (const CellSample& mean : live_.preview().means) {
    GravitySample sample;
    sample.cell = mean.cell;
    sample.mean_g = mean.acceleration_g;
    capture->samples.push_back(sample);
  }
  moment->poses = {{std::move(capture), false, {}}};
  SolverOptions options = options_;
  options.solver = Solver::Tree;  // the paper's self-refreshing test; quick enough for every preview
  moment_worker_.submit(std::move(moment), options);
}

void SessionController::receiveMoment(const ReconstructionOutcome& outcome) {
  if (!live_mode_) return;
  if (outcome.reconstruction) {
    moment_fails_ = false;
    emit momentSolved(outcome.reconstruction);
  } else if (!std::exchange(moment_fails_, true)) {
    emit noticed(tr("What is shown stands still: the skin as it is now can't be solved. %1").arg(words(outcome.error)));
  }
}

}  // namespace hexoderm
