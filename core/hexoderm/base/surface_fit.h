#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// A least-squares geometric fit of a plane, sphere, cylinder or cone: the sum of the squared orthogonal distances is
/// minimal. A cone is circular, and its surface is followed on past the apex, as if a plane rolled around it.
struct SurfaceFit {
  /// The sphere's centre; of the others the points' centroid, or its foot on the axis.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< the plane's normal; towards the wide end of a cone; unit
  double radius_m = 0;                              ///< the cone's at `point`
  double half_angle_rad = 0;                        ///< of a cone, between axis and surface, 0 (a cylinder) to pi/2
  /// Signed (outside the surface, or on the side of the normal, positive), one per point.
  std::vector<double> distance_m;
};

/// Takes at least 3 points not on a line; throws InvalidArgument otherwise.
SurfaceFit fitPlane(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 4 points not in a plane; throws InvalidArgument otherwise (a plane is no sphere of finite radius).
SurfaceFit fitSphere(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 5 points that are not in a plane; throws InvalidArgument otherwise. Several starting axes are tried,
/// because the problem has local minima; the best result is returned.
SurfaceFit fitCylinder(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 6 points that are not in a plane; throws InvalidArgument otherwise. Starts like fitCylinder(), from
/// cones and cylinders along many axes. Points of a cylinder give a half angle near 0.
SurfaceFit fitCone(std::span<const Eigen::Vector3d> points_m);

double rms(std::span<const double> values);  ///< the root of the mean square

}  // namespace hexoderm
