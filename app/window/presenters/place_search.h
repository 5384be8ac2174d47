#pragma once

#include "app/window/presenters/place_sentences.h"
#include "app/window/session/place_facts.h"
#include "app/window/session/session_controller.h"

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// Has the session's robot read, and links and places found for what is known, as often as that changes. What comes of
/// it, and what goes wrong, is written into the facts and faults of the step "Place on the robot".
class PlaceSearch : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlaceSearch(SessionController& controller, Placing& placing, PlaceFacts& facts)
      : controller_(controller), placing_(placing), facts_(facts) {
    connect(&placing_, &Placing::robotRead, this, [this](const std::shared_ptr<const LoadedRobot>& robot) {
      facts_.robot = robot;
      facts_.faults.robot.clear();
      facts_.links.reset();
      links_question_.reset();
      forgetPlaces();
      if (std::exchange(picked_, std::nullopt)) {
        asked_ = robot->description;
        if (controller_.session()) controller_.perform({SetRobot{robot->description}});
      }
      emit changed();
    });
    connect(&placing_, &Placing::linksFound, this, [this](const std::shared_ptr<const LinksResult>& links) {
      facts_.links = links;
      facts_.faults.links.clear();
      emit changed();
    });
    connect(&placing_, &Placing::placesFound, this, [this](const std::shared_ptr<const PlaceResult>& places) {
      facts_.places = places;
      facts_.faults.places.clear();
      facts_.preview = -1;
      emit placesFound();
    });
    connect(&placing_, &Placing::failed, this, &PlaceSearch::takeFault);
  }

  /// Reads a robot for the operator; the session gets it if it can be read.
  void pickRobot(const RobotDescription& description) {
    facts_.faults.robot.clear();
    picked_ = description;
    placing_.readRobot(description);
  }

  /// The robot that is being read is not wanted any more.
  void dropPickedRobot() { picked_.reset(); }
  /// Whether the session has a robot, read or not.
  [[nodiscard]] bool namesRobot() const { return asked_.has_value(); }
  /// The session's robot is read; another one, by undo for example, takes its place.
  void followRobot() {
    if (picked_) return;
    std::optional<RobotDescription> wanted;
    if (controller_.session()) {
      wanted = controller_.session()->robot();
    } else if (controller_.reconstruction()) {
      wanted = controller_.reconstruction()->robot;
    }
    if (wanted == asked_) return;
    asked_ = wanted;
    facts_.robot.reset();
    facts_.links.reset();
    links_question_.reset();
    facts_.faults.robot.clear();
    forgetPlaces();
    if (asked_) {
      placing_.readRobot(*asked_);
    } else {
      placing_.cancel(PlaceWork::Robot);
    }
  }

  void findLinks() {
    const std::map<PoseId, JointAngles> known = facts_.angles();
    if (!facts_.robot || !facts_.solved || !controller_.session() || known.empty()) {
      facts_.links.reset();
      links_question_.reset();
      facts_.faults.links.clear();
      placing_.cancel(PlaceWork::Links);
      return;
    }
    LinksQuestion question{facts_.robot, facts_.solved, known, {}};
    for (const PatchPlacement& placement : controller_.reconstruction()->placements) {
      const bool is_there =
          facts_.robot->model.findLink(placement.link).has_value() && facts_.patchOf(placement.origin) != nullptr;
      if (placement.link_chosen && is_there) question.chosen[placement.origin] = placement.link;
    }
    if (links_question_ == question) return;
    links_question_ = question;
    facts_.faults.links.clear();
    LinksOptions options;
    options.chosen = question.chosen;
    placing_.findLinks(facts_.solved, facts_.robot, known, options);
  }

  void findPlaces() {
    const PatchReconstruction* of = facts_.patch();
    // How the patch is turned has to be known first, as far as it can be.
    if (placing_.isRunning(PlaceWork::Links)) return;
    if (!facts_.robot || !facts_.solved || of == nullptr || !controller_.session() || facts_.linkOf(*of).empty()) {
      forgetPlaces();
      return;
    }
    PlacesQuestion question{facts_.robot, facts_.solved, facts_.links, {}};
    for (const PatchReconstruction* other : facts_.placedWith(*of)) {
      question.decisions.push_back(asText(facts_.decided(*other), facts_.linkOf(*other)));
    }
    if (facts_.isPut(*of)) question.decisions.push_back(asText(facts_.put->T_l_o));
    if (places_question_ == question) return;
    forgetPlaces();
    places_question_ = question;
    std::optional<PlaceTask> task = facts_.taskFor(*of);
    if (!task) {
      facts_.lays = false;
      return;
    }
    std::size_t known_points = 0;
    for (const PatchReconstruction* other : facts_.placedWith(*of))
      known_points += facts_.decided(*other).points.size();
    if (known_points > task->points.size()) {
      facts_.faults.places_remark =
          tr("Of a patch this large only some cells are placed, and %1 known points are of others: give points "
             "of other cells.")
              .arg(known_points - task->points.size());
    }
    placing_.findPlaces(std::move(*task));
  }

  void forgetPlaces() {
    facts_.places.reset();
    places_question_.reset();
    facts_.faults.places.clear();
    facts_.faults.places_remark.clear();
    facts_.preview = -1;
    placing_.cancel(PlaceWork::Places);
  }

  /// findPlaces() is to look again, although nothing has changed.
  void askForPlacesAgain() { places_question_.reset(); }

 signals:
  /// A robot or links are known, or something went wrong.
  void changed();
  void placesFound();

 private:
  /// Everything that places depend on, so that two decisions can be compared.
  static std::string asText(const PatchPlacement& placement, const std::string& link) {
    std::ostringstream text;
    text.precision(17);
    text << placement.origin << ' ' << link << ' ' << placement.by_surface;
    for (const KnownPoint& point : placement.points) {
      text << "; " << point.cell << ' ' << point.x_l.transpose() << ' ' << point.sigma_m;
    }
    for (const KnownDistance& distance : placement.distances) {
      text << "; " << distance.a << ' ' << distance.b << ' ' << distance.distance_m << ' ' << distance.sigma_m;
    }
    return text.str();
  }

  static std::string asText(const SE3& T) {
    std::ostringstream text;
    text.precision(17);
    text << T.R << ' ' << T.t.transpose();
    return text.str();
  }

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

  void takeFault(PlaceWork work, const QString& message) {
    switch (work) {
      case PlaceWork::Robot:
        facts_.faults.robot = message;
        picked_.reset();
        break;
      case PlaceWork::Joints:
        return;  // nothing that is looked for
      case PlaceWork::Links:
        facts_.links.reset();
        facts_.faults.links = message;
        break;
      case PlaceWork::Places:
        facts_.places.reset();
        facts_.faults.places = message;
        facts_.lays = false;
        break;
    }
    emit changed();
  }

  SessionController& controller_;
  Placing& placing_;
  PlaceFacts& facts_;
  std::optional<RobotDescription> asked_;   ///< whose file is read, or was
  std::optional<RobotDescription> picked_;  ///< by the operator, and being read; the session gets it if it can be
  std::optional<LinksQuestion> links_question_;
  std::optional<PlacesQuestion> places_question_;
};

}  // namespace hexoderm
