#include "widgets/coloring/coloring.h"

#include "hexoderm/util/units.h"
#include "tests/support/hand_made_skins.h"
#include "widgets/coloring/coloring_words.h"

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
    EXPECT_EQ(row.range.has_value(), has_value && row.coloring != Coloring::PathDistance) << row.name;
    if (row.graph_title != nullptr && has_value) {
      EXPECT_EQ(row.colors_links, row.of_link != nullptr) << row.name;
      EXPECT_EQ(row.range->low, 0) << row.name;
    }
    if (row.patch_title != nullptr && has_value) {
      EXPECT_NE(row.of_cell, nullptr) << row.name;
      EXPECT_NE(row.missing, nullptr) << row.name;
    }
  }
}

TEST(Coloring, OnlyTheLengthOfPathsEndsWithTheSkin) {
  EXPECT_EQ(colorRange(Coloring::PathDistance, {12.0, std::nullopt}).high, 100);
  EXPECT_EQ(colorRange(Coloring::PathDistance, {111.0}).high, 200);
  EXPECT_EQ(colorRange(Coloring::PathDistance, {2400.0}).high, 5000);
  const auto values = cellValues(Coloring::PathDistance, makeCellFigures(demoReconstruction()), {});
  EXPECT_EQ(values[0], 0);
  EXPECT_GT(values[16].value_or(0), 90);
}

TEST(Coloring, AnglesOfLinksCountEitherWay) {
  LinkEstimate link = demoReconstruction().patches[0].links[0];
  link.bend_rad = -12 * kDegree;
  ASSERT_TRUE(link.hasFigures());
  EXPECT_NEAR(coloringRow(Coloring::Bend).of_link(link).value_or(0), 12, 1e-9);
}

TEST(Coloring, TheGraphNamesTheUnitAtTheEndOfTheScaleAndThe3dViewInTheTitle) {
  const ScaleWords residual = graphScaleInWords(Coloring::Residual);
  EXPECT_EQ(residual.title, "residual, rms over poses");
  EXPECT_EQ(residual.low, "0");
  EXPECT_EQ(residual.high, QStringLiteral("2° or more"));
  EXPECT_EQ(graphScaleInWords(Coloring::PositionUncertainty).high, QStringLiteral("±6 mm or more"));
  EXPECT_EQ(graphScaleInWords(Coloring::OrientationUncertainty).high, QStringLiteral("±6° or more"));
  const ScaleWords reading = patchScaleInWords(Coloring::ReadingNorm, {0.8, 1.2});
  EXPECT_EQ(reading.title, "norm of the newest reading, g");
  EXPECT_EQ(reading.low, "0.8 or less");
  EXPECT_EQ(reading.high, "1.2 or more");
  EXPECT_EQ(patchScaleInWords(Coloring::PathDistance, {0, 200}).high, "200") << "no value lies beyond";
  EXPECT_EQ(patchTitle(Coloring::Temperature), QStringLiteral("temperature, °C"));
  EXPECT_EQ(patchTitle(Coloring::BodyPart), "body part");
}

TEST(Coloring, SaysWhyCellsCannotBeColoured) {
  EXPECT_EQ(whyNoColoring(Coloring::BodyPart, true), "");
  EXPECT_EQ(whyNoColoring(Coloring::BodyPart, false), "The skin does not say which body part its cells are on");
  EXPECT_EQ(whyNoColoring(Coloring::Patch, false), "");
}

}  // namespace
}  // namespace hexoderm
