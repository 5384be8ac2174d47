#include "hexoderm/reconstruction/figures/surface_mesh.h"

#include "hexoderm/util/units.h"
#include "tests/support/matchers.h"
#include "tests/support/result_builder.h"

#include <cmath>

namespace hexoderm {
namespace {

const SE3 kElsewhere{expSO3({0.4, -1.1, 0.7}), {0.3, -0.2, 0.5}};

/// Cells at the given places, somewhere in space.
PatchReconstruction patchAt(const std::vector<Eigen::Vector3d>& places) {
  test::ResultBuilder builder;
  builder.patch(1);
  std::uint32_t id = 0;
  for (const Eigen::Vector3d& place : places) builder.cell(++id, {Eigen::Matrix3d::Identity(), kElsewhere * place});
  return builder.build().patches[0];
}

Eigen::Vector3d onCylinder(double angle_deg, double z, double radius) {
  return {radius * std::cos(angle_deg * kDegree), radius * std::sin(angle_deg * kDegree), z};
}

/// The grid's points in the frame in which the places were given.
std::vector<Eigen::Vector3d> localPoints(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3d> local;
  for (const Eigen::Vector3d& point : mesh.points) local.emplace_back(kElsewhere.inverse() * point);
  return local;
}

TEST(SurfaceMesh, CylinderReachesAroundTheCellsAndNotFurther) {
  std::vector<Eigen::Vector3d> places;
  for (const double angle : {150.0, 170.0, 190.0, 210.0}) {  // across the jump of atan2
    for (const double z : {-0.03, 0.0, 0.05}) places.push_back(onCylinder(angle, z, 0.05));
  }
  const PatchReconstruction patch = patchAt(places);
  const SurfaceMesh mesh = meshSurface(evaluateSurface(patch, SurfaceKind::Cylinder), patch, 0.005);
  ASSERT_EQ(mesh.points.size(), mesh.rows * mesh.columns);
  ASSERT_EQ(mesh.normals.size(), mesh.points.size());
  double low = 1;
  double high = -1;
  double widest = 0;
  for (const Eigen::Vector3d& p : localPoints(mesh)) {
    EXPECT_NEAR(p.head<2>().norm(), 0.05, 1e-6);
    low = std::min(low, p.z());
    high = std::max(high, p.z());
    widest = std::max(widest, std::abs(std::remainder(std::atan2(p.y(), p.x()) - kPi, 2 * kPi)));
  }
  EXPECT_NEAR(low, -0.035, 1e-6);
  EXPECT_NEAR(high, 0.055, 1e-6);
  EXPECT_NEAR(widest, 30 * kDegree + 0.1, 1e-6);
}

TEST(SurfaceMesh, CellsAllAroundCloseTheCylinder) {
  std::vector<Eigen::Vector3d> places;
  for (double angle = 0; angle < 360; angle += 30) {
    for (const double z : {0.0, 0.03}) places.push_back(onCylinder(angle, z, 0.05));
  }
  const PatchReconstruction patch = patchAt(places);
  const SurfaceMesh mesh = meshSurface(evaluateSurface(patch, SurfaceKind::Cylinder), patch, 0.02);
  EXPECT_LT((mesh.points.front() - mesh.points[mesh.columns - 1]).norm(), 1e-9);
}

TEST(SurfaceMesh, FeetLieOnTheSurfaceAtTheStatedDistance) {
  std::vector<Eigen::Vector3d> places;
  for (const double angle : {-40.0, -10.0, 15.0, 42.0, 60.0}) {
    for (const double z : {-0.03, 0.0, 0.05})
      places.push_back(onCylinder(angle, z, 0.05 + 0.001 * std::sin(angle + z)));
  }
  const PatchReconstruction patch = patchAt(places);
  for (const SurfaceKind kind : {SurfaceKind::Plane, SurfaceKind::Sphere, SurfaceKind::Cylinder}) {
    const SurfaceEvaluation evaluation = evaluateSurface(patch, kind);
    const SurfaceMesh mesh = meshSurface(evaluation, patch, 0.01);
    ASSERT_EQ(mesh.feet.size(), places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double length = (mesh.centers[k] - mesh.feet[k]).norm();
      EXPECT_NEAR(length, std::abs(evaluation.distance_m[k]), 1e-9) << surfaceKindName(kind);
      const Eigen::Vector3d from = mesh.feet[k] - evaluation.point;
      if (kind == SurfaceKind::Plane) {
        EXPECT_NEAR(from.dot(evaluation.axis), 0, 1e-9);
      } else if (kind == SurfaceKind::Sphere) {
        EXPECT_NEAR(from.norm(), *evaluation.radius_m, 1e-9);
      } else {
        EXPECT_NEAR(from.cross(evaluation.axis).norm(), *evaluation.radius_m, 1e-9);
      }
    }
  }
}

TEST(SurfaceMesh, SphereIsACapAboutTheCells) {
  std::vector<Eigen::Vector3d> places;
  for (const double tilt : {0.0, 10.0, 20.0}) {
    for (double around = 0; around < 360; around += 60) {
      places.emplace_back(0.08 * Eigen::Vector3d(std::sin(tilt * kDegree) * std::cos(around * kDegree),
                                                 std::sin(tilt * kDegree) * std::sin(around * kDegree),
                                                 std::cos(tilt * kDegree)));
    }
  }
  const PatchReconstruction patch = patchAt(places);
  const SurfaceMesh mesh = meshSurface(evaluateSurface(patch, SurfaceKind::Sphere), patch, 0.008);
  double reach = 0;
  for (const Eigen::Vector3d& p : localPoints(mesh)) {
    EXPECT_NEAR(p.norm(), 0.08, 1e-6);
    reach = std::max(reach, angleBetween(p, Eigen::Vector3d::UnitZ()));
  }
  EXPECT_NEAR(reach, 20 * kDegree + 0.1, 1e-4);
}

TEST(SurfaceMesh, ConeWidensAlongItsAxisAndEndsAtItsTip) {
  constexpr double kHalfAngle = 20 * kDegree;
  std::vector<Eigen::Vector3d> places;
  for (const double z : {0.01, 0.04, 0.08, 0.12}) {
    for (const double angle : {-50.0, -20.0, 10.0, 45.0})
      places.push_back(onCylinder(angle, z, z * std::tan(kHalfAngle)));
  }
  const PatchReconstruction patch = patchAt(places);
  const SurfaceEvaluation evaluation = evaluateSurface(patch, SurfaceKind::Cone);
  const SurfaceMesh mesh = meshSurface(evaluation, patch, 0.03);
  double low = 1;
  for (const Eigen::Vector3d& p : localPoints(mesh)) {
    EXPECT_NEAR(p.head<2>().norm(), p.z() * std::tan(kHalfAngle), 1e-5);
    low = std::min(low, p.z());
  }
  EXPECT_NEAR(low, 0, 1e-4) << "not beyond the tip";
}

TEST(SurfaceMesh, FeetOnAConeLieOnItAndSquareToIt) {
  constexpr double kHalfAngle = 20 * kDegree;
  std::vector<Eigen::Vector3d> places;
  for (const double z : {0.02, 0.04, 0.08, 0.12}) {
    // Off the cone by a millimetre at most, inwards and outwards.
    for (const double angle : {-50.0, -20.0, 10.0, 45.0})
      places.push_back(onCylinder(angle, z, z * std::tan(kHalfAngle) + 0.001 * std::sin(angle + 50 * z)));
  }
  const PatchReconstruction patch = patchAt(places);
  const SurfaceEvaluation evaluation = evaluateSurface(patch, SurfaceKind::Cone);
  ASSERT_TRUE(evaluation.half_angle_rad.has_value());
  EXPECT_NEAR(*evaluation.half_angle_rad, kHalfAngle, 2 * kDegree);
  const SurfaceMesh mesh = meshSurface(evaluation, patch, 0.03);
  ASSERT_EQ(mesh.feet.size(), places.size());
  const Eigen::Vector3d tip =
      evaluation.point - *evaluation.radius_m / std::tan(*evaluation.half_angle_rad) * evaluation.axis;
  double farthest = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::Vector3d from_tip = mesh.feet[k] - tip;
    EXPECT_NEAR(angleBetween(from_tip, evaluation.axis), *evaluation.half_angle_rad, 1e-7);
    const Eigen::Vector3d off = mesh.centers[k] - mesh.feet[k];
    EXPECT_NEAR(off.dot(from_tip.normalized()), 0, 1e-9) << "square to the line from the tip";
    EXPECT_NEAR(off.norm(), std::abs(evaluation.distance_m[k]), 1e-9);
    farthest = std::max(farthest, off.norm());
  }
  EXPECT_GT(farthest, 0.0003) << "the cells lie on the cone: nothing was shown";
}

TEST(SurfaceMesh, PlaneCoversTheCells) {
  const PatchReconstruction patch = patchAt({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.05, 0}, {0, 0.05, 0}});
  const SurfaceMesh mesh = meshSurface(evaluateSurface(patch, SurfaceKind::Plane), patch, 0.01);
  ASSERT_EQ(mesh.points.size(), 4U);
  for (const Eigen::Vector3d& p : localPoints(mesh)) EXPECT_NEAR(p.z(), 0, 1e-9);
  EXPECT_GT((mesh.points[0] - mesh.points[3]).norm(), 0.11);
}

TEST(SurfaceMesh, CellsThatAreGoneAreLeftOut) {
  PatchReconstruction patch = patchAt({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.05, 0}, {0, 0.05, 0}});
  const SurfaceEvaluation evaluation = evaluateSurface(patch, SurfaceKind::Plane);
  patch.cells.pop_back();
  EXPECT_EQ(meshSurface(evaluation, patch, 0.01).feet.size(), 3U);
  patch.cells.clear();
  EXPECT_TRUE(meshSurface(evaluation, patch, 0.01).points.empty());
}

}  // namespace
}  // namespace hexoderm
