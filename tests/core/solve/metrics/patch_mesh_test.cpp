#include "hexoderm/solve/metrics/patch_mesh.h"

#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(CellCorners, AreThePointsOfTheMesh) {
  const Reconstruction demo = demoReconstruction();
  const PatchMesh mesh = makePatchMesh(demo);
  EXPECT_EQ(cellCorners(demo, CellCorners::Prism), mesh.points);
  const auto front = cellCorners(demo, CellCorners::Front);
  ASSERT_EQ(front.size(), 6 * 17U);
  for (std::size_t cell = 0; cell < 17; ++cell) {
    const auto prism = prismCorners(*demo.model, demo.patches[0].cells[cell].T_o_u);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_EQ(front[6 * cell + k], mesh.points[12 * cell + k]);
      EXPECT_EQ(prism.at(k), mesh.points[12 * cell + k]);
      EXPECT_EQ(prism.at(k + 6), mesh.points[12 * cell + 6 + k]);
    }
  }
}

TEST(PatchMesh, PolygonsLookOutwards) {
  const PatchMesh mesh = makePatchMesh(demoReconstruction({.arm_cells = 0}));
  ASSERT_EQ(mesh.polygons.size(), 8U);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : mesh.points) middle += point / 12.0;
  for (const PatchMesh::Polygon& polygon : mesh.polygons) {
    const Eigen::Vector3d& a = mesh.points[polygon.points[0]];
    const Eigen::Vector3d normal = (mesh.points[polygon.points[1]] - a).cross(mesh.points[polygon.points[2]] - a);
    EXPECT_GT(normal.dot(a - middle), 0);
  }
}

}  // namespace
}  // namespace hexoderm
