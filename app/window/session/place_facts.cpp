#include "app/window/session/place_facts.h"

#include "app/window/session/session_controller.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/solve/result/patch_placements.h"

#include <algorithm>

namespace hexoderm {

bool isSamePlace(const PatchOnLink& a, const PatchOnLink& b) {
  constexpr double kSame_m = 1e-4;
  constexpr double kSame_rad = 1e-3;
  return a.link == b.link && (a.T_l_o.t - b.T_l_o.t).norm() < kSame_m &&
         rotationAngle(a.T_l_o.R.transpose() * b.T_l_o.R) < kSame_rad;
}

const PatchReconstruction* PlaceFacts::patchOf(CellId cell) const {
  return solved ? solved->find(cell).patch : nullptr;
}

const PatchReconstruction* PlaceFacts::patch() const { return patchOf(spoken_of); }

const PatchLinks* PlaceFacts::linksOf(const PatchReconstruction& patch) const {
  if (!links) return nullptr;
  const auto found = std::ranges::find(links->patches, patch.origin, &PatchLinks::origin);
  return found == links->patches.end() ? nullptr : &*found;
}

PatchPlacement PlaceFacts::decided(const PatchReconstruction& patch) const {
  const PatchPlacement* placement =
      controller.reconstruction() ? placementOf(*controller.reconstruction(), patch) : nullptr;
  if (placement != nullptr) return *placement;
  PatchPlacement nothing;
  nothing.origin = patch.origin;
  return nothing;
}

std::string PlaceFacts::linkOf(const PatchReconstruction& patch) const {
  const PatchPlacement placement = decided(patch);
  if (!placement.link.empty()) return placement.link;
  const PatchLinks* on = linksOf(patch);
  return on != nullptr && on->placed ? on->placed->link : std::string();
}

std::map<PoseId, JointAngles> PlaceFacts::angles() const {
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

JointAngles PlaceFacts::shownAngles() const {
  const std::map<PoseId, JointAngles> known = angles();
  const auto found = known.find(PoseId(pose));
  if (found != known.end()) return found->second;
  return known.empty() ? JointAngles() : known.begin()->second;
}

JointSheet PlaceFacts::sheet() const {
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

std::vector<const PatchReconstruction*> PlaceFacts::placedWith(const PatchReconstruction& patch) const {
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

std::optional<PlaceTask> PlaceFacts::taskFor(const PatchReconstruction& patch) const {
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

int PlaceFacts::rowOfPlace() const {
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

bool PlaceFacts::isPut(const PatchReconstruction& patch) const {
  return put && put->origin == patch.origin && put->link == linkOf(patch);
}

}  // namespace hexoderm
