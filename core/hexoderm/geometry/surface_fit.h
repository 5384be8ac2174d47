#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// Least-squares geometric fits: the sum of the squared orthogonal distances is minimal. Distances are signed
/// (outside the surface, or on the side of the normal, positive), metres, one per point.
struct PlaneFit {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< unit
  std::vector<double> distance_m;
};

/// The sphere that fits points best.
struct SphereFit {
  Eigen::Vector3d center;
  double radius_m = 0;
  std::vector<double> distance_m;
};

/// The cylinder that fits points best.
struct CylinderFit {
  Eigen::Vector3d point;  ///< on the axis, the foot of the points' centroid
  Eigen::Vector3d axis;   ///< unit
  double radius_m = 0;
  std::vector<double> distance_m;
};

/// A circular cone. Its surface is followed on past the apex, as if a plane rolled around it.
struct ConeFit {
  Eigen::Vector3d point;      ///< on the axis, the foot of the points' centroid
  Eigen::Vector3d axis;       ///< unit, towards the wide end
  double radius_m = 0;        ///< at `point`
  double half_angle_rad = 0;  ///< between axis and surface, 0 (a cylinder) to pi/2
  std::vector<double> distance_m;
};

/// Takes at least 3 points not on a line; throws InvalidArgument otherwise.
PlaneFit fitPlane(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 4 points not in a plane; throws InvalidArgument otherwise (a plane is no sphere of finite radius).
SphereFit fitSphere(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 5 points that are not in a plane; throws InvalidArgument otherwise. Several starting axes are tried,
/// because the problem has local minima; the best result is returned.
CylinderFit fitCylinder(std::span<const Eigen::Vector3d> points_m);

/// Takes at least 6 points that are not in a plane; throws InvalidArgument otherwise. Starts like fitCylinder(), from
/// cones and cylinders along many axes. Points of a cylinder give a half angle near 0.
ConeFit fitCone(std::span<const Eigen::Vector3d> points_m);

double rms(std::span<const double> values);  ///< the root of the mean square

}  // namespace hexoderm
