#pragma once

#include "app/window/presenters/place_sentences.h"
#include "app/window/presenters/robot_picture.h"
#include "app/window/session/place_facts.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/error.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/words/words.h"

#include <QObject>
#include <optional>

namespace hexoderm {

/// Moves the patch that the step "Place on the robot" is about by hand: takes it at the operator's word, moves it as
/// it is pulled in the view, and lays it for the fit to begin there.
class PlaceByHand : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlaceByHand(PlacePanel& panel, RobotView& view, const SessionController& controller, PlaceFacts& facts,
              PlaceFaults& faults)
      : panel_(panel), view_(view), controller_(controller), facts_(facts), faults_(faults) {
    connect(&panel_, &PlacePanel::movingChanged, this, [this](bool moving) {
      if (!moving) return lay();
      if (takeInHand()) {
        emit moved();
        view_.setMoving(true);
      } else {
        panel_.endMoving();
      }
    });
    connect(&view_, &RobotView::gripped, this, [this](const Eigen::Vector3d& x_l) {
      if (takeInHand()) moveInHand([&] { hand_.grip(x_l); });
    });
    connect(&view_, &RobotView::pulledTo, this,
            [this](const Eigen::Vector3d& x_l) { moveInHand([&] { hand_.pullTo(x_l); }); });
    connect(&view_, &RobotView::slid, this,
            [this](const Eigen::Vector3d& way_l) { moveInHand([&] { hand_.slide(way_l); }); });
    connect(&view_, &RobotView::turned, this, [this](double angle_rad) { moveInHand([&] { hand_.turn(angle_rad); }); });
    connect(&view_, &RobotView::released, this, &PlaceByHand::lay);
    connect(&view_, &RobotView::laid, this, &PlaceByHand::lay);
    connect(&view_, &RobotView::leftAlone, this, [this] {
      leaveAlone();
      emit moved();
    });
  }

  [[nodiscard]] const HandPlace& hand() const { return hand_; }
  /// By what the patch is moved by hand; nullopt: it can't be.
  [[nodiscard]] std::optional<HandPlace::Where> handle() const {
    const PatchReconstruction* of = facts_.patch();
    if (!facts_.robot || of == nullptr || !controller_.session() || !facts_.decided(*of).by_surface)
      return std::nullopt;
    const auto link = facts_.robot->model.findLink(facts_.linkOf(*of));
    if (!link || (*facts_.robot->bodies)[*link].empty()) return std::nullopt;
    return HandPlace::Where{facts_.robot, *link, facts_.solved, facts_.links, of->origin};
  }

  /// Leaves the patch alone if what it is moved by has changed.
  void follow() {
    if (!hand_.isHeld()) return;
    const auto where = handle();
    if (!where || !hand_.isReadyFor(*where)) leaveAlone();
  }

  void leaveAlone() {
    hand_.letGo();
    view_.setMoving(false);
    panel_.endMoving();
  }

 signals:
  /// The patch is elsewhere, or it could not be taken: it is to be shown anew.
  void moved();
  /// The facts say where the patch was put.
  void put();
  /// The patch is not held any more; before, put() came if it had been moved.
  void laid();

 private:
  /// Whether there is anything to be moved.
  bool takeInHand() {
    if (hand_.isHeld()) return true;
    const auto where = handle();
    if (!where) return false;
    const PatchReconstruction* of = facts_.patch();
    const RobotPicture drawn = robotPicture(facts_, hand_);
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
      emit moved();
      return false;
    }
    return true;
  }

  template <class Move>
  void moveInHand(Move move) {
    if (!hand_.isHeld()) return;
    move();
    emit moved();
  }

  /// It is to lie where it is: the fit begins there, and what comes of it becomes the place.
  void lay() {
    if (!hand_.isHeld()) return;
    if (hand_.isMoved()) {
      facts_.put = hand_.place();
      facts_.lays = true;
      emit put();
    }
    leaveAlone();
    emit laid();
  }

  PlacePanel& panel_;
  RobotView& view_;
  const SessionController& controller_;
  PlaceFacts& facts_;
  PlaceFaults& faults_;
  HandPlace hand_;
};

}  // namespace hexoderm
