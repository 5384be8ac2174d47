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

struct SphereFit {
  Eigen::Vector3d center;
  double radius_m = 0;
  std::vector<double> distance_m;
};

struct CylinderFit {
  Eigen::Vector3d point;  ///< on the axis, the foot of the points' centroid
  Eigen::Vector3d axis;   ///< unit
  double radius_m = 0;
  std::vector<double> distance_m;
};

/// At least 3 points not on a line; throws InvalidArgument otherwise.
PlaneFit fitPlane(std::span<const Eigen::Vector3d> points_m);

/// At least 4 points not in a plane; throws InvalidArgument otherwise (a plane is no sphere of finite radius).
SphereFit fitSphere(std::span<const Eigen::Vector3d> points_m);

/// At least 5 points that are not in a plane; throws InvalidArgument otherwise. Several starting axes are tried,
/// because the problem has local minima; the best is returned.
CylinderFit fitCylinder(std::span<const Eigen::Vector3d> points_m);

double rms(std::span<const double> values);

}  // namespace hexoderm
