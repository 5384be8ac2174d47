#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/toolkit/newest_requests.h"
#include "hexoderm/base/error.h"
#include "hexoderm/io/session_joint_angles.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/robots/joint_angles_csv.h"
#include "hexoderm/robots/joint_check.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/session/session_edit.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_scene.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QObject>
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
  QString file;
};

/// Does the work of the step "Place on the robot" on a thread of its own. The newest request of a kind wins, see
/// NewestRequests. An exception becomes a message.
class Placing : public QObject {
  Q_OBJECT

 public:
  /// The destructor waits for the running work to end.
  explicit Placing(QObject* parent = nullptr) : QObject(parent) {}

  void readRobot(const RobotDescription& description) {
    requests_.request(PlaceWork::Robot, [this, description](const std::stop_token& stop) -> Announcement {
      return [this, robot = loadRobot(description, stop)] { emit robotRead(robot); };
    });
  }

  /// Of the poses of the session as it is now.
  void readJoints(const QString& path, std::shared_ptr<const LoadedRobot> robot, const Session& session) {
    // The copy shares the captures.
    requests_.request(PlaceWork::Joints,
                      [this, path, robot = std::move(robot),
                       copy = std::make_shared<const Session>(session)](const std::stop_token&) -> Announcement {
                        const JointAnglesTable table = readJointAnglesCsv(toPath(path), robot->model);
                        const LoadedJoints joints{jointAnglesFor(*copy, table).edits, QFileInfo(path).fileName()};
                        return [this, joints] { emit jointsRead(joints); };
                      });
  }

  void findLinks(std::shared_ptr<const Reconstruction> reconstruction, std::shared_ptr<const LoadedRobot> robot,
                 std::map<PoseId, JointAngles> angles, LinksOptions options) {
    requests_.request(
        PlaceWork::Links,
        [this, reconstruction = std::move(reconstruction), robot = std::move(robot), angles = std::move(angles),
         options = std::move(options)](const std::stop_token&) -> Announcement {
          auto links =
              std::make_shared<const LinksResult>(hexoderm::findLinks(*reconstruction, robot->model, angles, options));
          return [this, links] { emit linksFound(links); };
        });
  }

  void findPlaces(PlaceTask task) {
    requests_.request(PlaceWork::Places, [this, task = std::move(task)](const std::stop_token&) -> Announcement {
      auto places = std::make_shared<const PlaceResult>(placePatches(task));
      return [this, places] { emit placesFound(places); };
    });
  }

  void cancel(PlaceWork work) { requests_.cancel(work); }
  [[nodiscard]] bool isRunning(PlaceWork work) const { return requests_.isRunning(work); }

 signals:
  void runningChanged(hexoderm::PlaceWork work, bool running);
  void robotRead(std::shared_ptr<const hexoderm::LoadedRobot> robot);
  void jointsRead(const hexoderm::LoadedJoints& joints);
  void linksFound(std::shared_ptr<const hexoderm::LinksResult> links);
  void placesFound(std::shared_ptr<const hexoderm::PlaceResult> places);
  void failed(hexoderm::PlaceWork work, const QString& message);

 private:
  using Announcement = NewestRequests<PlaceWork>::Announcement;

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

  NewestRequests<PlaceWork> requests_{*this,
                                      [this](PlaceWork work, bool running) { emit runningChanged(work, running); },
                                      [this](PlaceWork work, const QString& message) { emit failed(work, message); }};
};

}  // namespace hexoderm
