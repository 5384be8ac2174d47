#include "app/window/presenters/place_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/presenters/robot_picture.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "app/window/toolkit/file_dialog.h"
#include "hexoderm/reconstruction/result/patch_placements.h"
#include "hexoderm/robot/place/by_gravity.h"
#include "hexoderm/util/error.h"
#include "widgets/controls/step_panel.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/place_words.h"
#include "widgets/robot/robot_view.h"
#include "widgets/words/words.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
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

QString endingOf(const QString& path) { return QFileInfo(path).suffix().toLower(); }

}  // namespace

PlacePresenter::PlacePresenter(const Views& views, SessionController& controller, Placing& placing)
    : views_(views),
      controller_(controller),
      placing_(placing),
      facts_(controller),
      sentences_(facts_, faults_),
      decisions_(controller, facts_) {
  connectPanel();
  connectWork();
  connectEdits();
  connectHand();
  connect(&views_.steps, &StepPanel::opened, this, [this] {
    showStand();
    showRobot();
  });
  connect(&controller_, &SessionController::opened, this, [this] {
    joints_file_.clear();
    faults_.robot.clear();
    faults_.joints.clear();
    faults_.known.clear();
    facts_.pose = 0;
    facts_.spoken_of = CellId(0);
    looked_at_.reset();
    leaveAlone();
    facts_.put.reset();
    lays_ = false;
  });
}

void PlacePresenter::connectPanel() {
  PlacePanel* panel = &views_.panel;
  connect(panel, &PlacePanel::robotWanted, this, &PlacePresenter::askForRobot);
  connect(panel, &PlacePanel::packageWanted, this, &PlacePresenter::askForPackage);
  connect(panel, &PlacePanel::jointsWanted, this, &PlacePresenter::askForJoints);
  connect(panel, &PlacePanel::anglesTyped, this, &PlacePresenter::setAngles);
  connect(panel, &PlacePanel::anglesRefused, this, [this](const QString& why) {
    faults_.joints = why;
    showStand();
  });
  connect(panel, &PlacePanel::cancelRequested, this, [this](PlaceWork work) {
    placing_.cancel(work);
    if (work == PlaceWork::Robot) picked_.reset();
    if (work == PlaceWork::Links) faults_.links = tr("Cancelled.");
    if (work == PlaceWork::Places) {
      faults_.places = tr("Cancelled.");
      lays_ = false;
    }
    refresh();
  });
  connect(panel, &PlacePanel::poseChosen, this, [this](quint32 pose) {
    facts_.pose = pose;
    refresh();
  });
  connect(panel, &PlacePanel::patchChosen, this, [this](quint32 origin) {
    facts_.spoken_of = CellId(origin);
    faults_.known.clear();
    leaveAlone();
    facts_.put.reset();
    lays_ = false;
    forgetPlaces();
    refresh();
  });
  connect(panel, &PlacePanel::placePreviewed, this, [this](int row) {
    if (std::exchange(facts_.preview, row) != row) showStand();
  });
  connect(panel, &PlacePanel::pickingChanged, &views_.robot, &RobotView::setPicking);
  connect(&views_.robot, &RobotView::pointPicked, panel, [this](std::size_t link, const Eigen::Vector3d& x_l) {
    const PatchReconstruction* of = facts_.patch();
    if (!facts_.robot || of == nullptr) return;
    const std::string& name = facts_.robot->model.links()[link].name;
    if (name == facts_.linkOf(*of)) {
      faults_.known.clear();
      views_.panel.proposePoint(x_l);
    } else {
      faults_.known = tr("This point is on link %1, and the patch on %2: pick a point of that link.")
                          .arg(QString::fromStdString(name), QString::fromStdString(facts_.linkOf(*of)));
    }
    showStand();
  });
}

void PlacePresenter::connectWork() {
  connect(&placing_, &Placing::runningChanged, &views_.panel, &PlacePanel::setRunning);
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
    refresh();
  });
  connect(&placing_, &Placing::jointsRead, this, [this](const LoadedJoints& joints) {
    faults_.joints.clear();
    joints_file_ = joints.file;
    std::vector<SessionEdit> edits;
    // Poses may have gone while the file was read.
    const std::size_t poses = controller_.session() ? controller_.session()->poses().size() : 0;
    for (const SetJointAngles& edit : joints.edits) {
      if (edit.index < poses) edits.emplace_back(edit);
    }
    if (edits.empty()) {
      faults_.joints = tr("%1 has no line for any pose of this session.").arg(joints.file);
    } else {
      controller_.perform(edits, tr("read the joint angles of %1").arg(joints.file));
    }
    refresh();
  });
  connect(&placing_, &Placing::linksFound, this, [this](const std::shared_ptr<const LinksResult>& links) {
    facts_.links = links;
    faults_.links.clear();
    refresh();
  });
  connect(&placing_, &Placing::placesFound, this, [this](const std::shared_ptr<const PlaceResult>& places) {
    facts_.places = places;
    faults_.places.clear();
    facts_.preview = -1;
    if (std::exchange(lays_, false)) {
      const auto laid = std::ranges::find(facts_.places->candidates, true, &PlaceCandidate::by_hand);
      if (laid != facts_.places->candidates.end()) {
        faults_.known = decisions_.choosePlace(static_cast<int>(laid - facts_.places->candidates.begin()),
                                               tr("move the patch by hand"));
      }
    }
    refresh();
  });
  connect(&placing_, &Placing::failed, this, [this](PlaceWork work, const QString& message) {
    switch (work) {
      case PlaceWork::Robot:
        faults_.robot = message;
        picked_.reset();
        break;
      case PlaceWork::Joints:
        faults_.joints = message;
        break;
      case PlaceWork::Links:
        facts_.links.reset();
        faults_.links = message;
        break;
      case PlaceWork::Places:
        facts_.places.reset();
        faults_.places = message;
        lays_ = false;
        break;
    }
    refresh();
  });
}

void PlacePresenter::connectEdits() {
  PlacePanel* panel = &views_.panel;
  connect(panel, &PlacePanel::robotRemoved, this, [this] {
    if (controller_.session()) controller_.perform({SetRobot{}});
  });
  connect(panel, &PlacePanel::linkChosen, this, [this](const QString& link) { take(decisions_.chooseLink(link)); });
  connect(panel, &PlacePanel::surfaceChosen, this,
          [this](bool by_surface) { take(decisions_.useSurface(by_surface)); });
  connect(panel, &PlacePanel::pointAdded, this, [this](const KnownPoint& point) { take(decisions_.addPoint(point)); });
  connect(panel, &PlacePanel::pointRemoved, this, [this](int index) { take(decisions_.removePoint(index)); });
  connect(panel, &PlacePanel::distanceAdded, this,
          [this](const KnownDistance& distance) { take(decisions_.addDistance(distance)); });
  connect(panel, &PlacePanel::distanceRemoved, this, [this](int index) { take(decisions_.removeDistance(index)); });
  connect(panel, &PlacePanel::placeChosen, this,
          [this](int row) { take(decisions_.choosePlace(row, tr("place the patch"))); });
  connect(panel, &PlacePanel::placeRemoved, this, [this] { take(decisions_.takeAway()); });
}

/// What became of a decision is shown.
void PlacePresenter::take(const QString& fault) {
  faults_.known = fault;
  refresh();
}

void PlacePresenter::connectHand() {
  PlacePanel* panel = &views_.panel;
  RobotView* view = &views_.robot;
  connect(panel, &PlacePanel::lookWanted, this,
          [this] { views_.robot.lookAtSkin(indexInPicture(picture(), facts_.patch())); });
  connect(panel, &PlacePanel::movingChanged, this, [this](bool moving) {
    if (!moving) return lay();
    if (takeInHand()) {
      showStand();
      views_.robot.setMoving(true);
    } else {
      views_.panel.endMoving();
    }
  });
  connect(view, &RobotView::gripped, this, [this](const Eigen::Vector3d& x_l) {
    if (takeInHand()) moveInHand([&] { hand_.grip(x_l); });
  });
  connect(view, &RobotView::pulledTo, this,
          [this](const Eigen::Vector3d& x_l) { moveInHand([&] { hand_.pullTo(x_l); }); });
  connect(view, &RobotView::slid, this,
          [this](const Eigen::Vector3d& way_l) { moveInHand([&] { hand_.slide(way_l); }); });
  connect(view, &RobotView::turned, this, [this](double angle_rad) { moveInHand([&] { hand_.turn(angle_rad); }); });
  connect(view, &RobotView::released, this, &PlacePresenter::lay);
  connect(view, &RobotView::laid, this, &PlacePresenter::lay);
  connect(view, &RobotView::leftAlone, this, [this] {
    leaveAlone();
    showStand();
  });
}

// --- files

void PlacePresenter::askForRobot() {
  auto* dialog = new FileDialog(&views_.window, tr("Choose the robot's URDF"), lastFolder(),
                                tr("Robots (*.urdf *.xml);;All files (*)"));
  dialog->setObjectName(QStringLiteral("robotDialog"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    rememberFolder(path);
    pickRobot({path.toStdString(), {}, {}});
  });
  openInTurns(dialog);
}

void PlacePresenter::askForPackage() {
  auto* dialog = new FileDialog(&views_.window, tr("The folder of a package"), lastFolder());
  dialog->setObjectName(QStringLiteral("packageDialog"));
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    if (!facts_.robot) return;
    RobotDescription description = facts_.robot->description;
    description.sha256.clear();
    description.packages[QDir(path).dirName().toStdString()] = path.toStdString();
    pickRobot(description);
  });
  openInTurns(dialog);
}

void PlacePresenter::askForJoints() {
  auto* dialog = new FileDialog(&views_.window, tr("Choose a table of joint angles"), lastFolder(),
                                tr("Tables (*.csv *.tsv *.txt);;All files (*)"));
  dialog->setObjectName(QStringLiteral("jointsDialog"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    rememberFolder(path);
    readJoints(path);
  });
  openInTurns(dialog);
}

void PlacePresenter::pickRobot(const RobotDescription& description) {
  faults_.robot.clear();
  picked_ = description;
  placing_.readRobot(description);
  showStand();
}

void PlacePresenter::readJoints(const QString& path) {
  faults_.joints.clear();
  if (!facts_.robot || !controller_.session()) return;
  placing_.readJoints(path, facts_.robot, *controller_.session());
}

void PlacePresenter::setAngles(const std::vector<TypedAngle>& angles) {
  if (!controller_.session()) return;
  faults_.joints.clear();
  const std::vector<SessionPose>& poses = controller_.session()->poses();
  std::map<std::size_t, JointAngles> of_poses;
  for (const TypedAngle& angle : angles) {
    if (angle.row >= poses.size()) continue;
    JointAngles& of_pose = of_poses.try_emplace(angle.row, poses[angle.row].joint_angles).first->second;
    if (angle.position) {
      of_pose.positions[angle.joint] = *angle.position;
    } else {
      of_pose.positions.erase(angle.joint);
    }
  }
  std::vector<SessionEdit> edits;
  for (auto& [index, of_pose] : of_poses) edits.emplace_back(SetJointAngles{index, std::move(of_pose)});
  if (edits.empty()) return;
  controller_.perform(edits, edits.size() > 1 ? tr("set joint angles of %1 poses").arg(edits.size()) : QString());
  refresh();
}

bool PlacePresenter::takeFile(const QString& path) {
  const QString ending = endingOf(path);
  const bool is_robot = ending == QStringLiteral("urdf");
  const bool is_table = ending == QStringLiteral("csv") || ending == QStringLiteral("tsv");
  if ((!is_robot && !is_table) || !whyNot().isEmpty()) return false;
  views_.steps.openStep(static_cast<int>(GuideStep::Place));
  if (is_robot) {
    pickRobot({path.toStdString(), {}, {}});
  } else if (facts_.robot) {
    readJoints(path);
  } else {
    faults_.joints = tr("Choose the robot first: its joints have the names of the columns.");
    faults_.robot = faults_.joints;
    showStand();
  }
  return true;
}

// --- what follows from the session

void PlacePresenter::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  facts_.solved = std::move(reconstruction);
  if (!facts_.solved) {
    facts_.links.reset();
    forgetPlaces();
  }
}

void PlacePresenter::refresh() {
  followRobot();
  if (facts_.patch() == nullptr && facts_.solved) {
    const PatchReconstruction* largest = largestPatch(*facts_.solved);
    facts_.spoken_of = largest != nullptr ? largest->origin : CellId(0);
    forgetPlaces();
  }
  if (hand_.isHeld()) {
    const auto where = handle();
    if (!where || !hand_.isReadyFor(*where)) leaveAlone();
  }
  findLinks();
  findPlaces();
  showStand();
  showRobot();
}

/// The session's robot is read; another one, by undo for example, takes its place.
void PlacePresenter::followRobot() {
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

void PlacePresenter::findLinks() {
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

void PlacePresenter::forgetPlaces() {
  facts_.places.reset();
  places_question_.reset();
  faults_.places.clear();
  faults_.places_remark.clear();
  facts_.preview = -1;
  placing_.cancel(PlaceWork::Places);
}

void PlacePresenter::findPlaces() {
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
    lays_ = false;
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

QString PlacePresenter::whyNot() const {
  if (!controller_.reconstruction()) {
    const QString awaited = describeAwaited(controller_);
    return awaited.isEmpty() ? tr("There is no skin yet.") : awaited;
  }
  if (!controller_.session()) return tr("A calibration is open: it holds the result, not the poses.");
  return {};
}

// --- in words and in 3D

RobotPicture PlacePresenter::picture() const {
  RobotPicture picture = robotPicture(facts_, hand_, lays_);
  if (handle() && views_.steps.openIndex() == static_cast<int>(GuideStep::Place)) {
    picture.movable = indexInPicture(picture, facts_.patch());
  }
  return picture;
}

void PlacePresenter::showStand() {
  PlaceStand stand;
  stand.why_not = whyNot();
  stand.has_robot = facts_.robot != nullptr;
  stand.names_robot = asked_.has_value();
  stand.robot = sentences_.robot();
  stand.joints = sentences_.joints();
  stand.sheet = facts_.sheet();
  if (facts_.solved) sentences_.addChoices(stand);
  if (const PatchReconstruction* of = facts_.patch(); of != nullptr && facts_.robot) {
    if (const PatchLinks* links = facts_.linksOf(*of)) stand.links = linkChoices(*links);
    const std::string link = facts_.linkOf(*of);
    stand.link = QString::fromStdString(link);
    stand.link_says = sentences_.link(*of);
    const auto index = facts_.robot->model.findLink(link);
    stand.has_surface = index && !(*facts_.robot->bodies)[*index].empty();
    stand.known = facts_.decided(*of);
    stand.known_fault = faults_.known;
    stand.is_placed = stand.known.place.has_value();
    stand.place = facts_.rowOfPlace();
    if (facts_.places) {
      for (std::size_t k = 0; k < facts_.places->candidates.size(); ++k) {
        stand.places << placeInList(facts_.places->candidates[k], k + 1, static_cast<int>(k) == stand.place);
      }
    }
    stand.place_says = hand_.isHeld() ? PlaceSentences::hand(hand_) : sentences_.places();
    if (!link.empty() && !index) {
      stand.link_says = {Tone::Bad, tr("The robot has no link %1, on which the patch was placed: choose another one, "
                                       "or the robot that it belongs to.")
                                        .arg(stand.link)};
    }
  }
  const RobotPicture drawn = picture();
  views_.robot.setPicture(drawn);
  lookAtWhatIsNew(drawn);
  stand.is_drawn = indexInPicture(drawn, facts_.patch()).has_value();
  stand.can_move = handle().has_value() && views_.robot.canDraw();
  views_.panel.setStand(stand);
}

/// In the step itself; and before the export where there is something to be seen of it: there it is looked at closely,
/// so that the cells' numbers can be compared with the skin.
/// The camera goes up to a patch when it is drawn on a link for the first time; after that it is the operator's.
void PlacePresenter::lookAtWhatIsNew(const RobotPicture& drawn) {
  const auto index = indexInPicture(drawn, facts_.patch());
  if (!index) return;
  const std::pair<CellId, std::size_t> seen{facts_.spoken_of, drawn.patches[*index].link};
  if (std::exchange(looked_at_, seen) != seen) views_.robot.lookAtSkin(index);
}

void PlacePresenter::showRobot() {
  const int open = views_.steps.openIndex();
  const bool opened = std::exchange(open_step_, open) != open;
  const bool placed = controller_.reconstruction() && !placedPatches(*controller_.reconstruction()).empty();
  const bool before_export = placed && open == static_cast<int>(GuideStep::Export);
  if (facts_.robot && before_export && opened) views_.robot.lookAtSkin();
  const bool shown = facts_.robot && (open == static_cast<int>(GuideStep::Place) || before_export);
  if (shown == views_.robot.isVisibleTo(views_.robot.parentWidget())) return;
  views_.robot.setVisible(shown);
  // Beneath, it would take the keyboard and not be seen.
  views_.middle.setVisible(!shown);
}

// --- by hand

std::optional<HandPlace::Where> PlacePresenter::handle() const {
  const PatchReconstruction* of = facts_.patch();
  if (!facts_.robot || of == nullptr || !controller_.session() || !facts_.decided(*of).by_surface) return std::nullopt;
  const auto link = facts_.robot->model.findLink(facts_.linkOf(*of));
  if (!link || (*facts_.robot->bodies)[*link].empty()) return std::nullopt;
  return HandPlace::Where{facts_.robot, *link, facts_.solved, facts_.links, of->origin};
}

bool PlacePresenter::takeInHand() {
  if (hand_.isHeld()) return true;
  const auto where = handle();
  if (!where) return false;
  const PatchReconstruction* of = facts_.patch();
  const RobotPicture drawn = picture();
  const auto index = indexInPicture(drawn, of);
  std::optional<SE3> from;
  if (index && drawn.patches[*index].link == where->link) from = drawn.patches[*index].T_l_o;
  try {
    if (!hand_.isReadyFor(*where)) {
      PatchToPlace to_place = patchToPlace(*of);
      if (const PatchLinks* links = facts_.linksOf(*of))
        to_place.rotation = rotationByGravity(*links, facts_.linkOf(*of));
      hand_.getReady(*where, to_place, facts_.solved->model->thickness_m);
    }
    hand_.take(from);
  } catch (const InvalidArgument& error) {
    faults_.places = words(error);
    showStand();
    return false;
  }
  return true;
}

template <class Move>
void PlacePresenter::moveInHand(Move move) {
  if (!hand_.isHeld()) return;
  move();
  showStand();
}

void PlacePresenter::lay() {
  if (!hand_.isHeld()) return;
  if (hand_.isMoved()) {
    facts_.put = hand_.place();
    lays_ = true;
    places_question_.reset();
  }
  leaveAlone();
  refresh();
}

void PlacePresenter::leaveAlone() {
  hand_.letGo();
  views_.robot.setMoving(false);
  views_.panel.endMoving();
}

}  // namespace hexoderm
