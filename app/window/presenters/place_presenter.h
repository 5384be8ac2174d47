#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/place_by_hand.h"
#include "app/window/presenters/place_decisions.h"
#include "app/window/presenters/place_search.h"
#include "app/window/presenters/place_sentences.h"
#include "app/window/presenters/presenter.h"
#include "app/window/session/place_facts.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/robot/place_words.h"

#include <QDir>
#include <QFileInfo>
#include <QString>
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The step "Place on the robot": asks for the robot and its joint angles, has links and places found for what the
/// session holds, and writes the operator's decisions into it. The robot takes the place of the patch in the middle of
/// the window while this step is open.
class PlacePresenter : public Presenter {
  Q_OBJECT

 public:
  PlacePresenter(const WindowParts& parts, Placing& placing)
      : Presenter(parts),
        placing_(placing),
        facts_(controller),
        search_(controller, placing, facts_),
        by_hand_(*views.place_panel, *views.robot, controller, facts_),
        sentences_(facts_),
        decisions_(controller, facts_) {
    connectPanel();
    connectWork();
    connectEdits();
    connect(views.steps, &StepPanel::opened, this, [this] {
      showStand();
      showRobot();
    });
    connect(&controller, &SessionController::opened, this, [this] {
      joints_file_.clear();
      facts_.faults = {};
      facts_.pose = 0;
      facts_.spoken_of = CellId(0);
      looked_at_.reset();
      by_hand_.leaveAlone();
      facts_.put.reset();
      facts_.lays = false;
    });
  }

  /// The session was solved anew.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    facts_.solved = std::move(reconstruction);
    if (!facts_.solved) {
      facts_.links.reset();
      search_.forgetPlaces();
    }
  }

  void refresh() {
    search_.followRobot();
    if (facts_.patch() == nullptr && facts_.solved) {
      const PatchReconstruction* largest = largestPatch(*facts_.solved);
      facts_.spoken_of = largest != nullptr ? largest->origin : CellId(0);
      search_.forgetPlaces();
    }
    by_hand_.follow();
    search_.findLinks();
    search_.findPlaces();
    showStand();
    showRobot();
  }

  /// A URDF or a table of joint angles that was dropped onto the window; false: it is neither, or nothing can be
  /// placed.
  bool takeFile(const QString& path) {
    const QString ending = endingOf(path);
    const bool is_robot = ending == QStringLiteral("urdf");
    const bool is_table = ending == QStringLiteral("csv") || ending == QStringLiteral("tsv");
    if ((!is_robot && !is_table) || !whyNot().isEmpty()) return false;
    views.steps->openStep(static_cast<int>(GuideStep::Place));
    if (is_robot) {
      pickRobot({path.toStdString(), {}, {}});
    } else if (facts_.robot) {
      readJoints(path);
    } else {
      facts_.faults.joints = tr("Choose the robot first: its joints have the names of the columns.");
      facts_.faults.robot = facts_.faults.joints;
      showStand();
    }
    return true;
  }

 private:
  void connectPanel() {
    PlacePanel* panel = views.place_panel;
    connect(panel, &PlacePanel::robotWanted, this, &PlacePresenter::askForRobot);
    connect(panel, &PlacePanel::packageWanted, this, &PlacePresenter::askForPackage);
    connect(panel, &PlacePanel::jointsWanted, this, &PlacePresenter::askForJoints);
    connect(panel, &PlacePanel::anglesTyped, this, &PlacePresenter::setAngles);
    connect(panel, &PlacePanel::anglesRefused, this, [this](const QString& why) {
      facts_.faults.joints = why;
      showStand();
    });
    connect(panel, &PlacePanel::cancelRequested, this, [this](PlaceWork work) {
      placing_.cancel(work);
      if (work == PlaceWork::Robot) search_.dropPickedRobot();
      if (work == PlaceWork::Links) facts_.faults.links = tr("Cancelled.");
      if (work == PlaceWork::Places) {
        facts_.faults.places = tr("Cancelled.");
        facts_.lays = false;
      }
      refresh();
    });
    connect(panel, &PlacePanel::poseChosen, this, [this](quint32 pose) {
      facts_.pose = pose;
      refresh();
    });
    connect(panel, &PlacePanel::patchChosen, this, [this](quint32 origin) {
      facts_.spoken_of = CellId(origin);
      facts_.faults.known.clear();
      by_hand_.leaveAlone();
      facts_.put.reset();
      facts_.lays = false;
      search_.forgetPlaces();
      refresh();
    });
    connect(panel, &PlacePanel::placePreviewed, this, [this](int row) {
      if (std::exchange(facts_.preview, row) != row) showStand();
    });
    connect(panel, &PlacePanel::lookWanted, this,
            [this] { views.robot->lookAtSkin(indexInPicture(picture(), facts_.patch())); });
    connect(panel, &PlacePanel::pickingChanged, views.robot, &RobotView::setPicking);
    connect(views.robot, &RobotView::pointPicked, panel, [this](std::size_t link, const Eigen::Vector3d& x_l) {
      const PatchReconstruction* of = facts_.patch();
      if (!facts_.robot || of == nullptr) return;
      const std::string& name = facts_.robot->model.links()[link].name;
      if (name == facts_.linkOf(*of)) {
        facts_.faults.known.clear();
        views.place_panel->proposePoint(x_l);
      } else {
        facts_.faults.known = tr("This point is on link %1, and the patch on %2: pick a point of that link.")
                                  .arg(QString::fromStdString(name), QString::fromStdString(facts_.linkOf(*of)));
      }
      showStand();
    });
  }

  void connectWork() {
    connect(&placing_, &Placing::runningChanged, views.place_panel, &PlacePanel::setRunning);
    connect(&placing_, &Placing::jointsRead, this, [this](const LoadedJoints& joints) {
      facts_.faults.joints.clear();
      joints_file_ = joints.file;
      std::vector<SessionEdit> edits;
      // Poses may have gone while the file was read.
      const std::size_t poses = controller.session() ? controller.session()->poses().size() : 0;
      for (const SetJointAngles& edit : joints.edits) {
        if (edit.index < poses) edits.emplace_back(edit);
      }
      if (edits.empty()) {
        facts_.faults.joints = tr("%1 has no line for any pose of this session.").arg(joints.file);
      } else {
        controller.perform(edits, tr("read the joint angles of %1").arg(joints.file));
      }
      refresh();
    });
    connect(&placing_, &Placing::failed, this, [this](PlaceWork work, const QString& message) {
      if (work != PlaceWork::Joints) return;
      facts_.faults.joints = message;
      refresh();
    });
    connect(&search_, &PlaceSearch::changed, this, &PlacePresenter::refresh);
    connect(&search_, &PlaceSearch::placesFound, this, [this] {
      if (std::exchange(facts_.lays, false)) {
        const auto laid = std::ranges::find(facts_.places->candidates, true, &PlaceCandidate::by_hand);
        if (laid != facts_.places->candidates.end()) {
          facts_.faults.known = decisions_.choosePlace(static_cast<int>(laid - facts_.places->candidates.begin()),
                                                       tr("move the patch by hand"));
        }
      }
      refresh();
    });
    connect(&by_hand_, &PlaceByHand::moved, this, &PlacePresenter::showStand);
    connect(&by_hand_, &PlaceByHand::put, &search_, &PlaceSearch::askForPlacesAgain);
    connect(&by_hand_, &PlaceByHand::laid, this, &PlacePresenter::refresh);
  }

  void connectEdits() {
    PlacePanel* panel = views.place_panel;
    connect(panel, &PlacePanel::robotRemoved, this, [this] {
      if (controller.session()) controller.perform({SetRobot{}});
    });
    connect(panel, &PlacePanel::linkChosen, this, [this](const QString& link) { take(decisions_.chooseLink(link)); });
    connect(panel, &PlacePanel::surfaceChosen, this,
            [this](bool by_surface) { take(decisions_.useSurface(by_surface)); });
    connect(panel, &PlacePanel::pointAdded, this,
            [this](const KnownPoint& point) { take(decisions_.addPoint(point)); });
    connect(panel, &PlacePanel::pointRemoved, this, [this](int index) { take(decisions_.removePoint(index)); });
    connect(panel, &PlacePanel::distanceAdded, this,
            [this](const KnownDistance& distance) { take(decisions_.addDistance(distance)); });
    connect(panel, &PlacePanel::distanceRemoved, this, [this](int index) { take(decisions_.removeDistance(index)); });
    connect(panel, &PlacePanel::placeChosen, this,
            [this](int row) { take(decisions_.choosePlace(row, tr("place the patch"))); });
    connect(panel, &PlacePanel::placeRemoved, this, [this] { take(decisions_.takeAway()); });
  }

  void askForRobot() {
    askToRead("robotDialog", tr("Choose the robot's URDF"), tr("Robots (*.urdf *.xml);;All files (*)"),
              [this](const QString& path) {
                pickRobot({path.toStdString(), {}, {}});
              });
  }

  void askForPackage() {
    askForFile(
        &window, "packageDialog", tr("The folder of a package"), lastFolder(), {}, this,
        [this](const QString& path) {
          if (!facts_.robot) return;
          RobotDescription description = facts_.robot->description;
          description.sha256.clear();
          description.packages[QDir(path).dirName().toStdString()] = path.toStdString();
          pickRobot(description);
        },
        QFileDialog::Directory);
  }

  void askForJoints() {
    askToRead("jointsDialog", tr("Choose a table of joint angles"), tr("Tables (*.csv *.tsv *.txt);;All files (*)"),
              [this](const QString& path) { readJoints(path); });
  }

  void pickRobot(const RobotDescription& description) {
    search_.pickRobot(description);
    showStand();
  }

  void readJoints(const QString& path) {
    facts_.faults.joints.clear();
    if (!facts_.robot || !controller.session()) return;
    placing_.readJoints(path, facts_.robot, *controller.session());
  }

  void setAngles(const std::vector<TypedAngle>& angles) {
    if (!controller.session()) return;
    facts_.faults.joints.clear();
    const std::vector<SessionPose>& poses = controller.session()->poses();
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
    controller.perform(edits, edits.size() > 1 ? tr("set joint angles of %1 poses").arg(edits.size()) : QString());
    refresh();
  }

  void showStand() {
    PlaceStand stand;
    stand.why_not = whyNot();
    stand.has_robot = facts_.robot != nullptr;
    stand.names_robot = search_.namesRobot();
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
      stand.known_fault = facts_.faults.known;
      stand.is_placed = stand.known.place.has_value();
      stand.place = facts_.rowOfPlace();
      if (facts_.places) {
        for (std::size_t k = 0; k < facts_.places->candidates.size(); ++k) {
          stand.places << placeInList(facts_.places->candidates[k], k + 1, static_cast<int>(k) == stand.place);
        }
      }
      stand.place_says = by_hand_.hand().isHeld() ? PlaceSentences::hand(by_hand_.hand()) : sentences_.places();
      if (!link.empty() && !index) {
        stand.link_says = {Tone::Bad, tr("The robot has no link %1, on which the patch was placed: choose another one, "
                                         "or the robot that it belongs to.")
                                          .arg(stand.link)};
      }
    }
    const RobotPicture drawn = picture();
    views.robot->setPicture(drawn);
    lookAtWhatIsNew(drawn);
    stand.is_drawn = indexInPicture(drawn, facts_.patch()).has_value();
    stand.can_move = by_hand_.handle().has_value() && views.robot->canDraw();
    views.place_panel->setStand(stand);
  }

  /// In the step itself; and before the export where there is something to be seen of it: there it is looked at
  /// closely, so that the cells' numbers can be compared with the skin.
  void showRobot() {
    const int open = views.steps->openIndex();
    const bool opened = std::exchange(open_step_, open) != open;
    const bool placed = controller.reconstruction() && !placedPatches(*controller.reconstruction()).empty();
    const bool before_export = placed && open == static_cast<int>(GuideStep::Export);
    if (facts_.robot && before_export && opened) views.robot->lookAtSkin();
    const bool shown = facts_.robot && (open == static_cast<int>(GuideStep::Place) || before_export);
    if (shown == views.robot->isVisibleTo(views.robot->parentWidget())) return;
    views.robot->setVisible(shown);
    // Beneath, it would take the keyboard and not be seen.
    panels.middle().setVisible(!shown);
  }

  /// The camera goes up to a patch when it is drawn on a link for the first time; after that it is the operator's.
  void lookAtWhatIsNew(const RobotPicture& drawn) {
    const auto index = indexInPicture(drawn, facts_.patch());
    if (!index) return;
    const std::pair<CellId, std::size_t> seen{facts_.spoken_of, drawn.patches[*index].link};
    if (std::exchange(looked_at_, seen) != seen) views.robot->lookAtSkin(index);
  }

  [[nodiscard]] QString whyNot() const {
    if (!controller.reconstruction()) {
      const QString awaited = describeAwaited(controller);
      return awaited.isEmpty() ? tr("There is no skin yet.") : awaited;
    }
    if (!controller.session()) return tr("A calibration is open: it holds the result, not the poses.");
    return {};
  }

  [[nodiscard]] RobotPicture picture() const {
    RobotPicture picture = robotPicture(facts_, by_hand_.hand());
    if (by_hand_.handle() && views.steps->openIndex() == static_cast<int>(GuideStep::Place)) {
      picture.movable = indexInPicture(picture, facts_.patch());
    }
    return picture;
  }

  /// What became of a decision is shown.
  void take(const QString& fault) {
    facts_.faults.known = fault;
    refresh();
  }

  Placing& placing_;
  PlaceFacts facts_;
  PlaceSearch search_;
  PlaceByHand by_hand_;
  PlaceSentences sentences_;
  PlaceDecisions decisions_;
  QString joints_file_;  ///< of the last table that was read
  int open_step_ = -1;   ///< as showRobot() last saw it
  /// The patch, by its origin cell, and the link that the camera went up to last.
  std::optional<std::pair<CellId, std::size_t>> looked_at_;

  static QString endingOf(const QString& path) { return QFileInfo(path).suffix().toLower(); }
};

}  // namespace hexoderm
