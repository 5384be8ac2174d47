#include "hexoderm/solve/metrics/patch_sides.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// Cells about a cylinder along `axis`, all around or over a part of the turn.
PatchReconstruction around(const Eigen::Vector3d& axis, double turn_rad, std::size_t count, std::size_t rows = 3) {
  PatchReconstruction patch;
  const Eigen::Vector3d across = axis.unitOrthogonal();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = turn_rad * static_cast<double>(k) / static_cast<double>(count);
      const Eigen::Vector3d normal = std::cos(angle) * across + std::sin(angle) * axis.cross(across);
      CellPlacement cell;
      cell.cell = CellId(static_cast<std::uint32_t>(row * count + k + 1));
      cell.T_o_u.R << axis.cross(normal), axis, normal;
      cell.T_o_u.t = 0.05 * normal + 0.02 * static_cast<double>(row) * axis;
      patch.cells.push_back(cell);
    }
  }
  patch.origin = patch.cells.front().cell;
  return patch;
}

TEST(PatchSides, AreFourTurnsAboutOneAxis) {
  const PatchSides sides = patchSides(demoReconstruction().patches.front());
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Matrix3d& R = sides.R_v_o.at(k);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(R.determinant(), 1, 1e-12);
    EXPECT_LT((R.row(1) - sides.R_v_o[0].row(1)).norm(), 1e-12) << "up is up from every side";
    // The right side is where the front's right is.
    EXPECT_LT((sides.R_v_o.at((k + 1) % 4).row(2) - R.row(0)).norm(), 1e-12);
  }
}

TEST(PatchSides, TurnAboutTheArmThatWearsThePatch) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(Eigen::Vector3d::UnitY()),
        Eigen::Vector3d(Eigen::Vector3d(1, 2, -2).normalized())}) {
    for (const double turn : {1.5, 3.0, 2 * kPi}) {
      const PatchReconstruction patch = around(axis, turn, 20);
      const PatchSides sides = patchSides(patch);
      EXPECT_GT(std::abs(sides.R_v_o[0].row(1).dot(axis)), 0.99) << axis.transpose() << ", " << turn;
      // Every face is seen well from one of the sides.
      for (const CellPlacement& cell : patch.cells) {
        double best = -1;
        for (const Eigen::Matrix3d& R : sides.R_v_o) best = std::max(best, (R * cell.T_o_u.R.col(2)).z());
        EXPECT_GT(best, 0.7);
      }
    }
  }
}

TEST(PatchSides, ShowMostFacesFromTheFront) {
  const PatchReconstruction patch = around(Eigen::Vector3d::UnitY(), 2.0, 10);
  const PatchSides sides = patchSides(patch);
  const auto seen = [&](PatchSides::Side side) {
    return std::ranges::count_if(
        patch.cells, [&](const CellPlacement& cell) { return (sides.R_v_o.at(side) * cell.T_o_u.R.col(2)).z() > 0.3; });
  };
  EXPECT_EQ(seen(PatchSides::Front), 30);
  EXPECT_EQ(seen(PatchSides::Back), 0);
}

TEST(PatchSides, OfAFlatPatchHasItsLongSideUpright) {
  PatchReconstruction patch;
  for (std::uint32_t k = 0; k < 12; ++k) {
    CellPlacement cell;
    cell.cell = CellId(k + 1);
    cell.T_o_u.t = {0.03 * k, 0.01 * (k % 2), 0};
    patch.cells.push_back(cell);
  }
  const PatchSides sides = patchSides(patch);
  EXPECT_GT(std::abs(sides.R_v_o[0](1, 0)), 0.99);
  EXPECT_GT(sides.R_v_o[0](2, 2), 0.99) << "its faces are seen from the front";
}

TEST(PatchSides, OfNothingAndOfOneCellAreFinite) {
  PatchReconstruction patch;
  for (int cells = 0; cells < 2; ++cells) {
    for (const Eigen::Matrix3d& R : patchSides(patch).R_v_o) EXPECT_NEAR(R.determinant(), 1, 1e-12);
    patch.cells.push_back({});
  }
}

}  // namespace
}  // namespace hexoderm
