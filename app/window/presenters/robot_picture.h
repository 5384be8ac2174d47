#pragma once

#include "app/window/session/place_facts.h"
#include "widgets/robot/robot_scene.h"

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

}  // namespace hexoderm
