#include "hexoderm/solve/metrics/cell_metrics.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

TEST(CellMetrics, WorstUsedLinkDecides) {
  Reconstruction demo = demoReconstruction();
  LinkEstimate& link = demo.patches[0].links[0];  // from cell 1 to cell 2
  link.quality = EdgeQuality::Partially;
  link.residual_rad = 2 * kDegree;
  link.sigma_rad = 9 * kDegree;
  const CellMetrics figures = makeCellMetrics(demo);
  EXPECT_EQ(figures.quality[0], EdgeQuality::Partially);
  EXPECT_EQ(figures.quality[2], EdgeQuality::Fully);
  EXPECT_THAT(figures.residual_rad[1], Optional(2 * kDegree));
  EXPECT_THAT(figures.residual_rad[2], Optional(0.4 * kDegree));
  EXPECT_THAT(figures.sigma_rad[0], Optional(9 * kDegree));

  link.used = false;
  const CellMetrics without = makeCellMetrics(demo);
  EXPECT_EQ(without.quality[0], EdgeQuality::Fully);
  EXPECT_THAT(without.sigma_rad[0], Optional(1 * kDegree));
}

TEST(CellMetrics, WhatNobodyComputedIsAbsent) {
  const CellMetrics single = makeCellMetrics(demoReconstruction({.arm_cells = 0}));
  EXPECT_EQ(single.quality[0], std::nullopt);
  EXPECT_EQ(single.residual_rad[0], std::nullopt);
  EXPECT_EQ(single.sigma_rad[0], std::nullopt);
  EXPECT_EQ(single.position_95_m[0], std::nullopt);
  EXPECT_EQ(single.body_part[0], std::nullopt);
  EXPECT_THAT(single.path_length_m[0], Optional(0.0));

  Reconstruction imported = demoReconstruction();
  for (LinkEstimate& link : imported.patches[0].links) link.residual_rad = link.sigma_rad = 0;
  for (CellPlacement& cell : imported.patches[0].cells) cell.predecessor.reset();
  const CellMetrics figures = makeCellMetrics(imported);
  EXPECT_EQ(figures.residual_rad[0], std::nullopt);
  EXPECT_EQ(figures.sigma_rad[0], std::nullopt);
  EXPECT_EQ(figures.path_length_m[0], std::nullopt);
}

TEST(CellMetrics, UncertaintiesAreThoseOfTheVerdict) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(3)).snapshot());
  const CellMetrics figures = makeCellMetrics(*result);
  double position = 0;
  double orientation = 0;
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    position = std::max(position, figures.position_95_m[k].value_or(0));
    orientation = std::max(orientation, figures.orientation_95_rad[k].value_or(0));
  }
  EXPECT_THAT(result->assessment.position_95_m, Optional(testing::DoubleEq(position)));
  EXPECT_THAT(result->assessment.orientation_95_rad, Optional(testing::DoubleEq(orientation)));
  EXPECT_GT(position, 0);
}

TEST(CellMetrics, PathLengthIsSummedFromCentreToCentre) {
  const Reconstruction demo = demoReconstruction();
  const CellMetrics figures = makeCellMetrics(demo);
  ASSERT_EQ(figures.cells.size(), 17U);
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    const std::vector<CellId> path = demo.patches[0].pathTo(demo.patches[0].cells[k].cell);
    double expected = 0;
    for (std::size_t step = 1; step < path.size(); ++step) {
      expected += (demo.find(path[step]).cell->T_o_u.t - demo.find(path[step - 1]).cell->T_o_u.t).norm();
    }
    EXPECT_THAT(figures.path_length_m[k], Optional(testing::DoubleNear(expected, 1e-12)));
  }
}

TEST(CellMetrics, BodyPartsAreNumberedInTheOrderOfTheirNames) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[0].body_part = "upper arm";
  demo.patches[0].cells[2].body_part = "hand";
  const CellMetrics figures = makeCellMetrics(demo);
  EXPECT_THAT(figures.body_parts, ElementsAre("hand", "upper arm"));
  EXPECT_EQ(figures.body_part[0], 1U);
  EXPECT_EQ(figures.body_part[1], std::nullopt);
  EXPECT_EQ(figures.body_part[2], 0U);
}

TEST(CellMetrics, PatchesFollowEachOther) {
  const CellMetrics figures = makeCellMetrics(demoPatches({DemoOptions(), {.first_id = 101}}));
  ASSERT_EQ(figures.cells.size(), 34U);
  EXPECT_EQ(figures.patch[16], 0U);
  EXPECT_EQ(figures.patch[17], 1U);
  EXPECT_EQ(figures.cells[17], CellId(101));
  EXPECT_THAT(figures.path_length_m[17], Optional(0.0));
}

}  // namespace
}  // namespace hexoderm
