#include "app/window/presenters/place_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "app/window/toolkit/file_dialog.h"
#include "hexoderm/geometry/se3.h"
#include "hexoderm/kinematics/joint_check.h"
#include "hexoderm/reconstruction/result/patch_placements.h"
#include "hexoderm/robot/place/by_gravity.h"
#include "hexoderm/util/error.h"
#include "widgets/controls/step_panel.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/words/words.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <sstream>
#include <utility>

namespace hexoderm {
namespace {

QString fileNameOf(const RobotDescription& description) {
  return QFileInfo(QString::fromStdString(description.urdf)).fileName();
}

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

bool isSamePlace(const PatchOnLink& a, const PatchOnLink& b) {
  constexpr double kSame_m = 1e-4;
  constexpr double kSame_rad = 1e-3;
  return a.link == b.link && (a.T_l_o.t - b.T_l_o.t).norm() < kSame_m &&
         rotationAngle(a.T_l_o.R.transpose() * b.T_l_o.R) < kSame_rad;
}

/// Where a patch is among those of a picture.
std::optional<std::size_t> indexInPicture(const RobotPicture& picture, const PatchReconstruction* patch) {
  for (std::size_t k = 0; patch != nullptr && k < picture.patches.size(); ++k) {
    if (&picture.skin->patches[picture.patches[k].patch] == patch) return k;
  }
  return std::nullopt;
}

QString endingOf(const QString& path) { return QFileInfo(path).suffix().toLower(); }

}  // namespace

PlacePresenter::PlacePresenter(const Views& views, SessionController& controller, Placing& placing)
    : views_(views), controller_(controller), placing_(placing) {
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
    robot_fault_.clear();
    joints_fault_.clear();
    known_fault_.clear();
    pose_ = 0;
    patch_ = CellId(0);
    looked_at_.reset();
    leaveAlone();
    put_.reset();
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
    joints_fault_ = why;
    showStand();
  });
  connect(panel, &PlacePanel::cancelRequested, this, [this](PlaceWork work) {
    placing_.cancel(work);
    if (work == PlaceWork::Robot) picked_.reset();
    if (work == PlaceWork::Links) links_fault_ = tr("Cancelled.");
    if (work == PlaceWork::Places) {
      places_fault_ = tr("Cancelled.");
      lays_ = false;
    }
    refresh();
  });
  connect(panel, &PlacePanel::poseChosen, this, [this](quint32 pose) {
    pose_ = pose;
    refresh();
  });
  connect(panel, &PlacePanel::patchChosen, this, [this](quint32 origin) {
    patch_ = CellId(origin);
    known_fault_.clear();
    leaveAlone();
    put_.reset();
    lays_ = false;
    forgetPlaces();
    refresh();
  });
  connect(panel, &PlacePanel::placePreviewed, this, [this](int row) {
    if (std::exchange(preview_, row) != row) showStand();
  });
  connect(panel, &PlacePanel::pickingChanged, &views_.robot, &RobotView::setPicking);
  connect(&views_.robot, &RobotView::pointPicked, panel, [this](std::size_t link, const Eigen::Vector3d& x_l) {
    const PatchReconstruction* of = patch();
    if (!robot_ || of == nullptr) return;
    const std::string& name = robot_->model.links()[link].name;
    if (name == linkOf(*of)) {
      known_fault_.clear();
      views_.panel.proposePoint(x_l);
    } else {
      known_fault_ = tr("This point is on link %1, and the patch on %2: pick a point of that link.")
                         .arg(QString::fromStdString(name), QString::fromStdString(linkOf(*of)));
    }
    showStand();
  });
}

void PlacePresenter::connectWork() {
  connect(&placing_, &Placing::runningChanged, &views_.panel, &PlacePanel::setRunning);
  connect(&placing_, &Placing::robotRead, this, [this](const std::shared_ptr<const LoadedRobot>& robot) {
    robot_ = robot;
    robot_fault_.clear();
    links_.reset();
    links_question_.reset();
    forgetPlaces();
    if (std::exchange(picked_, std::nullopt)) {
      asked_ = robot->description;
      if (controller_.session()) controller_.perform({SetRobot{robot->description}});
    }
    refresh();
  });
  connect(&placing_, &Placing::jointsRead, this, [this](const LoadedJoints& joints) {
    joints_fault_.clear();
    joints_file_ = joints.file;
    std::vector<SessionEdit> edits;
    // Poses may have gone while the file was read.
    const std::size_t poses = controller_.session() ? controller_.session()->poses().size() : 0;
    for (const SetJointAngles& edit : joints.edits) {
      if (edit.index < poses) edits.emplace_back(edit);
    }
    if (edits.empty()) {
      joints_fault_ = tr("%1 has no line for any pose of this session.").arg(joints.file);
    } else {
      controller_.perform(edits, tr("read the joint angles of %1").arg(joints.file));
    }
    refresh();
  });
  connect(&placing_, &Placing::linksFound, this, [this](const std::shared_ptr<const LinksResult>& links) {
    links_ = links;
    links_fault_.clear();
    refresh();
  });
  connect(&placing_, &Placing::placesFound, this, [this](const std::shared_ptr<const PlaceResult>& places) {
    places_ = places;
    places_fault_.clear();
    preview_ = -1;
    if (std::exchange(lays_, false)) {
      const auto laid = std::ranges::find(places_->candidates, true, &PlaceCandidate::by_hand);
      if (laid != places_->candidates.end()) {
        choosePlace(static_cast<int>(laid - places_->candidates.begin()), tr("move the patch by hand"));
      }
    }
    refresh();
  });
  connect(&placing_, &Placing::failed, this, [this](PlaceWork work, const QString& message) {
    switch (work) {
      case PlaceWork::Robot:
        robot_fault_ = message;
        picked_.reset();
        break;
      case PlaceWork::Joints:
        joints_fault_ = message;
        break;
      case PlaceWork::Links:
        links_.reset();
        links_fault_ = message;
        break;
      case PlaceWork::Places:
        places_.reset();
        places_fault_ = message;
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
  connect(panel, &PlacePanel::linkChosen, this, &PlacePresenter::chooseLink);
  connect(panel, &PlacePanel::pointAdded, this, &PlacePresenter::addPoint);
  connect(panel, &PlacePanel::distanceAdded, this, &PlacePresenter::addDistance);
  connect(panel, &PlacePanel::placeChosen, this, [this](int row) { choosePlace(row, tr("place the patch")); });
  connect(panel, &PlacePanel::surfaceChosen, this, [this](bool by_surface) {
    const PatchReconstruction* of = patch();
    if (of == nullptr) return;
    PatchPlacement placement = decided(*of);
    placement.by_surface = by_surface;
    decide({placement}, by_surface ? tr("use the surface of the link") : tr("do without the surface of the link"));
  });
  connect(panel, &PlacePanel::pointRemoved, this, [this](int index) {
    const PatchReconstruction* of = patch();
    if (of == nullptr) return;
    PatchPlacement placement = decided(*of);
    if (index < 0 || index >= static_cast<int>(placement.points.size())) return;
    placement.points.erase(placement.points.begin() + index);
    decide({placement}, tr("remove a known point"));
  });
  connect(panel, &PlacePanel::distanceRemoved, this, [this](int index) {
    const PatchReconstruction* of = patch();
    if (of == nullptr) return;
    PatchPlacement placement = decided(*of);
    if (index < 0 || index >= static_cast<int>(placement.distances.size())) return;
    placement.distances.erase(placement.distances.begin() + index);
    decide({placement}, tr("remove a measured distance"));
  });
  connect(panel, &PlacePanel::placeRemoved, this, [this] {
    const PatchReconstruction* of = patch();
    if (of == nullptr) return;
    PatchPlacement placement = decided(*of);
    placement.place.reset();
    decide({placement}, tr("take the patch away"));
  });
}

void PlacePresenter::connectHand() {
  PlacePanel* panel = &views_.panel;
  RobotView* view = &views_.robot;
  connect(panel, &PlacePanel::lookWanted, this,
          [this] { views_.robot.lookAtSkin(indexInPicture(picture(), patch())); });
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
    if (!robot_) return;
    RobotDescription description = robot_->description;
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
  robot_fault_.clear();
  picked_ = description;
  placing_.readRobot(description);
  showStand();
}

void PlacePresenter::readJoints(const QString& path) {
  joints_fault_.clear();
  if (!robot_ || !controller_.session()) return;
  placing_.readJoints(path, robot_, *controller_.session());
}

void PlacePresenter::setAngles(const std::vector<TypedAngle>& angles) {
  if (!controller_.session()) return;
  joints_fault_.clear();
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
  } else if (robot_) {
    readJoints(path);
  } else {
    joints_fault_ = tr("Choose the robot first: its joints have the names of the columns.");
    robot_fault_ = joints_fault_;
    showStand();
  }
  return true;
}

// --- what follows from the session

void PlacePresenter::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  solved_ = std::move(reconstruction);
  if (!solved_) {
    links_.reset();
    forgetPlaces();
  }
}

void PlacePresenter::refresh() {
  followRobot();
  if (patch() == nullptr && solved_) {
    const PatchReconstruction* largest = largestPatch(*solved_);
    patch_ = largest != nullptr ? largest->origin : CellId(0);
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
  robot_.reset();
  links_.reset();
  links_question_.reset();
  robot_fault_.clear();
  forgetPlaces();
  if (asked_) {
    placing_.readRobot(*asked_);
  } else {
    placing_.cancel(PlaceWork::Robot);
  }
}

void PlacePresenter::findLinks() {
  const std::map<PoseId, JointAngles> known = angles();
  if (!robot_ || !solved_ || !controller_.session() || known.empty()) {
    links_.reset();
    links_question_.reset();
    links_fault_.clear();
    placing_.cancel(PlaceWork::Links);
    return;
  }
  LinksQuestion question{robot_, solved_, known, {}};
  for (const PatchPlacement& placement : controller_.reconstruction()->placements) {
    const bool is_there = robot_->model.findLink(placement.link).has_value() && patchOf(placement.origin) != nullptr;
    if (placement.link_chosen && is_there) question.chosen[placement.origin] = placement.link;
  }
  if (links_question_ == question) return;
  links_question_ = question;
  links_fault_.clear();
  LinksOptions options;
  options.chosen = question.chosen;
  placing_.findLinks(solved_, robot_, known, options);
}

void PlacePresenter::forgetPlaces() {
  places_.reset();
  places_question_.reset();
  places_fault_.clear();
  places_remark_.clear();
  preview_ = -1;
  placing_.cancel(PlaceWork::Places);
}

void PlacePresenter::findPlaces() {
  const PatchReconstruction* of = patch();
  // How the patch is turned has to be known first, as far as it can be.
  if (placing_.isRunning(PlaceWork::Links)) return;
  if (!robot_ || !solved_ || of == nullptr || !controller_.session() || linkOf(*of).empty()) {
    forgetPlaces();
    return;
  }
  PlacesQuestion question{robot_, solved_, links_, {}};
  for (const PatchReconstruction* other : placedWith(*of)) {
    question.decisions.push_back(asText(decided(*other), linkOf(*other)));
  }
  if (isPut(*of)) question.decisions.push_back(asText(put_->T_l_o));
  if (places_question_ == question) return;
  forgetPlaces();
  places_question_ = question;
  std::optional<PlaceTask> task = taskFor(*of);
  if (!task) {
    lays_ = false;
    return;
  }
  std::size_t known_points = 0;
  for (const PatchReconstruction* other : placedWith(*of)) known_points += decided(*other).points.size();
  if (known_points > task->points.size()) {
    places_remark_ =
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

const PatchReconstruction* PlacePresenter::patchOf(CellId cell) const {
  return solved_ ? solved_->find(cell).patch : nullptr;
}

const PatchReconstruction* PlacePresenter::patch() const { return patchOf(patch_); }

const PatchLinks* PlacePresenter::linksOf(const PatchReconstruction& patch) const {
  if (!links_) return nullptr;
  const auto found = std::ranges::find(links_->patches, patch.origin, &PatchLinks::origin);
  return found == links_->patches.end() ? nullptr : &*found;
}

PatchPlacement PlacePresenter::decided(const PatchReconstruction& patch) const {
  const PatchPlacement* placement =
      controller_.reconstruction() ? placementOf(*controller_.reconstruction(), patch) : nullptr;
  if (placement != nullptr) return *placement;
  PatchPlacement nothing;
  nothing.origin = patch.origin;
  return nothing;
}

std::string PlacePresenter::linkOf(const PatchReconstruction& patch) const {
  const PatchPlacement placement = decided(patch);
  if (!placement.link.empty()) return placement.link;
  const PatchLinks* links = linksOf(patch);
  return links != nullptr && links->placed ? links->placed->link : std::string();
}

std::map<PoseId, JointAngles> PlacePresenter::angles() const {
  std::map<PoseId, JointAngles> known;
  if (!robot_ || !controller_.session()) return known;
  for (const SessionPose& pose : controller_.session()->poses()) {
    JointAngles of_robot;
    for (const auto& [joint, position] : pose.joint_angles.positions) {
      if (robot_->model.findJoint(joint)) of_robot.positions[joint] = position;
    }
    if (!of_robot.positions.empty()) known.try_emplace(pose.capture->id, std::move(of_robot));
  }
  return known;
}

JointAngles PlacePresenter::shownAngles() const {
  const std::map<PoseId, JointAngles> known = angles();
  const auto found = known.find(PoseId(pose_));
  if (found != known.end()) return found->second;
  return known.empty() ? JointAngles() : known.begin()->second;
}

JointSheet PlacePresenter::sheet() const {
  JointSheet sheet;
  if (!robot_ || !controller_.session()) return sheet;
  for (const RobotJoint& joint : robot_->model.joints()) {
    if (joint.isFree()) sheet.joints.push_back(joint);
  }
  for (const SessionPose& pose : controller_.session()->poses()) {
    sheet.rows.push_back({pose.capture->id, pose.joint_angles});
  }
  return sheet;
}

std::vector<const PatchReconstruction*> PlacePresenter::placedWith(const PatchReconstruction& patch) const {
  std::vector<const PatchReconstruction*> patches{&patch};
  const std::string link = linkOf(patch);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    for (const PatchReconstruction& other : solved_->patches) {
      if (std::ranges::find(patches, &other) != patches.end() || linkOf(other) != link) continue;
      const auto joins = [&](const PatchReconstruction& from, const PatchReconstruction& to) {
        const PatchPlacement placement = decided(from);
        return std::ranges::any_of(placement.distances,
                                   [&](const KnownDistance& d) { return to.findCell(d.b) != nullptr; });
      };
      if (joins(*patches[k], other) || joins(other, *patches[k])) patches.push_back(&other);
    }
  }
  return patches;
}

std::optional<PlaceTask> PlacePresenter::taskFor(const PatchReconstruction& patch) const {
  const std::string link = linkOf(patch);
  const auto index = robot_->model.findLink(link);
  if (!index) return std::nullopt;
  PlaceTask task;
  task.link = link;
  task.thickness_m = solved_->model->thickness_m;
  const std::vector<const PatchReconstruction*> patches = placedWith(patch);
  bool by_surface = !(*robot_->bodies)[*index].empty();
  for (const PatchReconstruction* of : patches) {
    const PatchPlacement placement = decided(*of);
    PatchToPlace to_place = patchToPlace(*of);
    if (const PatchLinks* links = linksOf(*of)) to_place.rotation = rotationByGravity(*links, link);
    if (isPut(*of)) to_place.start = put_->T_l_o;
    task.patches.push_back(std::move(to_place));
    // A patch of more cells than are placed goes without the points of those that are left out.
    const std::vector<CellId>& cells = task.patches.back().cells;
    for (const KnownPoint& point : placement.points) {
      if (std::ranges::find(cells, point.cell) != cells.end()) task.points.push_back(point);
    }
    by_surface = by_surface && placement.by_surface;
  }
  const auto isPlaced = [&](CellId cell) {
    return std::ranges::any_of(
        task.patches, [&](const PatchToPlace& of) { return std::ranges::find(of.cells, cell) != of.cells.end(); });
  };
  for (const PatchReconstruction* of : patches) {
    for (const KnownDistance& distance : decided(*of).distances) {
      if (isPlaced(distance.a) && isPlaced(distance.b)) task.distances.push_back(distance);
    }
  }
  if (by_surface) task.surface = (*robot_->bodies)[*index];
  if (!task.surface && task.points.empty() && task.distances.empty()) return std::nullopt;
  return task;
}

/// -1: the patch is at none of the places that were found.
int PlacePresenter::rowOfPlace() const {
  const PatchReconstruction* of = patch();
  if (of == nullptr || !places_) return -1;
  const PatchPlacement placement = decided(*of);
  if (!placement.place) return -1;
  for (std::size_t row = 0; row < places_->candidates.size(); ++row) {
    for (const PlacedPatch& placed : places_->candidates[row].patches) {
      if (placed.place.origin == of->origin && isSamePlace(placed.place, *placement.place)) {
        return static_cast<int>(row);
      }
    }
  }
  return -1;
}

// --- in words and in 3D

VerifySentence PlacePresenter::robotInWords() const {
  std::vector<VerifySentence> sentences;
  if (!robot_fault_.isEmpty()) sentences.push_back({Tone::Bad, robot_fault_});
  if (robot_) {
    sentences.push_back({Tone::Good, tr("%1, %2 links, from %3.")
                                         .arg(QString::fromStdString(robot_->model.name()))
                                         .arg(robot_->model.links().size())
                                         .arg(fileNameOf(robot_->description))});
    sentences.insert(sentences.end(), robot_->findings.begin(), robot_->findings.end());
  } else if (sentences.empty()) {
    sentences.push_back({Tone::Neutral, tr("Not chosen yet.")});
  }
  return together(sentences);
}

VerifySentence PlacePresenter::jointsInWords() const {
  if (!robot_ || !controller_.session()) return {};
  std::vector<VerifySentence> sentences;
  if (!joints_fault_.isEmpty()) sentences.push_back({Tone::Bad, joints_fault_});
  const std::map<PoseId, JointAngles> known = angles();
  const std::size_t poses = controller_.session()->poses().size();
  if (known.empty()) {
    sentences.push_back(
        {Tone::Caution,
         tr("No pose has joint angles, so that no link can be told. A link can be chosen all the same.")});
  } else {
    sentences.push_back({known.size() < poses ? Tone::Caution : Tone::Good,
                         tr("%1 of %2 poses have joint angles.").arg(known.size()).arg(poses)});
    std::vector<JointAngles> all;
    for (const auto& [pose, of_pose] : known) all.push_back(of_pose);
    const JointDoubts doubts = doubtsOf(robot_->model, all);
    if (doubts.probably_degrees) sentences.push_back({Tone::Bad, words(*doubts.probably_degrees)});
    for (const BeyondLimits& beyond : doubts.beyond_limits) sentences.push_back({Tone::Caution, words(beyond.message)});
  }
  if (links_) {
    for (const Message& finding : links_->findings) sentences.push_back({Tone::Caution, words(finding)});
  }
  return together(sentences);
}

VerifySentence PlacePresenter::linkSaid(const PatchReconstruction& patch) const {
  if (!links_fault_.isEmpty()) return {Tone::Bad, links_fault_};
  if (const PatchLinks* links = linksOf(patch)) return linkInWords(*links);
  if (links_) return {Tone::Caution, tr("This patch saw gravity in no pose that has joint angles.")};
  return {};
}

VerifySentence PlacePresenter::placesSaid() const {
  if (hand_.isHeld()) {
    const VerifySentence keys{
        Tone::Neutral, tr("Pull it by the mouse; or arrow keys slide it by 1 mm, Page Up and Page Down turn it by "
                          "1°, with Shift by ten times as much. Return lays it there, Escape leaves it where it "
                          "was.")};
    const std::optional<Message> objection = hand_.objection();
    return objection ? together({{Tone::Caution, words(*objection)}, keys}) : keys;
  }
  if (!places_fault_.isEmpty()) return {Tone::Bad, places_fault_};
  if (!places_) return {places_remark_.isEmpty() ? Tone::Neutral : Tone::Caution, places_remark_};
  const int row = preview_ >= 0 ? preview_ : std::max(0, rowOfPlace());
  VerifySentence said = placesInWords(*places_, static_cast<std::size_t>(row));
  if (!places_remark_.isEmpty()) said.text += QLatin1Char('\n') + places_remark_;
  return said;
}

void PlacePresenter::addChoices(PlaceStand& stand) const {
  for (const auto& [pose, of_pose] : angles()) {
    stand.poses.push_back({pose.value(), tr("Pose %1").arg(pose.value())});
  }
  if (stand.poses.empty()) stand.poses.push_back({0, tr("All joints at 0")});
  const auto is_there =
      std::ranges::any_of(stand.poses, [this](const PlaceStand::Choice& choice) { return choice.id == pose_; });
  stand.pose = is_there ? pose_ : stand.poses.front().id;
  for (const PatchReconstruction& of : solved_->patches) {
    if (of.cells.empty()) continue;
    QString text = of.cells.size() == 1 ? tr("Cell %1 alone").arg(of.origin.value())
                                        : tr("Patch of cell %1, %2 cells").arg(of.origin.value()).arg(of.cells.size());
    if (decided(of).place) text += QStringLiteral(" · ✓ ") + QString::fromStdString(linkOf(of));
    stand.patches.push_back({of.origin.value(), text});
  }
  stand.patch = patch_.value();
  if (!robot_) return;
  for (const RobotLink& link : robot_->model.links()) stand.other_links << QString::fromStdString(link.name);
}

void PlacePresenter::showStand() {
  PlaceStand stand;
  stand.why_not = whyNot();
  stand.has_robot = robot_ != nullptr;
  stand.names_robot = asked_.has_value();
  stand.robot = robotInWords();
  stand.joints = jointsInWords();
  stand.sheet = sheet();
  if (solved_) addChoices(stand);
  if (const PatchReconstruction* of = patch(); of != nullptr && robot_) {
    if (const PatchLinks* links = linksOf(*of)) stand.links = linkChoices(*links);
    const std::string link = linkOf(*of);
    stand.link = QString::fromStdString(link);
    stand.link_says = linkSaid(*of);
    const auto index = robot_->model.findLink(link);
    stand.has_surface = index && !(*robot_->bodies)[*index].empty();
    stand.known = decided(*of);
    stand.known_fault = known_fault_;
    stand.is_placed = stand.known.place.has_value();
    stand.place = rowOfPlace();
    if (places_) {
      for (std::size_t k = 0; k < places_->candidates.size(); ++k) {
        stand.places << placeInList(places_->candidates[k], k + 1, static_cast<int>(k) == stand.place);
      }
    }
    stand.place_says = placesSaid();
    if (!link.empty() && !index) {
      stand.link_says = {Tone::Bad, tr("The robot has no link %1, on which the patch was placed: choose another one, "
                                       "or the robot that it belongs to.")
                                        .arg(stand.link)};
    }
  }
  const RobotPicture drawn = picture();
  views_.robot.setPicture(drawn);
  lookAtWhatIsNew(drawn);
  stand.is_drawn = indexInPicture(drawn, patch()).has_value();
  stand.can_move = handle().has_value() && views_.robot.canDraw();
  views_.panel.setStand(stand);
}

RobotPicture PlacePresenter::picture() const {
  RobotPicture picture;
  if (!robot_) return picture;
  picture.bodies = robot_->bodies;
  picture.T_w_l = robot_->model.forward(shownAngles());
  if (!solved_) return picture;
  picture.skin = solved_;
  addPatches(picture);
  const PatchReconstruction* of = patch();
  if (of == nullptr) return picture;
  if (const auto link = robot_->model.findLink(linkOf(*of))) {
    picture.link = *link;
    for (const KnownPoint& point : decided(*of).points) picture.points.push_back({*link, point.x_l});
  }
  if (handle() && views_.steps.openIndex() == static_cast<int>(GuideStep::Place)) {
    picture.movable = indexInPicture(picture, of);
  }
  return picture;
}

/// The one that is pointed at, or chosen. Where nothing is chosen yet, the best place is what is proposed.
const PlaceCandidate* PlacePresenter::shownCandidate() const {
  if (!places_ || places_->candidates.empty()) return nullptr;
  const PatchReconstruction* of = patch();
  const int row = preview_ >= 0 ? preview_ : rowOfPlace();
  if (row < 0) return of != nullptr && !decided(*of).place ? &places_->candidates.front() : nullptr;
  const auto index = static_cast<std::size_t>(row);
  return index < places_->candidates.size() ? &places_->candidates[index] : nullptr;
}

void PlacePresenter::addPatches(RobotPicture& picture) const {
  const PlaceCandidate* candidate = shownCandidate();
  for (std::size_t k = 0; k < solved_->patches.size(); ++k) {
    const PatchReconstruction& drawn = solved_->patches[k];
    const bool is_held = hand_.isHeld() && hand_.origin() == drawn.origin;
    if (is_held || (lays_ && isPut(drawn))) {
      const PutPlace put = is_held ? hand_.place() : *put_;
      if (const auto link = robot_->model.findLink(put.link)) picture.patches.push_back({k, *link, put.T_l_o, true});
      continue;
    }
    const PlacedPatch* proposal = nullptr;
    if (candidate != nullptr) {
      const auto found = std::ranges::find_if(
          candidate->patches, [&](const PlacedPatch& placed) { return placed.place.origin == drawn.origin; });
      if (found != candidate->patches.end()) proposal = &*found;
    }
    const PatchPlacement placement = decided(drawn);
    if (proposal == nullptr && !placement.place) continue;
    const PatchOnLink& place = proposal != nullptr ? proposal->place : *placement.place;
    const auto link = robot_->model.findLink(place.link);
    if (!link) continue;
    const bool is_chosen = placement.place && isSamePlace(*placement.place, place);
    picture.patches.push_back({k, *link, place.T_l_o, !is_chosen});
    if (proposal == nullptr) continue;
    for (const FreeDirection& free : proposal->free) {
      if (!free.held_by_rotation) picture.free.push_back({picture.patches.back(), free});
    }
  }
}

/// In the step itself; and before the export where there is something to be seen of it: there it is looked at closely,
/// so that the cells' numbers can be compared with the skin.
/// The camera goes up to a patch when it is drawn on a link for the first time; after that it is the operator's.
void PlacePresenter::lookAtWhatIsNew(const RobotPicture& drawn) {
  const auto index = indexInPicture(drawn, patch());
  if (!index) return;
  const std::pair<CellId, std::size_t> seen{patch_, drawn.patches[*index].link};
  if (std::exchange(looked_at_, seen) != seen) views_.robot.lookAtSkin(index);
}

void PlacePresenter::showRobot() {
  const int open = views_.steps.openIndex();
  const bool opened = std::exchange(open_step_, open) != open;
  const bool placed = controller_.reconstruction() && !placedPatches(*controller_.reconstruction()).empty();
  const bool before_export = placed && open == static_cast<int>(GuideStep::Export);
  if (robot_ && before_export && opened) views_.robot.lookAtSkin();
  const bool shown = robot_ && (open == static_cast<int>(GuideStep::Place) || before_export);
  if (shown == views_.robot.isVisibleTo(views_.robot.parentWidget())) return;
  views_.robot.setVisible(shown);
  // Beneath, it would take the keyboard and not be seen.
  views_.middle.setVisible(!shown);
}

// --- by hand

std::optional<HandPlace::Where> PlacePresenter::handle() const {
  const PatchReconstruction* of = patch();
  if (!robot_ || of == nullptr || !controller_.session() || !decided(*of).by_surface) return std::nullopt;
  const auto link = robot_->model.findLink(linkOf(*of));
  if (!link || (*robot_->bodies)[*link].empty()) return std::nullopt;
  return HandPlace::Where{robot_, *link, solved_, links_, of->origin};
}

bool PlacePresenter::takeInHand() {
  if (hand_.isHeld()) return true;
  const auto where = handle();
  if (!where) return false;
  const PatchReconstruction* of = patch();
  const RobotPicture drawn = picture();
  const auto index = indexInPicture(drawn, of);
  std::optional<SE3> from;
  if (index && drawn.patches[*index].link == where->link) from = drawn.patches[*index].T_l_o;
  try {
    if (!hand_.isReadyFor(*where)) {
      PatchToPlace to_place = patchToPlace(*of);
      if (const PatchLinks* links = linksOf(*of)) to_place.rotation = rotationByGravity(*links, linkOf(*of));
      hand_.getReady(*where, to_place, solved_->model->thickness_m);
    }
    hand_.take(from);
  } catch (const InvalidArgument& error) {
    places_fault_ = words(error);
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
    put_ = hand_.place();
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

bool PlacePresenter::isPut(const PatchReconstruction& patch) const {
  return put_ && put_->origin == patch.origin && put_->link == linkOf(patch);
}

// --- decisions

void PlacePresenter::decide(std::vector<PatchPlacement> placements, const QString& text) {
  if (!controller_.session() || !solved_) return;
  known_fault_.clear();
  std::vector<SessionEdit> edits;
  try {
    for (PatchPlacement& placement : placements) {
      placement.validate();
      // What was decided when the patch had another origin cell is in it, moved to this one.
      const PatchReconstruction* of = patchOf(placement.origin);
      for (const PatchPlacement& other : controller_.session()->placements()) {
        if (other.origin == placement.origin || of == nullptr || of->findCell(other.origin) == nullptr) continue;
        PatchPlacement nothing;
        nothing.origin = other.origin;
        edits.emplace_back(SetPatchPlacement{nothing});
      }
      edits.emplace_back(SetPatchPlacement{std::move(placement)});
    }
  } catch (const InvalidArgument& error) {
    known_fault_ = words(error);
    showStand();
    return;
  }
  controller_.perform(edits, text);
  refresh();
}

void PlacePresenter::chooseLink(const QString& link) {
  const PatchReconstruction* of = patch();
  if (of == nullptr) return;
  PatchPlacement placement = decided(*of);
  const std::string name = link.toStdString();
  const PatchLinks* links = linksOf(*of);
  if (placement.link == name) return;
  // The only one that fits is no choice against others.
  const bool is_alone = links != nullptr && links->placed && !links->chosen && links->placed->link == name;
  if (is_alone && placement.link.empty()) return;
  if (linkOf(*of) != name) {
    // They are those of the link that was chosen before.
    placement.points.clear();
    placement.distances.clear();
    placement.place.reset();
  }
  placement.link = name;
  placement.link_chosen = !is_alone && !name.empty();
  decide({placement}, name.empty() ? tr("leave the link open") : tr("put the patch on link %1").arg(link));
}

void PlacePresenter::addPoint(const KnownPoint& point) {
  const PatchReconstruction* of = patch();
  if (of == nullptr) return;
  if (of->findCell(point.cell) == nullptr) {
    known_fault_ = tr("Cell %1 is none of this patch.").arg(point.cell.value());
    showStand();
    return;
  }
  PatchPlacement placement = decided(*of);
  placement.link = linkOf(*of);
  placement.points.push_back(point);
  decide({placement}, tr("add a known point"));
}

void PlacePresenter::addDistance(const KnownDistance& distance) {
  const PatchReconstruction* of = patch();
  if (of == nullptr) return;
  const PatchReconstruction* other = patchOf(distance.b);
  if (of->findCell(distance.a) == nullptr) {
    known_fault_ = tr("Cell %1 is none of this patch.").arg(distance.a.value());
  } else if (other == nullptr || other == of) {
    known_fault_ = tr("Cell %1 is of no other patch: inside a patch, distances are known.").arg(distance.b.value());
  } else if (linkOf(*other) != linkOf(*of)) {
    known_fault_ = tr("The patch of cell %1 is not on link %2: its distance depends on the joints.")
                       .arg(distance.b.value())
                       .arg(QString::fromStdString(linkOf(*of)));
  } else {
    PatchPlacement placement = decided(*of);
    placement.link = linkOf(*of);
    placement.distances.push_back(distance);
    decide({placement}, tr("add a measured distance"));
    return;
  }
  showStand();
}

void PlacePresenter::choosePlace(int row, const QString& text) {
  if (!places_ || row < 0 || static_cast<std::size_t>(row) >= places_->candidates.size()) return;
  if (row == rowOfPlace()) return;
  std::vector<PatchPlacement> placements;
  for (const PlacedPatch& placed : places_->candidates[static_cast<std::size_t>(row)].patches) {
    const PatchReconstruction* of = patchOf(placed.place.origin);
    if (of == nullptr) return;
    PatchPlacement placement = decided(*of);
    placement.link = placed.place.link;
    placement.place = placed.place;
    placements.push_back(std::move(placement));
  }
  decide(std::move(placements), text);
}

}  // namespace hexoderm
