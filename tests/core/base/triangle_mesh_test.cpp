#include "hexoderm/base/triangle_mesh.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// Every edge is shared by two triangles that run through it in opposite directions.
bool isClosed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> times;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++times[{t[k], t[(k + 1) % 3]}];
  }
  return std::ranges::all_of(times, [&](const auto& edge) {
    return edge.second == 1 && times.contains({edge.first.second, edge.first.first});
  });
}

TEST(TriangleMesh, ABoxIsClosedAndHasItsSizeAndVolume) {
  const TriangleMesh box = meshOfBox({0.1, 0.2, 0.3});
  EXPECT_TRUE(isClosed(box));
  EXPECT_TRUE(boundingBox(box).size().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_NEAR(enclosedVolume(box), 0.006, 1e-15);
}

TEST(TriangleMesh, RoundBodiesAreClosedAndALittleSmallerThanRound) {
  const TriangleMesh cylinder = meshOfCylinder(0.05, 0.2);
  EXPECT_TRUE(isClosed(cylinder));
  const double round = kPi * 0.05 * 0.05 * 0.2;
  EXPECT_LT(enclosedVolume(cylinder), round);
  EXPECT_GT(enclosedVolume(cylinder), 0.995 * round);

  const TriangleMesh sphere = meshOfSphere(0.05);
  EXPECT_TRUE(isClosed(sphere));
  const double ball = 4.0 / 3 * kPi * 0.05 * 0.05 * 0.05;
  EXPECT_LT(enclosedVolume(sphere), ball);
  EXPECT_GT(enclosedVolume(sphere), 0.99 * ball);
}

TEST(TriangleMesh, TurnsMovesAndJoins) {
  const SE3 T{rotationFromRpy({0.1, 0.2, 0.3}), {1, 2, 3}};
  TriangleMesh both = transformed(meshOfBox({0.1, 0.2, 0.3}), T);
  EXPECT_TRUE(both.points[0].isApprox(T * Eigen::Vector3d(-0.05, -0.1, -0.15)));
  append(both, meshOfSphere(0.05));
  EXPECT_TRUE(isClosed(both));
  EXPECT_NEAR(enclosedVolume(both), 0.006 + enclosedVolume(meshOfSphere(0.05)), 1e-12);
}

TEST(TriangleMesh, AnEmptyOneHasABoxWithoutSize) { EXPECT_EQ(boundingBox({}).size(), Eigen::Vector3d::Zero()); }

TEST(TriangleMesh, AMeshThatIsInsideOutIsNoticedAndTurned) {
  TriangleMesh mesh = meshOfBox({0.1, 0.2, 0.3});
  EXPECT_FALSE(isInsideOut(mesh));
  turnInsideOut(mesh);
  EXPECT_TRUE(isInsideOut(mesh));
  turnInsideOut(mesh);
  EXPECT_NEAR(enclosedVolume(mesh), 0.006, 1e-12);
  // A single sheet encloses nothing, whichever way it faces.
  mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 1}}};
  EXPECT_FALSE(isInsideOut(mesh));
  EXPECT_FALSE(isInsideOut({}));
}

}  // namespace
}  // namespace hexoderm
