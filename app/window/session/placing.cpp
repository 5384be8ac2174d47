#include "app/window/session/placing.h"

#include "app/window/files/session_paths.h"
#include "hexoderm/kinematics/joint_check.h"
#include "hexoderm/session/session_joint_angles.h"
#include "hexoderm/util/error.h"
#include "widgets/words/words.h"

#include <QFileInfo>
#include <QMetaObject>
#include <exception>
#include <utility>

namespace hexoderm {
namespace {

/// A mesh that can't be read is said, and leaves its link without a body: the other links are of use all the same.
TriangleMesh bodyOrFinding(const RobotModel& robot, std::size_t link, std::vector<VerifySentence>& findings) {
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

std::shared_ptr<const LoadedRobot> loadRobot(const RobotDescription& description, const std::stop_token& stop) {
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

}  // namespace

Placing::Placing(QObject* parent) : QObject(parent), worker_(kKinds) {}

void Placing::readRobot(const RobotDescription& description) {
  request(PlaceWork::Robot, [this, description](const std::stop_token& stop) -> Announcement {
    return [this, robot = loadRobot(description, stop)] { emit robotRead(robot); };
  });
}

void Placing::readJoints(const QString& path, std::shared_ptr<const LoadedRobot> robot, const Session& session) {
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

void Placing::findLinks(std::shared_ptr<const Reconstruction> reconstruction, std::shared_ptr<const LoadedRobot> robot,
                        std::map<PoseId, JointAngles> angles, LinksOptions options) {
  request(PlaceWork::Links,
          [this, reconstruction = std::move(reconstruction), robot = std::move(robot), angles = std::move(angles),
           options = std::move(options)](const std::stop_token&) -> Announcement {
            auto links = std::make_shared<const LinksResult>(
                hexoderm::findLinks(*reconstruction, robot->model, angles, options));
            return [this, links] { emit linksFound(links); };
          });
}

void Placing::findPlaces(PlaceTask task) {
  request(PlaceWork::Places, [this, task = std::move(task)](const std::stop_token&) -> Announcement {
    auto places = std::make_shared<const PlaceResult>(placePatches(task));
    return [this, places] { emit placesFound(places); };
  });
}

void Placing::cancel(PlaceWork work) {
  const std::size_t slot = slotOf(work);
  worker_.cancel(slot);
  ++newest_.at(slot);
  setRunning(work, false);
}

void Placing::request(PlaceWork kind, Work work) {
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

void Placing::finish(PlaceWork kind, std::uint64_t number, const Announcement& announce) {
  if (newest_.at(slotOf(kind)) != number) return;
  setRunning(kind, false);
  announce();
}

void Placing::setRunning(PlaceWork kind, bool running) {
  bool& told = running_.at(slotOf(kind));
  if (std::exchange(told, running) != running) emit runningChanged(kind, running);
}

}  // namespace hexoderm
