#pragma once

#include "app/window/files/session_paths.h"
#include "hexoderm/kinematics/joint_angles_csv.h"
#include "hexoderm/kinematics/joint_check.h"
#include "hexoderm/kinematics/robot_model.h"
#include "hexoderm/robot/links/links.h"
#include "hexoderm/robot/place/place.h"
#include "hexoderm/session/session_edit.h"
#include "hexoderm/session/session_joint_angles.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/latest_worker.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_scene.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <QObject>
#include <array>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <utility>
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
  explicit Placing(QObject* parent = nullptr) : QObject(parent), worker_(kKinds) {}

  void readRobot(const RobotDescription& description) {
    request(PlaceWork::Robot, [this, description](const std::stop_token& stop) -> Announcement {
      return [this, robot = loadRobot(description, stop)] { emit robotRead(robot); };
    });
  }

  /// Of the poses of the session as it is now.
  void readJoints(const QString& path, std::shared_ptr<const LoadedRobot> robot, const Session& session) {
    // The copy shares the captures.
    request(PlaceWork::Joints,
            [this, path, robot = std::move(robot),
             copy = std::make_shared<const Session>(session)](const std::stop_token&) -> Announcement {
              const JointAnglesTable table = readJointAnglesCsv(toPath(path), robot->model);
              JointAnglesForSession read = jointAnglesFor(*copy, table);
              LoadedJoints joints{std::move(read.edits), std::move(read.without_angles), QFileInfo(path).fileName()};
              return [this, joints] { emit jointsRead(joints); };
            });
  }

  void findLinks(std::shared_ptr<const Reconstruction> reconstruction, std::shared_ptr<const LoadedRobot> robot,
                 std::map<PoseId, JointAngles> angles, LinksOptions options) {
    request(PlaceWork::Links,
            [this, reconstruction = std::move(reconstruction), robot = std::move(robot), angles = std::move(angles),
             options = std::move(options)](const std::stop_token&) -> Announcement {
              auto links = std::make_shared<const LinksResult>(
                  hexoderm::findLinks(*reconstruction, robot->model, angles, options));
              return [this, links] { emit linksFound(links); };
            });
  }

  void findPlaces(PlaceTask task) {
    request(PlaceWork::Places, [this, task = std::move(task)](const std::stop_token&) -> Announcement {
      auto places = std::make_shared<const PlaceResult>(placePatches(task));
      return [this, places] { emit placesFound(places); };
    });
  }

  void cancel(PlaceWork work) {
    const std::size_t slot = slotOf(work);
    worker_.cancel(slot);
    ++newest_.at(slot);
    setRunning(work, false);
  }

  [[nodiscard]] bool isRunning(PlaceWork work) const { return running_.at(slotOf(work)); }

 signals:
  void runningChanged(hexoderm::PlaceWork work, bool running);
  void robotRead(std::shared_ptr<const hexoderm::LoadedRobot> robot);
  void jointsRead(const hexoderm::LoadedJoints& joints);
  void linksFound(std::shared_ptr<const hexoderm::LinksResult> links);
  void placesFound(std::shared_ptr<const hexoderm::PlaceResult> places);
  void failed(hexoderm::PlaceWork work, const QString& message);

 private:
  /// A mesh that can't be read is said, and leaves its link without a body: the other links are of use all the same.
  static TriangleMesh bodyOrFinding(const RobotModel& robot, std::size_t link, std::vector<VerifySentence>& findings) {
    if (!robot.hasBody(link)) return {};
    try {
      TriangleMesh body = robot.bodyOf(link);
      if (const auto suspected = robot.suspectedUnit(link, body)) {
        findings.push_back({Tone::Caution, words(suspected->message)});
      }
      return body;
    } catch (const Error& error) {
      findings.push_back({Tone::Bad, words(error)});
      return {};
    }
  }

  static std::shared_ptr<const LoadedRobot> loadRobot(const RobotDescription& description,
                                                      const std::stop_token& stop) {
    PackageFolders folders;
    for (const auto& [name, folder] : description.packages) folders[name] = folder;
    RobotModel model = RobotModel::read(description.urdf, std::move(folders));
    std::vector<VerifySentence> findings;
    for (const Message& note : model.notes()) findings.push_back({Tone::Caution, words(note)});
    if (!description.sha256.empty() && description.sha256 != model.sha256()) {
      findings.push_back(
          {Tone::Caution, Placing::tr("The file has changed since the robot was chosen: look whether the places still "
                                      "hold.")});
    }
    auto bodies = std::make_shared<LinkBodies>();
    for (std::size_t link = 0; link < model.links().size() && !stop.stop_requested(); ++link) {
      bodies->push_back(bodyOrFinding(model, link, findings));
    }
    bodies->resize(model.links().size());
    RobotDescription read = description;
    read.sha256 = model.sha256();
    return std::make_shared<const LoadedRobot>(
        LoadedRobot{std::move(read), std::move(model), std::move(bodies), std::move(findings)});
  }

  using Announcement = std::function<void()>;
  using Work = std::function<Announcement(const std::stop_token&)>;
  static std::size_t slotOf(PlaceWork work) { return static_cast<std::size_t>(work); }
  void request(PlaceWork kind, Work work) {
    const std::size_t slot = slotOf(kind);
    worker_.cancel(slot);
    const std::uint64_t number = ++newest_.at(slot);
    worker_.submit(
        [this, kind, number, work = std::move(work)](const std::stop_token& stop) {
          Announcement announce;
          try {
            announce = work(stop);
          } catch (const std::exception& error) {
            announce = [this, kind, message = words(error)] { emit failed(kind, message); };
          }
          QMetaObject::invokeMethod(
              this, [this, kind, number, announce = std::move(announce)] { finish(kind, number, announce); },
              Qt::QueuedConnection);
        },
        slot);
    setRunning(kind, true);
  }

  void finish(PlaceWork kind, std::uint64_t number, const Announcement& announce) {
    if (newest_.at(slotOf(kind)) != number) return;
    setRunning(kind, false);
    announce();
  }

  void setRunning(PlaceWork kind, bool running) {
    bool& told = running_.at(slotOf(kind));
    if (std::exchange(told, running) != running) emit runningChanged(kind, running);
  }

  static constexpr std::size_t kKinds = 4;
  std::array<std::uint64_t, kKinds> newest_{};  ///< request per kind; results of older ones are dropped
  std::array<bool, kKinds> running_{};          ///< as runningChanged() last said
  LatestWorker worker_;  // a mailbox per kind; last: it has ended before anything that it uses is destroyed
};

}  // namespace hexoderm
