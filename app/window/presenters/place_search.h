#pragma once

#include "app/window/session/place_facts.h"

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

struct PlaceFaults;
class SessionController;

/// Has the session's robot read, and links and places found for what is known, as often as that changes. What comes of
/// it, and what goes wrong, is written into the facts and faults of the step "Place on the robot".
class PlaceSearch : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlaceSearch(SessionController& controller, Placing& placing, PlaceFacts& facts, PlaceFaults& faults);

  /// Reads a robot for the operator; the session gets it if it can be read.
  void pickRobot(const RobotDescription& description);
  /// The robot that is being read is not wanted any more.
  void dropPickedRobot() { picked_.reset(); }
  /// Whether the session has a robot, read or not.
  [[nodiscard]] bool namesRobot() const { return asked_.has_value(); }
  void followRobot();
  void findLinks();
  void findPlaces();
  void forgetPlaces();
  /// findPlaces() is to look again, although nothing has changed.
  void askForPlacesAgain() { places_question_.reset(); }

 signals:
  /// A robot or links are known, or something went wrong.
  void changed();
  void placesFound();

 private:
  /// What links were looked for with.
  struct LinksQuestion {
    std::shared_ptr<const LoadedRobot> robot;
    std::shared_ptr<const Reconstruction> solved;
    std::map<PoseId, JointAngles> angles;
    std::map<CellId, std::string> chosen;
    friend bool operator==(const LinksQuestion&, const LinksQuestion&) = default;
  };
  /// What places were looked for with, the patch's own decisions as text.
  struct PlacesQuestion {
    std::shared_ptr<const LoadedRobot> robot;
    std::shared_ptr<const Reconstruction> solved;
    std::shared_ptr<const LinksResult> links;
    std::vector<std::string> decisions;
    friend bool operator==(const PlacesQuestion&, const PlacesQuestion&) = default;
  };

  void takeFault(PlaceWork work, const QString& message);

  SessionController& controller_;
  Placing& placing_;
  PlaceFacts& facts_;
  PlaceFaults& faults_;
  std::optional<RobotDescription> asked_;   ///< whose file is read, or was
  std::optional<RobotDescription> picked_;  ///< by the operator, and being read; the session gets it if it can be
  std::optional<LinksQuestion> links_question_;
  std::optional<PlacesQuestion> places_question_;
};

}  // namespace hexoderm
