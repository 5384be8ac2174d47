// Scales of colours: their legend, and ranges that the operator fixes.

#include "widgets/coloring/scale_legend.h"
#include "widgets/coloring/scale_ranges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QLocale>
#include <limits>

namespace hexoderm {
namespace {

using Values = std::vector<std::optional<double>>;
using ::testing::HasSubstr;

ScaleLegend legendOf(Coloring coloring, const Values& values, const std::optional<ColorRange>& fixed = {}) {
  return makeScaleLegend(coloring, values, values, fixed, {});
}

TEST(ScaleLegend, IsFittedToTheValuesAndCountsThem) {
  const ScaleLegend legend = legendOf(Coloring::PositionUncertainty, {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 9.0, std::nullopt});
  EXPECT_NEAR(legend.range.low, 0.2, 1e-9);
  EXPECT_NEAR(legend.range.high, 0.7, 1e-9);
  EXPECT_FALSE(legend.is_fixed);
  EXPECT_EQ(legend.counts.above, 1U) << "far from all others";
  EXPECT_EQ(legend.counts.unknown, 1U);
  EXPECT_EQ(legend.counts.counts.size(), ScaleLegend::kBins);
  EXPECT_EQ(legend.extremes, (std::pair(0.2, 9.0)));
  const std::string words = scaleText(legend).toStdString();
  EXPECT_THAT(words, HasSubstr("range fitted to what is shown"));
  EXPECT_THAT(words, HasSubstr("more than 0.700 mm: 1 cell"));
  EXPECT_THAT(words, HasSubstr("not known: 1 cell"));
}

TEST(ScaleLegend, AFixedRangeStaysWhateverTheValuesAre) {
  const ScaleLegend legend = legendOf(Coloring::PositionUncertainty, {0.2, 7.5, 0.3}, ColorRange{0, 6});
  EXPECT_EQ(legend.range, (ColorRange{0, 6}));
  EXPECT_TRUE(legend.is_fixed);
  EXPECT_EQ(legend.counts.above, 1U);
  EXPECT_THAT(scaleText(legend).toStdString(), HasSubstr("range fixed"));
  EXPECT_THAT(scaleText(legend).toStdString(), HasSubstr("goal 3 mm"));
}

TEST(ScaleLegend, DegenerateValuesHaveAScaleToo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Values& values : {Values{}, Values{std::nullopt}, Values{nan}, Values{0.4}, Values{0.4, 0.4, 0.4, nan}}) {
    const ScaleLegend legend = legendOf(Coloring::ShapeUncertainty, values);
    EXPECT_LT(legend.range.low, legend.range.high);
    EXPECT_GE(legend.range.high - legend.range.low, 0.1 - 1e-9);
    EXPECT_EQ(legend.counts.above + legend.counts.below, 0U);
    EXPECT_FALSE(scaleText(legend).isEmpty());
  }
  EXPECT_EQ(legendOf(Coloring::ShapeUncertainty, {nan}).extremes, std::nullopt);
}

TEST(ScaleLegend, AGoalBesideTheScaleIsSaid) {
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::PositionUncertainty, {0.2, 0.8})), "all within the goal of 3 mm");
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::OrientationUncertainty, {4.2, 5.8})), "none within the goal of 2°");
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::PositionUncertainty, {0.2, 5.8})), "") << "it is marked on the bar";
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::PositionUncertainty, {})), "") << "of nothing nothing is said";
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::PositionUncertainty, {0.5, 4.0}, ColorRange{0, 1})), "")
      << "neither all nor none";
  EXPECT_EQ(limitBeyondText(legendOf(Coloring::Residual, {0.2, 0.8})), "") << "there is no goal";
}

TEST(ScaleLegend, BinsAreSaidWithTheirValuesAndCells) {
  const ScaleLegend legend = legendOf(Coloring::Residual, {0.05, 0.05, 2.3}, ColorRange{0, 2.4});
  EXPECT_EQ(binText(legend, 0), "0.00 to 0.10°: 2 cells");
  EXPECT_EQ(binText(legend, 23), "2.30 to 2.40°: 1 cell");
  EXPECT_EQ(binText(legend, 5), "0.50 to 0.60°: 0 cells");
  EXPECT_EQ(binText(legend, -1), "less than 0.00°: 0 cells");
  EXPECT_EQ(binText(legend, 24), "more than 2.40°: 0 cells");
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  EXPECT_EQ(valueWithUnit(0.25, legend.range, Coloring::PositionUncertainty), "0,25 mm");
  QLocale::setDefault(QLocale::system());
}

TEST(ScaleRanges, TakesNoRangeThatIsNone) {
  ScaleRanges ranges;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ColorRange& none :
       {ColorRange{1, 1}, ColorRange{2, 1}, ColorRange{0, infinity}, ColorRange{nan, 1}, ColorRange{0, nan}}) {
    ranges.fix(Coloring::Residual, none);
    EXPECT_EQ(ranges.fixed(Coloring::Residual), std::nullopt);
  }
  ranges.fix(Coloring::Patch, {0, 1});
  EXPECT_EQ(ranges.fixed(Coloring::Patch), std::nullopt) << "classes have no range";
}

}  // namespace
}  // namespace hexoderm
