#pragma once

#include "hexoderm/base/se3.h"

#include <memory>
#include <string_view>

namespace hexoderm {

/// The end of a walk along a geodesic.
struct GeodesicPoint {
  Eigen::Vector3d position;
  Eigen::Vector3d direction;  ///< unit tangent, forwards
};

/// A smooth surface that cells can be laid on. All coordinates are in the surface's own frame b (metres): the axis of a
/// cylinder, cone or torus is z, a sphere is about the origin, a plane is z = 0.
///
/// Positions given to the functions lie on the surface (`project` makes any point do so); normals point out of the
/// body.
class Surface {
 public:
  virtual ~Surface() = default;

  /// T_b_m of the place where the middle of a patch is laid: x around the body (+y of b), z the outward normal (+x of b
  /// on closed surfaces); on the plane the frame itself.
  [[nodiscard]] virtual SE3 middle() const = 0;
  /// The nearest point of the surface, for points near it.
  [[nodiscard]] virtual Eigen::Vector3d project(const Eigen::Vector3d& x) const = 0;
  /// The unit normal, outwards, where x is or above it.
  [[nodiscard]] virtual Eigen::Vector3d normal(const Eigen::Vector3d& x) const = 0;
  /// Weingarten map W: moving by dx along the surface turns the normal by dn = W dx. Symmetric, W n = 0; convex
  /// directions have positive curvature u^T W u.
  [[nodiscard]] virtual Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const = 0;
  /// Follows the geodesic that leaves `from` along the unit tangent `direction`.
  [[nodiscard]] virtual GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                           double length_m) const = 0;
  /// The inverse of `walk` for points less than half a turn apart: the tangent vector at `from` along which `to` is
  /// reached; its length is the distance along the surface.
  [[nodiscard]] virtual Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const = 0;
};

/// A surface from its description (metres, radians):
///   plane | cylinder:r=M | sphere:r=M | cone:r=M,angle=RAD | torus:R=M,r=M
/// A cone has radius r where the patch's middle lies, narrows towards +z, and `angle` is between axis and surface (0 to
/// pi/2); a torus has R > r, and patches lie on its outside. Throws InvalidArgument saying what was expected.
std::unique_ptr<Surface> makeSurface(std::string_view description);

}  // namespace hexoderm
