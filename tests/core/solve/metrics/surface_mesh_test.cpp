#include "hexoderm/solve/metrics/surface_mesh.h"

#include "hexoderm/base/units.h"
#include "tests/support/matchers.h"
#include "tests/support/result_builder.h"
#include "tests/support/testing.h"

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

/// Cells at all of these angles about z and heights; `radius` is that of an angle and a height.
PatchReconstruction patchAround(
    const std::vector<double>& angles_deg, const std::vector<double>& heights,
    const std::function<double(double angle_deg, double z)>& radius = [](double, double) { return 0.05; }) {
  std::vector<Eigen::Vector3d> places;
  for (const double z : heights) {
    for (const double angle : angles_deg) {
      const double r = radius(angle, z);
      places.emplace_back(r * std::cos(angle * kDegree), r * std::sin(angle * kDegree), z);
    }
  }
  return patchAt(places);
}

/// The grid's points in the frame in which the places were given.
std::vector<Eigen::Vector3d> localPoints(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3d> local;
  for (const Eigen::Vector3d& point : mesh.points) local.emplace_back(kElsewhere.inverse() * point);
  return local;
}

TEST(SurfaceMesh, CylinderReachesAroundTheCellsAndNotFurther) {
  const PatchReconstruction patch = patchAround({150, 170, 190, 210}, {-0.03, 0, 0.05});  // across the jump of atan2
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
  const PatchReconstruction patch = patchAround({0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330}, {0, 0.03});
  const SurfaceMesh mesh = meshSurface(evaluateSurface(patch, SurfaceKind::Cylinder), patch, 0.02);
  EXPECT_LT((mesh.points.front() - mesh.points[mesh.columns - 1]).norm(), 1e-9);
}

/// From the surface to a point, along its normal; a cylinder is a cone whose lines don't spread.
double heightOver(const SurfaceEvaluation& surface, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from = point - surface.point;
  if (surface.kind == SurfaceKind::Plane) return from.dot(surface.axis);
  if (surface.kind == SurfaceKind::Sphere) return from.norm() - *surface.radius_m;
  const double half_angle_rad = surface.half_angle_rad.value_or(0);
  return (from.cross(surface.axis).norm() - *surface.radius_m) * std::cos(half_angle_rad) -
         from.dot(surface.axis) * std::sin(half_angle_rad);
}

TEST(SurfaceMesh, FeetLieOnTheSurfaceAtTheStatedDistance) {
  // Off a cylinder by a millimetre at most, or off a cone, inwards and outwards.
  const PatchReconstruction round = patchAround({-40, -10, 15, 42, 60}, {-0.03, 0, 0.05}, [](double angle, double z) {
    return 0.05 + 0.001 * std::sin(angle + z);
  });
  const PatchReconstruction tapered =
      patchAround({-50, -20, 10, 45}, {0.02, 0.04, 0.08, 0.12},
                  [](double angle, double z) { return z * std::tan(20 * kDegree) + 0.001 * std::sin(angle + 50 * z); });
  for (const SurfaceKind kind : {SurfaceKind::Plane, SurfaceKind::Sphere, SurfaceKind::Cylinder, SurfaceKind::Cone}) {
    SCOPED_TRACE(surfaceKindName(kind));
    const PatchReconstruction& patch = kind == SurfaceKind::Cone ? tapered : round;
    const SurfaceEvaluation evaluation = evaluateSurface(patch, kind);
    const SurfaceMesh mesh = meshSurface(evaluation, patch, 0.01);
    ASSERT_EQ(mesh.feet.size(), patch.cells.size());
    double farthest = 0;
    for (std::size_t k = 0; k < mesh.feet.size(); ++k) {
      const double length = (mesh.centers[k] - mesh.feet[k]).norm();
      EXPECT_NEAR(length, std::abs(evaluation.distance_m[k]), 1e-9);
      EXPECT_NEAR(heightOver(evaluation, mesh.feet[k]), 0, 1e-9);
      farthest = std::max(farthest, length);
    }
    EXPECT_GT(farthest, 0.0003) << "the cells lie on it: nothing was shown";
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
  const PatchReconstruction patch = patchAround({-50, -20, 10, 45}, {0.01, 0.04, 0.08, 0.12},
                                                [](double, double z) { return z * std::tan(kHalfAngle); });
  const SurfaceEvaluation evaluation = evaluateSurface(patch, SurfaceKind::Cone);
  const SurfaceMesh mesh = meshSurface(evaluation, patch, 0.03);
  double low = 1;
  for (const Eigen::Vector3d& p : localPoints(mesh)) {
    EXPECT_NEAR(p.head<2>().norm(), p.z() * std::tan(kHalfAngle), 1e-5);
    low = std::min(low, p.z());
  }
  EXPECT_NEAR(low, 0, 1e-4) << "not beyond the tip";
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
