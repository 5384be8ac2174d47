#include "hexoderm/base/mesh_feet.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

SE3 near(double x, double y, double z, const Eigen::Vector3d& rpy = Eigen::Vector3d::Zero()) {
  return {rotationFromRpy(rpy), {x, y, z}};
}

TEST(MeshSurface, OnTheFaceOfABoxEverythingIsPlane) {
  const MeshSurface box(meshOfBox({0.2, 0.2, 0.2}), near(0.01, 0.02, 0.3), 0.005);
  const SE3 middle = box.middle();
  EXPECT_LT((middle.t - Eigen::Vector3d(0.01, 0.02, 0.105)).norm(), 1e-12);
  EXPECT_LT((middle.R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_LT(box.weingarten(middle.t).norm(), 1e-9);
  const Eigen::Vector3d direction(0.6, -0.8, 0);
  const GeodesicPoint end = box.walk(middle.t, direction, 0.05);
  EXPECT_LT((end.position - middle.t - 0.05 * direction).norm(), 1e-9);
  EXPECT_LT((end.direction - direction).norm(), 1e-9);
  EXPECT_LT((box.bearing(middle.t, end.position) - 0.05 * direction).norm(), 1e-6);
}

TEST(MeshSurface, AnEdgeOfABoxIsNotRounded) {
  const MeshSurface box(meshOfBox({0.2, 0.2, 0.2}), near(0, 0, 0.1));
  EXPECT_LT((box.normal({0.099, 0, 0.1}) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((box.normal({0.1, 0, 0.099}) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(MeshSurface, FollowsACylinderAsTheRoundOneDoes) {
  const double r = 0.05;
  const MeshSurface mesh(meshOfCylinder(r, 0.4), near(0.06, 0, 0, {0, 0, kPi / 2}), 0.005);
  const auto round = makeSurface("cylinder:r=0.055");
  const SE3 middle = mesh.middle();
  EXPECT_LT((middle.t - round->middle().t).norm(), 2e-4);
  // The curvature around, and none along, within what 48 corners leave.
  const Eigen::Matrix3d W = mesh.weingarten(middle.t);
  EXPECT_NEAR(Eigen::Vector3d::UnitY().dot(W * Eigen::Vector3d::UnitY()), 1 / 0.055, 0.1 / 0.055);
  EXPECT_NEAR(Eigen::Vector3d::UnitZ().dot(W * Eigen::Vector3d::UnitZ()), 0, 0.2);
  const Eigen::Vector3d direction = Eigen::Vector3d(0, 1, 1).normalized();
  const GeodesicPoint end = mesh.walk(middle.t, direction, 0.12);
  const GeodesicPoint expected = round->walk(round->middle().t, direction, 0.12);
  EXPECT_LT((end.position - expected.position).norm(), 1e-3);
  EXPECT_LT(angleBetween(end.direction, expected.direction), 2 * kDegree);
  EXPECT_LT(angleBetween(mesh.normal(end.position), round->normal(expected.position)), 2 * kDegree);
}

TEST(MeshSurface, ProjectsBackToItselfAtAHeight) {
  const MeshSurface mesh(meshOfSphere(0.06), near(0.05, 0.02, 0.01), 0.005);
  const Eigen::Vector3d x = mesh.project({0.05, 0.02, 0.04});
  EXPECT_LT((mesh.project(x) - x).norm(), 1e-6);
  EXPECT_NEAR(x.norm(), 0.065, 3e-4);
}

TEST(MeshSurface, RefusesWhatIsNoPlaceForAPatch) {
  EXPECT_THROW(MeshSurface({}, near(0, 0, 0)), InvalidArgument);
  EXPECT_THROW(MeshSurface({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}, near(0, 0, 0)), InvalidArgument);
  EXPECT_THROW(MeshSurface(meshOfBox({1, 1, 1}), near(0, 0, 1), -0.1), InvalidArgument);
  EXPECT_THROW(MeshSurface(meshOfBox({1, 1, 1}), near(0, 0, 1, {0, kPi / 2, 0})), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
