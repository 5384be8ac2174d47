#pragma once

// The surface that the links of a patch show.

#include "hexoderm/skin/cell_model.h"

#include <Eigen/Core>
#include <span>

namespace hexoderm {

/// What a link's angles are about: twist, bend and yaw, in this order.
inline constexpr int kTwist = 0;
inline constexpr int kBend = 1;
inline constexpr int kYaw = 2;

/// A link as the readings show it.
struct SeenLink {
  Eigen::Vector3d angles_rad;     ///< twist, bend and yaw
  Eigen::Vector3d variance_rad2;  ///< of the readings
  double heading_rad = 0;         ///< in the sheet laid flat
};

/// A patch's curvature, as the bend of one link, and how its links scatter about it.
struct PatchShape {
  Eigen::Vector4d parameters = Eigen::Vector4d::Zero();  ///< S_xx, S_yy, S_xy and the part that no surface has, rad
  double antisymmetric_sigma = 0;                        ///< of the last of these
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();       ///< scatter of twist, bend and yaw beyond the shape, rad

  /// Twist, bend and yaw of a link with this heading, rad.
  [[nodiscard]] Eigen::Vector3d anglesAt(double heading_rad) const;
};

/// The shape operator that fits most links, and the scatter about it. `with_antisymmetric`: a twist that is the same in
/// all directions, which belongs to no surface, is granted.
///
/// The scatter's variance is found by expectation maximisation: of each link's deviation from the shape, that part
/// counts as scatter which the errors of the readings and of the shape itself don't explain. A link that the readings
/// show poorly says little about it in this way, and leaves it to the model.
/// `near`: a shape that was found for the same links, to start from; null if there is none.
PatchShape fitPatchShape(const CellModel& model, std::span<const SeenLink> links, bool with_antisymmetric,
                         const PatchShape* near = nullptr);

}  // namespace hexoderm
