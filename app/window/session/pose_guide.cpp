#include "app/window/session/pose_guide.h"

#include "app/window/session/live_session.h"
#include "widgets/words/words.h"

#include <QMetaObject>

namespace hexoderm {

PoseGuide::PoseGuide(LiveSession& live_session) : live_session_(live_session) {
  connect(&live_session_, &LiveSession::told, this, &PoseGuide::hear);
}

const std::optional<PoseAdvice>& PoseGuide::nextPose() const { return live_session_.course().nextPose(); }
bool PoseGuide::isNextPoseWanted() const { return live_session_.course().isNextPoseWanted(); }
bool PoseGuide::isRobotOn() const { return live_session_.course().isRobotOn(); }

bool PoseGuide::wantsMorePoses() const {
  return live_session_.isLive() && live_session_.source().status().state != SourceState::Ended &&
         live_session_.course().wantsMorePoses();
}

void PoseGuide::hear(const CourseEvent& event) {
  if (const auto* wanted = std::get_if<AdviceWanted>(&event)) {
    advise(wanted->question);
  } else if (std::holds_alternative<AdviceChanged>(event)) {
    emit nextPoseChanged();
  } else if (const auto* refused = std::get_if<TurnRefused>(&event)) {
    const QString why = words(refused->why);
    emit noticed(refused->gave_up
                     ? tr("The device refused to turn %1 times, so it is not asked any more. The last time: %2")
                           .arg(QString::number(refused->times), why)
                     : tr("The device does not turn there: %1. The next best pose is advised instead.").arg(why));
    if (refused->gave_up) emit changed();
  } else if (std::holds_alternative<CourseFinished>(event)) {
    emit changed();
  }
}

void PoseGuide::advise(const AdviceQuestion& question) {
  // The course takes the answer to its newest question alone.
  worker_.submit([this, question](const std::stop_token&) {
    const AdviceAnswer answer = adviseOn(question);
    QMetaObject::invokeMethod(
        this, [this, answer] { live_session_.course().setAdvice(answer); }, Qt::QueuedConnection);
  });
}

void PoseGuide::turnToNextPose() {
  if (live_session_.isLive()) live_session_.course().turnToNextPose();
}

void PoseGuide::turnTo(const Eigen::Vector3d& up_o) {
  if (!live_session_.isLive()) return;
  const bool was_on = isRobotOn();
  live_session_.course().turnTo(up_o);
  if (was_on) emit changed();
}

void PoseGuide::skipPose() { live_session_.course().skipPose(); }

void PoseGuide::setRobot(bool on) { startRobot(on, 0); }
void PoseGuide::letRobotTake(std::size_t poses) { startRobot(true, poses); }

void PoseGuide::startRobot(bool on, std::size_t poses) {
  on = on && live_session_.canTurn();
  if (on) live_session_.setAutomatic(true);
  live_session_.course().setRobot(on, poses);
  emit changed();
}

}  // namespace hexoderm
