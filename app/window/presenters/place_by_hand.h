#pragma once

#include "app/window/presenters/place_sentences.h"
#include "app/window/session/place_facts.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/error.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_scene.h"
#include "widgets/robot/robot_view.h"
#include "widgets/words/words.h"

#include <QObject>
#include <algorithm>
#include <cstddef>
#include <optional>

namespace hexoderm {

/// The one that is pointed at, or chosen. Where nothing is chosen yet, the best place is what is proposed.
inline const PlaceCandidate* shownCandidate(const PlaceFacts& facts) {
  if (!facts.places || facts.places->candidates.empty()) return nullptr;
  const PatchReconstruction* of = facts.patch();
  const int row = facts.preview >= 0 ? facts.preview : facts.rowOfPlace();
  if (row < 0) return of != nullptr && !facts.decided(*of).place ? &facts.places->candidates.front() : nullptr;
  const auto index = static_cast<std::size_t>(row);
  return index < facts.places->candidates.size() ? &facts.places->candidates[index] : nullptr;
}

inline void addPatches(const PlaceFacts& facts, const HandPlace& hand, RobotPicture& picture) {
  const PlaceCandidate* candidate = shownCandidate(facts);
  for (std::size_t k = 0; k < facts.solved->patches.size(); ++k) {
    const PatchReconstruction& drawn = facts.solved->patches[k];
    const bool is_held = hand.isHeld() && hand.origin() == drawn.origin;
    if (is_held || (facts.lays && facts.isPut(drawn))) {
      const PutPlace put = is_held ? hand.place() : *facts.put;
      if (const auto link = facts.robot->model.findLink(put.link))
        picture.patches.push_back({k, *link, put.T_l_o, true});
      continue;
    }
    const PlacedPatch* proposal = nullptr;
    if (candidate != nullptr) {
      const auto found = std::ranges::find_if(
          candidate->patches, [&](const PlacedPatch& placed) { return placed.place.origin == drawn.origin; });
      if (found != candidate->patches.end()) proposal = &*found;
    }
    const PatchPlacement placement = facts.decided(drawn);
    if (proposal == nullptr && !placement.place) continue;
    const PatchOnLink& place = proposal != nullptr ? proposal->place : *placement.place;
    const auto link = facts.robot->model.findLink(place.link);
    if (!link) continue;
    const bool is_chosen = placement.place && isSamePlace(*placement.place, place);
    picture.patches.push_back({k, *link, place.T_l_o, !is_chosen});
    if (proposal == nullptr) continue;
    for (const FreeDirection& free : proposal->free) {
      if (!free.held_by_rotation) picture.free.push_back({picture.patches.back(), free});
    }
  }
}

/// The robot as it stands in the shown pose, with the patches where they were placed, are proposed or are held; one
/// that was put by hand waits for its fit where it was put.
[[nodiscard]] inline RobotPicture robotPicture(const PlaceFacts& facts, const HandPlace& hand) {
  RobotPicture picture;
  if (!facts.robot) return picture;
  picture.bodies = facts.robot->bodies;
  picture.T_w_l = facts.robot->model.forward(facts.shownAngles());
  if (!facts.solved) return picture;
  picture.skin = facts.solved;
  addPatches(facts, hand, picture);
  const PatchReconstruction* of = facts.patch();
  if (of == nullptr) return picture;
  if (const auto link = facts.robot->model.findLink(facts.linkOf(*of))) {
    picture.link = *link;
    for (const KnownPoint& point : facts.decided(*of).points) picture.points.push_back({*link, point.x_l});
  }
  return picture;
}

/// Where a patch is among those of a picture; nullopt: it isn't drawn.
[[nodiscard]] inline std::optional<std::size_t> indexInPicture(const RobotPicture& picture,
                                                               const PatchReconstruction* patch) {
  for (std::size_t k = 0; patch != nullptr && k < picture.patches.size(); ++k) {
    if (&picture.skin->patches[picture.patches[k].patch] == patch) return k;
  }
  return std::nullopt;
}

/// Moves the patch that the step "Place on the robot" is about by hand: takes it at the operator's word, moves it as
/// it is pulled in the view, and lays it for the fit to begin there.
class PlaceByHand : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlaceByHand(PlacePanel& panel, RobotView& view, const SessionController& controller, PlaceFacts& facts)
      : panel_(panel), view_(view), controller_(controller), facts_(facts) {
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
      facts_.faults.places = words(error);
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
  HandPlace hand_;
};

}  // namespace hexoderm
