#include "widgets/coloring/coloring.h"

#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(Coloring, EveryRowOfTheTableStandsInItsPlaceAndIsOfferedSomewhere) {
  std::size_t place = 0;
  for (const ColoringRow& row : coloringTable()) {
    EXPECT_EQ(static_cast<std::size_t>(row.coloring), place++) << row.name;
    EXPECT_TRUE(row.graph_title != nullptr || row.patch_title != nullptr) << row.name;
    const bool has_value = row.of_link != nullptr || row.of_cell != nullptr;
    EXPECT_EQ(isQuantity(row.coloring), has_value) << row.name;
    EXPECT_EQ(row.range.has_value(), has_value) << row.name;
    if (row.graph_title != nullptr && has_value) {
      EXPECT_EQ(row.colors_links, row.of_link != nullptr) << row.name;
      EXPECT_TRUE(row.center ? row.range->low + row.range->high == 2 * *row.center : row.range->low == 0) << row.name;
    }
    if (row.patch_title != nullptr && has_value) {
      EXPECT_NE(row.of_cell, nullptr) << row.name;
      EXPECT_NE(row.missing, nullptr) << row.name;
    }
  }
}

TEST(Coloring, RangesAreFittedUnlessTheOperatorFixesThemOrNatureDoes) {
  using Values = std::vector<std::optional<double>>;
  EXPECT_EQ(rangeOf(Coloring::PathDistance, Values{12.0, 111.0, std::nullopt}, {}), (ColorRange{10, 115}));
  EXPECT_EQ(rangeOf(Coloring::PathDistance, Values{12.0, 111.0}, ColorRange{0, 500}), (ColorRange{0, 500}));
  EXPECT_EQ(rangeOf(Coloring::ReadingX, Values{0.2, 0.3}, {}), (ColorRange{-1, 1})) << "not a matter of the moment";
  EXPECT_EQ(rangeOf(Coloring::ReadingNorm, {}, {}), (ColorRange{0.8, 1.2}));
  const ColorRange bends = rangeOf(Coloring::Bend, Values{-12.0, 3.0}, {});
  EXPECT_EQ(bends.low, -bends.high) << "no bend is in the middle";
  const ColorRange alike = rangeOf(Coloring::Residual, Values{0.3, 0.3}, {});
  EXPECT_NEAR(alike.high - alike.low, coloringRow(Coloring::Residual).least_span, 1e-9);
}

TEST(Coloring, GraphAnd3dViewFitTheirScalesToTheSameValues) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].links[5].used = false;
  demo.patches[0].links[5].residual_rad = 1;
  const CellMetrics figures = makeCellMetrics(demo);
  const auto residuals = scaledValues(Coloring::Residual, demo, figures, {});
  EXPECT_EQ(residuals.size(), 15U) << "of the used links";
  for (const auto& residual : residuals) EXPECT_NEAR(residual.value_or(0), 0.4, 1e-9);
  EXPECT_EQ(scaledValues(Coloring::PathDistance, demo, figures, {}), cellValues(Coloring::PathDistance, figures, {}));
}

TEST(Coloring, BendsAreSignedAndYawsCountEitherWay) {
  LinkEstimate link = demoReconstruction().patches[0].links[0];
  link.bend_rad = -12 * kDegree;
  link.yaw_rad = -3 * kDegree;
  ASSERT_TRUE(link.hasMetrics());
  EXPECT_NEAR(coloringRow(Coloring::Bend).of_link(link).value_or(0), -12, 1e-9);
  EXPECT_NEAR(coloringRow(Coloring::Yaw).of_link(link).value_or(0), 3, 1e-9);
}

TEST(Coloring, LimitsAreThoseOfTheVerdictAndOfTheSolver) {
  SolverOptions options;
  options.max_bend_rad = 50 * kDegree;
  const auto bend = limitsOf(Coloring::Bend, options);
  ASSERT_EQ(bend.size(), 2U);
  EXPECT_NEAR(bend[0].value, -50, 1e-9);
  EXPECT_NEAR(bend[1].value, 50, 1e-9);
  const auto position = limitsOf(Coloring::PositionUncertainty, options);
  ASSERT_EQ(position.size(), 1U);
  EXPECT_EQ(position[0].kind, ScaleLimit::Kind::Goal);
  EXPECT_NEAR(position[0].value, 3, 1e-9);
  EXPECT_TRUE(limitsOf(Coloring::ShapeUncertainty, options).empty())
      << "the verdict judges cells relative to the origin";
}

TEST(Coloring, TitlesNameTheUnit) {
  EXPECT_EQ(graphTitle(Coloring::Residual), "residual, rms over poses, °");
  EXPECT_EQ(patchTitle(Coloring::Temperature), "temperature, °C");
  EXPECT_EQ(patchTitle(Coloring::BodyPart), "body part");
}

}  // namespace
}  // namespace hexoderm
