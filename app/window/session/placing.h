#pragma once

#include "hexoderm/kinematics/joint_angles_csv.h"
#include "hexoderm/kinematics/robot_model.h"
#include "hexoderm/robot/links/links.h"
#include "hexoderm/robot/place/place.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/util/latest_worker.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_scene.h"

#include <QObject>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <vector>

namespace hexoderm {

/// A robot as it was read: its URDF, and the bodies of its links.
struct LoadedRobot {
  RobotDescription description;  ///< as it was given, with the hash of what was read
  RobotModel model;
  std::shared_ptr<const LinkBodies> bodies;  ///< of every link; empty where there is none or it can't be read
  std::vector<VerifySentence> findings;      ///< what was taken otherwise, meshes that can't be read, doubtful sizes
};

/// Joint angles as they were read for a session.
struct LoadedJoints {
  std::vector<SetJointAngles> edits;
  std::vector<PoseId> without_angles;
  QString file;
};

/// Does the work of the step "Place on the robot" on a thread of its own. The newest request of a kind wins: one that
/// waits is dropped, and the result of one that runs is not shown. An exception becomes a message.
class Placing : public QObject {
  Q_OBJECT

 public:
  /// The destructor waits for the running work to end.
  explicit Placing(QObject* parent = nullptr);

  void readRobot(const RobotDescription& description);
  /// Of the poses of the session as it is now.
  void readJoints(const QString& path, std::shared_ptr<const LoadedRobot> robot, const Session& session);
  void findLinks(std::shared_ptr<const Reconstruction> reconstruction, std::shared_ptr<const LoadedRobot> robot,
                 std::map<PoseId, JointAngles> angles, LinksOptions options);
  void findPlaces(PlaceTask task);
  void cancel(PlaceWork work);
  [[nodiscard]] bool isRunning(PlaceWork work) const { return running_.at(slotOf(work)); }

 signals:
  void runningChanged(hexoderm::PlaceWork work, bool running);
  void robotRead(std::shared_ptr<const hexoderm::LoadedRobot> robot);
  void jointsRead(const hexoderm::LoadedJoints& joints);
  void linksFound(std::shared_ptr<const hexoderm::LinksResult> links);
  void placesFound(std::shared_ptr<const hexoderm::PlaceResult> places);
  void failed(hexoderm::PlaceWork work, const QString& message);

 private:
  using Announcement = std::function<void()>;
  using Work = std::function<Announcement(const std::stop_token&)>;
  static std::size_t slotOf(PlaceWork work) { return static_cast<std::size_t>(work); }
  void request(PlaceWork kind, Work work);
  void finish(PlaceWork kind, std::uint64_t number, const Announcement& announce);
  void setRunning(PlaceWork kind, bool running);

  static constexpr std::size_t kKinds = 4;
  std::array<std::uint64_t, kKinds> newest_{};  ///< request per kind; results of older ones are dropped
  std::array<bool, kKinds> running_{};          ///< as runningChanged() last said
  LatestWorker worker_;  // a mailbox per kind; last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
