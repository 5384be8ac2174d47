#include "widgets/plot/plot_data.h"

#include "tests/widgets/plot/growing_sheet.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

PlotData plotted(const Reconstruction& result, const PlotChoice& choice, const CellReadings& readings = {}) {
  return makePlotData(&result, makeCellMetrics(result), readings, choice);
}

/// Of which the last cell does not say how well it is known.
std::shared_ptr<Reconstruction> sheetWithUncertainties() {
  auto result = growingSheet(4, 5);
  result->patches[0].cells.back().cov_t_r.reset();
  return result;
}

TEST(PlotData, EveryFigureOfTheTableThatIsAQuantityCanBeAnAxis) {
  for (const PlotSubject subject : {PlotSubject::Cells, PlotSubject::Links}) {
    const auto figures = plotMetrics(subject);
    EXPECT_EQ(figures.front(), std::nullopt) << "the number of the cell comes first";
    for (const ColoringRow& row : coloringTable()) {
      const bool has = subject == PlotSubject::Links ? row.of_link != nullptr : row.of_cell != nullptr;
      EXPECT_EQ(std::ranges::count(figures, PlotFigure(row.coloring)), has ? 1 : 0) << row.name;
    }
    for (const PlotFigure& figure : figures) EXPECT_FALSE(plotFigureName(subject, figure).isEmpty());
  }
  EXPECT_EQ(plotAxisTitle(PlotSubject::Cells, Coloring::PositionUncertainty), "position uncertainty (95 %), mm");
  EXPECT_EQ(plotAxisTitle(PlotSubject::Cells, std::nullopt), "number of the cell");
}

TEST(PlotData, PointsAreTheMetricsOfTheCellsAndWhatLacksOneIsCounted) {
  const auto result = sheetWithUncertainties();
  const PlotData data = plotted(*result, {PlotSubject::Cells, std::nullopt, Coloring::PositionUncertainty, false});
  EXPECT_EQ(data.unknown, 1U);
  ASSERT_EQ(data.points.size(), 19U);
  const CellMetrics figures = makeCellMetrics(*result);
  for (std::size_t k = 0; k < data.points.size(); ++k) {
    EXPECT_EQ(data.points[k].x, data.points[k].cell.value());
    EXPECT_DOUBLE_EQ(data.points[k].y, toMillimetres(*figures.position_95_m[k]));
  }
  EXPECT_DOUBLE_EQ(data.bounds(true).low, data.points.front().y);
  EXPECT_DOUBLE_EQ(data.bounds(true).high, data.points.back().y);
}

TEST(PlotData, LinksAreThoseThatAreUsedWithBothOfTheirCells) {
  const auto result = sampleTwoPatches();
  const PlotData data = plotted(*result, {PlotSubject::Links, Coloring::Deviation, Coloring::Residual, false});
  std::size_t used = 0;
  for (const PatchReconstruction& patch : result->patches) {
    used += static_cast<std::size_t>(std::ranges::count_if(patch.links, &LinkEstimate::used));
  }
  EXPECT_EQ(data.points.size() + data.unknown, used);
  ASSERT_FALSE(data.points.empty());
  for (const PlotPoint& point : data.points) {
    ASSERT_TRUE(point.link.has_value());
    EXPECT_LT(point.link->first, point.link->second);
    EXPECT_THAT(data.cellsOf(point), testing::ElementsAre(point.link->first.cell, point.link->second.cell));
  }
}

TEST(PlotData, AHistogramCountsEveryPointOnce) {
  const auto result = sheetWithUncertainties();
  const PlotData data = plotted(*result, {PlotSubject::Cells, Coloring::PositionUncertainty, std::nullopt, true});
  std::size_t counted = 0;
  for (const ValueBin& bin : data.bins) counted += bin.count;
  EXPECT_EQ(counted, data.points.size());
  EXPECT_EQ(counted, 19U);
}

TEST(PlotData, ReadingsAreMetricsAsLongAsThereAreSome) {
  const auto result = sampleX17();
  const PlotChoice choice{PlotSubject::Cells, std::nullopt, Coloring::ReadingZ, false};
  EXPECT_TRUE(plotted(*result, choice).points.empty());
  CellReadings readings;
  readings.acceleration_g[CellId(7)] = {0.1, 0.2, 0.9};
  const PlotData data = plotted(*result, choice, readings);
  ASSERT_EQ(data.points.size(), 1U);
  EXPECT_EQ(data.points[0].cell, CellId(7));
  EXPECT_DOUBLE_EQ(data.points[0].y, 0.9);
}

TEST(PlotData, ValuesAreWrittenWithThreeDigitsAndTheirUnit) {
  EXPECT_EQ(plotValueText(Coloring::PositionUncertainty, 0.8349), "0.835\u00a0mm");
  EXPECT_EQ(plotValueText(Coloring::PositionUncertainty, 12.349), "12.3\u00a0mm");
  EXPECT_EQ(plotValueText(Coloring::Bend, 123.49), "123°");
  EXPECT_EQ(plotValueText(std::nullopt, 17), "17");
}

}  // namespace
}  // namespace hexoderm
