#include "hexoderm/solve/result/patch_placements.h"

#include "hexoderm/solve/reconstructor.h"
#include "tests/support/session_matchers.h"
#include "tests/support/simulated_skins.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

const SE3 kPlace{expSO3({0.4, -1.1, 0.2}), {0.3, 0.05, -0.1}};

/// A patch of two cells: 5, its origin, and 7.
PatchReconstruction twoCells() {
  PatchReconstruction patch;
  patch.origin = CellId(5);
  patch.cells.resize(2);
  patch.cells[0].cell = CellId(5);
  patch.cells[1].cell = CellId(7);
  patch.cells[1].T_o_u = {expSO3({0.1, 0.7, -0.3}), {0.03, 0.01, -0.02}};
  return patch;
}

PatchPlacement placedBy(CellId origin) {
  PatchPlacement placement;
  placement.origin = origin;
  placement.link = "forearm";
  placement.points = {{CellId(7), {0, 0, 0.1}, 0.002}};
  placement.place = PatchOnLink{origin, "forearm", kPlace, std::nullopt};
  return placement;
}

TEST(PatchPlacements, ThoseOfTheOriginCellStayAsTheyAre) {
  const auto placements = placementsOf({twoCells()}, {placedBy(CellId(5))});
  ASSERT_EQ(placements.size(), 1U);
  test::expectSamePlacement(placements[0], placedBy(CellId(5)));
}

TEST(PatchPlacements, APatchWithAnotherOriginCellIsAtTheSamePlace) {
  const PatchReconstruction patch = twoCells();
  // It was decided when cell 7 was the origin.
  const auto placements = placementsOf({patch}, {placedBy(CellId(7))});
  ASSERT_EQ(placements.size(), 1U);
  EXPECT_EQ(placements[0].origin, CellId(5));
  EXPECT_EQ(placements[0].place->origin, CellId(5));
  EXPECT_EQ(placements[0].points.size(), 1U);
  const SE3 cell_7 = placements[0].place->T_l_o * patch.cells[1].T_o_u;
  EXPECT_TRUE(cell_7.R.isApprox(kPlace.R, 1e-12));
  EXPECT_TRUE(cell_7.t.isApprox(kPlace.t, 1e-12));
}

TEST(PatchPlacements, TheCovarianceIsMovedWithTheFrame) {
  const PatchReconstruction patch = twoCells();
  PatchPlacement old = placedBy(CellId(7));
  // Every column is an error of its own, so that what becomes of it is a difference of two placements.
  const SE3 T_old_new = patch.cells[1].T_o_u.inverse();
  const SE3 T_l_new = kPlace * T_old_new;
  constexpr double kSmall = 1e-6;
  for (Eigen::Index k = 0; k < 6; ++k) {
    Eigen::Matrix<double, 6, 1> error = Eigen::Matrix<double, 6, 1>::Zero();
    error[k] = kSmall;
    const SE3 wrong{kPlace.R * expSO3(error.tail<3>()), kPlace.t + error.head<3>()};
    const SE3 wrong_new = wrong * T_old_new;
    Eigen::Matrix<double, 6, 1> expected;
    expected << wrong_new.t - T_l_new.t, logSO3(T_l_new.R.transpose() * wrong_new.R);
    old.place->cov_t_r = Matrix6d(error * error.transpose());
    const auto placements = placementsOf({patch}, {old});
    ASSERT_TRUE(placements.at(0).place->cov_t_r);
    const Matrix6d want = expected * expected.transpose();
    EXPECT_TRUE(placements[0].place->cov_t_r->isApprox(want, 1e-4)) << "error " << k;
  }
}

TEST(PatchPlacements, WhatNoPatchHoldsAndWhatComesTwiceIsLeftOut) {
  const auto placements = placementsOf({twoCells()}, {placedBy(CellId(3)), placedBy(CellId(5)), placedBy(CellId(7))});
  ASSERT_EQ(placements.size(), 1U);
  test::expectSamePlacement(placements[0], placedBy(CellId(5)));
}

TEST(PatchPlacements, AResultHasThoseOfItsSessionAndCanBeGivenLaterOnes) {
  Session session = test::simulatedSession({}, 3, 10);
  const auto bare = reconstruct(*session.snapshot());
  EXPECT_TRUE(bare->placements.empty());
  EXPECT_TRUE(placedPatches(*bare).empty());
  const PatchReconstruction& patch = bare->patches.at(0);
  EXPECT_EQ(placementOf(*bare, patch), nullptr);
  PatchPlacement placement = placedBy(patch.origin);
  placement.points[0].cell = patch.origin;
  session.setRobot(RobotDescription{"arm.urdf", "00", {}});
  session.setPlacement(placement);
  for (const auto& result : {reconstruct(*session.snapshot()), withPlacements(*bare, session)}) {
    EXPECT_EQ(result->robot, session.robot());
    ASSERT_NE(placementOf(*result, result->patches.at(0)), nullptr);
    test::expectSamePlacement(*placementOf(*result, result->patches.at(0)), placement);
    ASSERT_EQ(placedPatches(*result).size(), 1U);
    EXPECT_EQ(placedPatches(*result)[0].link, "forearm");
  }
}

}  // namespace
}  // namespace hexoderm
