#pragma once

#include "hexoderm/base/triangle_mesh.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/place/place.h"

#include <memory>
#include <optional>

namespace hexoderm {

/// A patch that is moved over the surface of a link by hand: wherever it goes, the backs of its cells lie on the
/// surface and their z points along the outward normal, as well as a patch can that does not bend. Nothing is fitted
/// here; a place goes on to placePatches() as PatchToPlace::start. Places are T_l_o. Immutable; copies share the
/// surface.
class PatchByHand {
 public:
  /// `surface` in the link's frame; one that is inside out is taken the other way round. `back_m`: from a cell's front
  /// to the surface. Throws InvalidArgument for a mesh in which no triangle has an area, and a patch without cells.
  PatchByHand(TriangleMesh surface, const PatchToPlace& patch, double back_m);

  /// The place on the surface that is nearest, turned about the normal as the patch is.
  [[nodiscard]] SE3 laid(const SE3& T_l_o) const;
  /// A place to begin with where none is known: on the side of the link that gravity says, else on any, but on no end.
  [[nodiscard]] SE3 somewhere() const;
  /// Pulled by a point of the patch (in its frame) until that is over the point x_l of the link.
  [[nodiscard]] SE3 pulled(const SE3& T_l_o, const Eigen::Vector3d& grip_o, const Eigen::Vector3d& x_l) const;
  /// Slid along the surface, as far as `way_l` is long and where it points; where that is straight into the link or out
  /// of it, not at all.
  [[nodiscard]] SE3 slid(const SE3& T_l_o, const Eigen::Vector3d& way_l) const;
  /// Turned about the normal at its middle, counter-clockwise as seen from outside.
  [[nodiscard]] SE3 turned(const SE3& T_l_o, double angle_rad) const;
  /// What gravity says against a place, one sentence; nullopt where it says nothing against it.
  [[nodiscard]] std::optional<Message> objection(const SE3& T_l_o) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// How exactly patches are laid by hand, 1 sigma: what is turned by no more is not against gravity.
inline constexpr double kTurnByHand_rad = 4 * kDegree;

}  // namespace hexoderm
