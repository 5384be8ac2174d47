#pragma once

#include "hexoderm/course/capture_course.h"
#include "hexoderm/util/latest_worker.h"

#include <QObject>
#include <optional>

namespace hexoderm {

class LiveSession;

/// The advice for the next pose, which a person or the robot follows.
class PoseGuide : public QObject {
  Q_OBJECT

 public:
  /// `live_session` outlives this object.
  explicit PoseGuide(LiveSession& live_session);

  /// The pose that would help most, in the frame of the largest patch; none before the first result, or where no skin
  /// is connected.
  [[nodiscard]] const std::optional<PoseAdvice>& nextPose() const;
  /// Following that advice would help: not for the first pose, which may be any, nor where there are enough.
  [[nodiscard]] bool isNextPoseWanted() const;
  /// The connected skin should be held for another pose, as the result's assessment says.
  [[nodiscard]] bool wantsMorePoses() const;
  /// The device turns itself from pose to pose until there are enough.
  [[nodiscard]] bool isRobotOn() const;

 public slots:
  /// Asks the device to turn itself to where the next pose helps most.
  void turnToNextPose();
  /// Asks the device to turn until `up_o` (frame of the largest patch) points up.
  void turnTo(const Eigen::Vector3d& up_o);
  /// The part can't be brought there: advises the next best pose.
  void skipPose();
  void setRobot(bool on);
  /// The same until the session has so many poses, whether they are wanted or not.
  void letRobotTake(std::size_t poses);

 signals:
  void changed();
  void noticed(const QString& text);
  void nextPoseChanged();

 private:
  void startRobot(bool on, std::size_t poses);
  void hear(const CourseEvent& event);
  void advise(const AdviceQuestion& question);

  LiveSession& live_session_;
  LatestWorker worker_;  // last: its thread has ended before what it reports to goes
};

}  // namespace hexoderm
