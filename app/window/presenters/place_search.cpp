#include "app/window/presenters/place_search.h"

#include "app/window/presenters/place_sentences.h"
#include "app/window/session/session_controller.h"

#include <sstream>
#include <utility>

namespace hexoderm {
namespace {

/// Everything that places depend on, so that two decisions can be compared.
std::string asText(const PatchPlacement& placement, const std::string& link) {
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

std::string asText(const SE3& T) {
  std::ostringstream text;
  text.precision(17);
  text << T.R << ' ' << T.t.transpose();
  return text.str();
}

}  // namespace

PlaceSearch::PlaceSearch(SessionController& controller, Placing& placing, PlaceFacts& facts, PlaceFaults& faults)
    : controller_(controller), placing_(placing), facts_(facts), faults_(faults) {
  connect(&placing_, &Placing::robotRead, this, [this](const std::shared_ptr<const LoadedRobot>& robot) {
    facts_.robot = robot;
    faults_.robot.clear();
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
    faults_.links.clear();
    emit changed();
  });
  connect(&placing_, &Placing::placesFound, this, [this](const std::shared_ptr<const PlaceResult>& places) {
    facts_.places = places;
    faults_.places.clear();
    facts_.preview = -1;
    emit placesFound();
  });
  connect(&placing_, &Placing::failed, this, &PlaceSearch::takeFault);
}

void PlaceSearch::takeFault(PlaceWork work, const QString& message) {
  switch (work) {
    case PlaceWork::Robot:
      faults_.robot = message;
      picked_.reset();
      break;
    case PlaceWork::Joints:
      return;  // nothing that is looked for
    case PlaceWork::Links:
      facts_.links.reset();
      faults_.links = message;
      break;
    case PlaceWork::Places:
      facts_.places.reset();
      faults_.places = message;
      facts_.lays = false;
      break;
  }
  emit changed();
}

void PlaceSearch::pickRobot(const RobotDescription& description) {
  faults_.robot.clear();
  picked_ = description;
  placing_.readRobot(description);
}

/// The session's robot is read; another one, by undo for example, takes its place.
void PlaceSearch::followRobot() {
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
  faults_.robot.clear();
  forgetPlaces();
  if (asked_) {
    placing_.readRobot(*asked_);
  } else {
    placing_.cancel(PlaceWork::Robot);
  }
}

void PlaceSearch::findLinks() {
  const std::map<PoseId, JointAngles> known = facts_.angles();
  if (!facts_.robot || !facts_.solved || !controller_.session() || known.empty()) {
    facts_.links.reset();
    links_question_.reset();
    faults_.links.clear();
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
  faults_.links.clear();
  LinksOptions options;
  options.chosen = question.chosen;
  placing_.findLinks(facts_.solved, facts_.robot, known, options);
}

void PlaceSearch::forgetPlaces() {
  facts_.places.reset();
  places_question_.reset();
  faults_.places.clear();
  faults_.places_remark.clear();
  facts_.preview = -1;
  placing_.cancel(PlaceWork::Places);
}

void PlaceSearch::findPlaces() {
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
  for (const PatchReconstruction* other : facts_.placedWith(*of)) known_points += facts_.decided(*other).points.size();
  if (known_points > task->points.size()) {
    faults_.places_remark =
        tr("Of a patch this large only some cells are placed, and %1 known points are of others: give points "
           "of other cells.")
            .arg(known_points - task->points.size());
  }
  placing_.findPlaces(std::move(*task));
}

}  // namespace hexoderm
