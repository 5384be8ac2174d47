#pragma once

#include "app/window/session/placing.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/mounting/place/by_hand.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/tables/joint_table.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// Whether two places of a patch can't be told apart: 0.1 mm and 0.06 degrees.
[[nodiscard]] inline bool isSamePlace(const PatchOnLink& a, const PatchOnLink& b) {
  constexpr double kSame_m = 1e-4;
  constexpr double kSame_rad = 1e-3;
  return a.link == b.link && (a.T_l_o.t - b.T_l_o.t).norm() < kSame_m &&
         rotationAngle(a.T_l_o.R.transpose() * b.T_l_o.R) < kSame_rad;
}

/// What went wrong in the step "Place on the robot", each where it is shown; empty: nothing did.
struct PlaceFaults {
  QString robot;
  QString joints;
  QString links;
  QString places;
  QString known;          ///< of points and distances
  QString places_remark;  ///< no fault: what was left out of the fit
};

/// What is known of the patches on the robot while the step "Place on the robot" is worked on: what was read and found,
/// beside what the session says was decided; and of which patch and pose the step speaks. The questions change nothing.
struct PlaceFacts {
  /// Nothing is known yet. The controller outlives this.
  explicit PlaceFacts(const SessionController& of) : controller(of) {}

  const SessionController& controller;
  std::shared_ptr<const Reconstruction> solved;
  std::shared_ptr<const LoadedRobot> robot;
  std::shared_ptr<const LinksResult> links;
  std::shared_ptr<const PlaceResult> places;  ///< of the patch that is spoken of
  CellId spoken_of{0};                        ///< the origin cell of the patch that the step is about
  quint32 pose = 0;                           ///< in which the robot is drawn
  int preview = -1;                           ///< the row of the place that is pointed at
  std::optional<PutPlace> put;                ///< where a patch was put by hand; the fit begins there too
  PlaceFaults faults;
  bool lays = false;  ///< what the fit makes of where it was put becomes its place

  /// The patch that the step is about; null: there is none.
  [[nodiscard]] const PatchReconstruction* patch() const { return patchOf(spoken_of); }

  [[nodiscard]] const PatchReconstruction* patchOf(CellId cell) const {
    return solved ? solved->find(cell).patch : nullptr;
  }

  [[nodiscard]] const PatchLinks* linksOf(const PatchReconstruction& patch) const {
    if (!links) return nullptr;
    const auto found = std::ranges::find(links->patches, patch.origin, &PatchLinks::origin);
    return found == links->patches.end() ? nullptr : &*found;
  }

  /// What is decided about a patch, as far as anything is.
  [[nodiscard]] PatchPlacement decided(const PatchReconstruction& patch) const {
    const PatchPlacement* placement =
        controller.reconstruction() ? placementOf(*controller.reconstruction(), patch) : nullptr;
    if (placement != nullptr) return *placement;
    PatchPlacement nothing;
    nothing.origin = patch.origin;
    return nothing;
  }

  /// The link that it is taken to be on: the decided one, or the only one that fits. Empty where it is open.
  [[nodiscard]] std::string linkOf(const PatchReconstruction& patch) const {
    const PatchPlacement placement = decided(patch);
    if (!placement.link.empty()) return placement.link;
    const PatchLinks* on = linksOf(patch);
    return on != nullptr && on->placed ? on->placed->link : std::string();
  }

  /// Of the poses that have any of a joint of this robot.
  [[nodiscard]] std::map<PoseId, JointAngles> angles() const {
    std::map<PoseId, JointAngles> known;
    if (!robot || !controller.session()) return known;
    for (const SessionPose& held : controller.session()->poses()) {
      JointAngles of_robot;
      for (const auto& [joint, position] : held.joint_angles.positions) {
        if (robot->model.findJoint(joint)) of_robot.positions[joint] = position;
      }
      if (!of_robot.positions.empty()) known.try_emplace(held.capture->id, std::move(of_robot));
    }
    return known;
  }

  [[nodiscard]] JointAngles shownAngles() const {
    const std::map<PoseId, JointAngles> known = angles();
    const auto found = known.find(PoseId(pose));
    if (found != known.end()) return found->second;
    return known.empty() ? JointAngles() : known.begin()->second;
  }

  [[nodiscard]] JointSheet sheet() const {
    JointSheet sheet;
    if (!robot || !controller.session()) return sheet;
    for (const RobotJoint& joint : robot->model.joints()) {
      if (joint.isFree()) sheet.joints.push_back(joint);
    }
    for (const SessionPose& held : controller.session()->poses()) {
      sheet.rows.push_back({held.capture->id, held.joint_angles});
    }
    return sheet;
  }

  /// The patches that are placed together with one, because distances join them: itself first.
  [[nodiscard]] std::vector<const PatchReconstruction*> placedWith(const PatchReconstruction& patch) const {
    std::vector<const PatchReconstruction*> patches{&patch};
    const std::string link = linkOf(patch);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      for (const PatchReconstruction& other : solved->patches) {
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

  /// What a place is looked for with; nullopt: nothing is known that could hold the patch.
  [[nodiscard]] std::optional<PlaceTask> taskFor(const PatchReconstruction& patch) const {
    const std::string link = linkOf(patch);
    const auto index = robot->model.findLink(link);
    if (!index) return std::nullopt;
    PlaceTask task;
    task.link = link;
    task.thickness_m = solved->model->thickness_m;
    const std::vector<const PatchReconstruction*> patches = placedWith(patch);
    bool by_surface = !(*robot->bodies)[*index].empty();
    for (const PatchReconstruction* of : patches) {
      const PatchPlacement placement = decided(*of);
      PatchToPlace to_place = patchToPlace(*of);
      if (const PatchLinks* on = linksOf(*of)) to_place.rotation = rotationByGravity(*on, link);
      if (isPut(*of)) to_place.start = put->T_l_o;
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
    if (by_surface) task.surface = (*robot->bodies)[*index];
    if (!task.surface && task.points.empty() && task.distances.empty()) return std::nullopt;
    return task;
  }

  /// The row of the place that was chosen; -1: the patch is at none of the places that were found.
  [[nodiscard]] int rowOfPlace() const {
    const PatchReconstruction* of = patch();
    if (of == nullptr || !places) return -1;
    const PatchPlacement placement = decided(*of);
    if (!placement.place) return -1;
    for (std::size_t row = 0; row < places->candidates.size(); ++row) {
      for (const PlacedPatch& placed : places->candidates[row].patches) {
        if (placed.place.origin == of->origin && isSamePlace(placed.place, *placement.place)) {
          return static_cast<int>(row);
        }
      }
    }
    return -1;
  }

  [[nodiscard]] bool isPut(const PatchReconstruction& patch) const {
    return put && put->origin == patch.origin && put->link == linkOf(patch);
  }
};

}  // namespace hexoderm
