#include "widgets/coloring/cell_colors.h"

#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

SceneColors threeSteps() {
  SceneColors colors;
  colors.quality = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}};
  colors.no_data = {0.5, 0.5, 0.5};
  colors.scale = {{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}, {0, 0, 0.2}, {1, 1, 1}};
  colors.signed_scale = {{{0, 1, 0}, {0.5, 0.5, 0.5}, {0, 0, 1}}, {0, 0.2, 0}, {1, 1, 1}};
  colors.classes = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  return colors;
}

TEST(CellColors, QuantitiesLieOnTheirScalesAndWhatIsBeyondIsSeen) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[0].cov_t_r = Matrix6d::Zero();
  demo.patches[0].cells[1].cov_t_r = Matrix6d::Identity() * 1e-6;  // 1 mm, 0.06 deg
  demo.patches[0].cells[2].cov_t_r = Matrix6d::Identity();
  const CellMetrics figures = makeCellMetrics(demo);
  const auto values = cellValues(Coloring::PositionUncertainty, figures, {});
  EXPECT_EQ(values[0], 0);
  EXPECT_NEAR(values[1].value_or(0), 1.96, 1e-6);
  EXPECT_EQ(values[3], std::nullopt);
  const auto colored = [&](const ColorRange& range) {
    return cellColors(Coloring::PositionUncertainty, figures, {}, range, threeSteps());
  };
  const std::vector<Rgb> colors = colored({0, 6});
  EXPECT_EQ(colors[0], (Rgb{0, 0, 0}));
  EXPECT_NEAR(colors[1][0], 1.96 / 6, 1e-6);
  EXPECT_EQ(colors[2], (Rgb{1, 1, 1})) << "beyond the end is no end";
  EXPECT_EQ(colors[3], threeSteps().no_data) << "nothing is known";
  EXPECT_EQ(colored({1, 6})[0], threeSteps().scale.below);
  EXPECT_NEAR(colored({0, 1960})[2][0], 1, 1e-3) << "an end is not beyond";
}

TEST(CellColors, SignedValuesHaveAMapWithAMiddle) {
  Reconstruction demo = demoReconstruction();
  for (LinkEstimate& link : demo.patches[0].links) link.bend_rad = 0;
  demo.patches[0].links[0].bend_rad = -20 * kDegree;  // cells 1 and 2
  const CellMetrics figures = makeCellMetrics(demo);
  const std::vector<Rgb> colors = cellColors(Coloring::Bend, figures, {}, {-20, 20}, threeSteps());
  EXPECT_NEAR(colors[1][1], 1, 1e-9);
  EXPECT_NEAR(colors[16][1], 0.5, 1e-9);
  for (const ColoringRow& row : coloringTable()) {
    if (!isQuantity(row.coloring)) continue;
    const bool is_signed = row.coloring == Coloring::Bend || row.coloring == Coloring::Twist ||
                           row.coloring == Coloring::SurfaceDistance || isReading(row.coloring);
    EXPECT_EQ(row.center.has_value(), is_signed && row.coloring != Coloring::Temperature) << row.name;
  }
}

TEST(CellColors, ReadingsAreThoseOfEachCell) {
  const CellMetrics figures = makeCellMetrics(demoReconstruction());
  CellReadings readings;
  readings.acceleration_g[CellId(2)] = {0.6, 0, -0.8};
  readings.temperature_c[CellId(2)] = 30;
  EXPECT_TRUE(hasValues(Coloring::ReadingZ, figures, readings));
  EXPECT_FALSE(hasValues(Coloring::ReadingZ, figures, {}));
  EXPECT_FALSE(hasValues(Coloring::Temperature, figures, {}));
  EXPECT_EQ(cellValues(Coloring::ReadingZ, figures, readings)[1], -0.8);
  EXPECT_EQ(cellValues(Coloring::ReadingNorm, figures, readings)[1], 1.0);
  EXPECT_EQ(cellValues(Coloring::ReadingNorm, figures, readings)[0], std::nullopt);
  const std::vector<Rgb> colors = cellColors(Coloring::Temperature, figures, readings, {15, 45}, threeSteps());
  EXPECT_NEAR(colors[1][0], 0.5, 1e-9);
  EXPECT_EQ(colors[0], threeSteps().no_data);
}

TEST(CellColors, CategoriesHaveColoursOfTheirOwn) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[0].body_part = "hand";
  demo.patches[0].cells[1].body_part = "arm";
  demo.patches[0].links[0].quality = EdgeQuality::Undefined;
  const CellMetrics figures = makeCellMetrics(demo);
  const std::vector<Rgb> by_part = cellColors(Coloring::BodyPart, figures, {}, {}, threeSteps());
  EXPECT_NE(by_part[0], by_part[1]);
  EXPECT_EQ(by_part[2], threeSteps().no_data);
  const std::vector<Rgb> by_class = cellColors(Coloring::LinkQuality, figures, {}, {}, threeSteps());
  EXPECT_EQ(by_class[0], threeSteps().quality[0]);
  EXPECT_EQ(by_class[2], threeSteps().quality[2]);
  EXPECT_FALSE(isQuantity(Coloring::BodyPart));
  EXPECT_TRUE(isQuantity(Coloring::SurfaceDistance));
}

}  // namespace
}  // namespace hexoderm
