#include "hexoderm/solve/result/patch_placements.h"

#include <algorithm>

namespace hexoderm {
namespace {

/// The same place, in the frame of a patch in which the cell that was the origin lies at T_new_old.
PatchOnLink inFrameOf(CellId origin, const PatchOnLink& old, const SE3& T_new_old) {
  const SE3 T_old_new = T_new_old.inverse();
  PatchOnLink place{origin, old.link, old.T_l_o * T_old_new, std::nullopt};
  if (!old.cov_t_r) return place;
  // t_l_new = t_l_old + R_l_old t_old_new moves by -R_l_old [t_old_new]x e, and R_l_new exp(R_new_old e) = R_l_old
  // exp(e) R_old_new.
  Matrix6d J = Matrix6d::Identity();
  J.topRightCorner<3, 3>() = -old.T_l_o.R * skew(T_old_new.t);
  J.bottomRightCorner<3, 3>() = T_new_old.R;
  const Matrix6d moved = J * *old.cov_t_r * J.transpose();
  place.cov_t_r = 0.5 * (moved + moved.transpose());
  return place;
}

}  // namespace

std::vector<PatchPlacement> placementsOf(const std::vector<PatchReconstruction>& patches,
                                         const std::vector<PatchPlacement>& of_session) {
  std::vector<PatchPlacement> placements;
  for (const PatchPlacement& decided : of_session) {
    const auto holds = [&](const PatchReconstruction& patch) { return patch.findCell(decided.origin) != nullptr; };
    const auto patch = std::ranges::find_if(patches, holds);
    if (patch == patches.end()) continue;
    const auto same = [&](const PatchPlacement& other) { return other.origin == patch->origin; };
    if (std::ranges::any_of(placements, same)) continue;
    PatchPlacement placement = decided;
    placement.origin = patch->origin;
    if (placement.place && decided.origin != patch->origin) {
      placement.place = inFrameOf(patch->origin, *placement.place, patch->findCell(decided.origin)->T_o_u);
    }
    placements.push_back(std::move(placement));
  }
  std::ranges::sort(placements, {}, &PatchPlacement::origin);
  return placements;
}

std::shared_ptr<const Reconstruction> withPlacements(const Reconstruction& result, const Session& session) {
  auto placed = std::make_shared<Reconstruction>(result);
  placed->robot = session.robot();
  placed->placements = placementsOf(placed->patches, session.placements());
  return placed;
}

const PatchPlacement* placementOf(const Reconstruction& result, const PatchReconstruction& patch) {
  const auto found = std::ranges::find(result.placements, patch.origin, &PatchPlacement::origin);
  return found == result.placements.end() ? nullptr : &*found;
}

std::vector<PatchOnLink> placedPatches(const Reconstruction& result) {
  std::vector<PatchOnLink> places;
  for (const PatchPlacement& placement : result.placements) {
    if (placement.place) places.push_back(*placement.place);
  }
  return places;
}

}  // namespace hexoderm
