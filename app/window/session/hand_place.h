#pragma once

#include "app/window/session/placing.h"
#include "hexoderm/mounting/place/by_hand.h"

#include <memory>
#include <optional>
#include <string>

namespace hexoderm {

/// Where a patch was put by hand, for the fit to begin there.
struct PutPlace {
  CellId origin;
  std::string link;
  SE3 T_l_o;
};

/// The patch that the operator has in the hand: from gripping it until it is laid or left alone.
class HandPlace {
 public:
  /// On which link and by what it is moved.
  struct Where {
    std::shared_ptr<const LoadedRobot> robot;
    std::size_t link = 0;
    std::shared_ptr<const Reconstruction> solved;
    std::shared_ptr<const LinksResult> links;
    CellId origin;
    friend bool operator==(const Where&, const Where&) = default;
  };

  /// Whether it was got ready for this patch on this link, and nothing that it is moved by has changed since.
  [[nodiscard]] bool isReadyFor(const Where& where) const { return by_hand_ && where_ == where; }
  /// Throws InvalidArgument where the link has no surface.
  void getReady(const Where& where, const PatchToPlace& patch, double thickness_m) {
    by_hand_.reset();
    by_hand_.emplace((*where.robot->bodies)[where.link], patch, thickness_m);
    where_ = where;
  }

  /// Once it is ready: takes the patch from its place, or from none.
  void take(const std::optional<SE3>& T_l_o) {
    held_ = Held{T_l_o ? *T_l_o : by_hand_->somewhere()};
    held_->moved = !T_l_o;
  }

  [[nodiscard]] bool isHeld() const { return held_.has_value(); }
  [[nodiscard]] CellId origin() const { return where_.origin; }

  // Of a patch that is held.

  [[nodiscard]] PutPlace place() const {
    return {where_.origin, where_.robot->model.links()[where_.link].name, held_->T_l_o};
  }

  [[nodiscard]] bool isMoved() const { return held_->moved; }
  [[nodiscard]] std::optional<Message> objection() const { return by_hand_->objection(held_->T_l_o); }
  /// From here on pullTo() pulls at this point of the patch, which is given in the link's frame.
  void grip(const Eigen::Vector3d& x_l) { held_->grip_o = held_->T_l_o.inverse() * x_l; }
  void pullTo(const Eigen::Vector3d& x_l) { moveTo(by_hand_->pulled(held_->T_l_o, held_->grip_o, x_l)); }
  void slide(const Eigen::Vector3d& way_l) { moveTo(by_hand_->slid(held_->T_l_o, way_l)); }
  void turn(double angle_rad) { moveTo(by_hand_->turned(held_->T_l_o, angle_rad)); }

  void letGo() { held_.reset(); }

 private:
  struct Held {
    SE3 T_l_o;
    Eigen::Vector3d grip_o = Eigen::Vector3d::Zero();
    bool moved = false;
  };
  void moveTo(const SE3& T_l_o) {
    held_->T_l_o = T_l_o;
    held_->moved = true;
  }

  Where where_;
  std::optional<PatchByHand> by_hand_;  ///< kept: getting a link's surface ready takes its time
  std::optional<Held> held_;
};

}  // namespace hexoderm
