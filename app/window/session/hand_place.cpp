#include "app/window/session/hand_place.h"

namespace hexoderm {

void HandPlace::getReady(const Where& where, const PatchToPlace& patch, double thickness_m) {
  by_hand_.reset();
  by_hand_.emplace((*where.robot->bodies)[where.link], patch, thickness_m);
  where_ = where;
}

void HandPlace::take(const std::optional<SE3>& T_l_o) {
  held_ = Held{T_l_o ? *T_l_o : by_hand_->somewhere()};
  held_->moved = !T_l_o;
}

PutPlace HandPlace::place() const {
  return {where_.origin, where_.robot->model.links()[where_.link].name, held_->T_l_o};
}

void HandPlace::grip(const Eigen::Vector3d& x_l) { held_->grip_o = held_->T_l_o.inverse() * x_l; }

void HandPlace::pullTo(const Eigen::Vector3d& x_l) { moveTo(by_hand_->pulled(held_->T_l_o, held_->grip_o, x_l)); }

void HandPlace::slide(const Eigen::Vector3d& way_l) { moveTo(by_hand_->slid(held_->T_l_o, way_l)); }

void HandPlace::turn(double angle_rad) { moveTo(by_hand_->turned(held_->T_l_o, angle_rad)); }

void HandPlace::moveTo(const SE3& T_l_o) {
  held_->T_l_o = T_l_o;
  held_->moved = true;
}

}  // namespace hexoderm
