#include "hexoderm/solve/metrics/review_summary.h"

#include "hexoderm/base/units.h"
#include "tests/support/result_builder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

LinkEstimate linkWith(double residual_rad, double sigma_rad, std::vector<std::optional<double>> per_pose) {
  LinkEstimate link = test::usedLink();
  link.residual_rad = residual_rad;
  link.sigma_rad = sigma_rad;
  link.pose_residual_rad = std::move(per_pose);
  return link;
}

Reconstruction threeLinks() {
  return test::ResultBuilder()
      .poses(3)
      .patch(1)
      .cells(1, 4)
      .link(1, 1, 2, 4, linkWith(0.1, 0.2, {0.1, std::nullopt, 0.1}))
      .link(2, 1, 3, 4, linkWith(0.4, 0.1, {0.3, std::nullopt, 0.5}))
      .link(3, 1, 4, 4, linkWith(0.2, 0, {0.2, std::nullopt, 0.2}))
      .link(1, 1, 4, 4, linkWith(0, 0, {std::nullopt, std::nullopt, std::nullopt}))
      .build();
}

TEST(ReviewSummary, SaysALotInWords) {
  EXPECT_EQ(lotText({{-0.02534, -0.0101, 0.045}, {0.001, 0.0021, 0.0004}, 1.0031, 0.0012}).english(),
            "offset -25.3, -10.1, 45.0 +- 2.1 mg, scale 1.003 +- 0.001 (1 sigma)");
}

TEST(ReviewSummary, PosesHaveTheQuartilesOfTheirLinks) {
  const ResidualSummary summary = summariseResiduals(threeLinks());
  ASSERT_THAT(summary.poses, SizeIs(2)) << "nothing was measured in the second";
  EXPECT_EQ(summary.poses[0].pose, PoseId(1));
  EXPECT_EQ(summary.poses[1].index, 2U);
  const PoseResiduals& box = summary.poses[0];
  EXPECT_EQ(box.count, 3U);
  EXPECT_DOUBLE_EQ(box.least, 0.1);
  EXPECT_DOUBLE_EQ(box.lower_quartile, 0.15);
  EXPECT_DOUBLE_EQ(box.median, 0.2);
  EXPECT_DOUBLE_EQ(box.upper_quartile, 0.25);
  EXPECT_DOUBLE_EQ(box.largest, 0.3);
}

TEST(ReviewSummary, LinksAreRankedAndThoseThatWereNotMeasuredLeftOut) {
  const ResidualSummary summary = summariseResiduals(threeLinks());
  ASSERT_THAT(summary.links, SizeIs(3));
  EXPECT_EQ(summary.links[0].link, 1U);
  EXPECT_EQ(summary.links[1].link, 2U);
  EXPECT_FALSE(summary.links[1].sigma_rad.has_value());
  EXPECT_EQ(summary.links[2].link, 0U);
}

TEST(ReviewSummary, OfAFileThatStatesTheRmsAloneLinksHaveTheirResiduals) {
  Reconstruction imported = threeLinks();
  for (LinkEstimate& link : imported.patches[0].links) link.pose_residual_rad.clear();
  EXPECT_EQ(imported.patches[0].links[1].knownResidual(), 0.4);
  EXPECT_EQ(imported.patches[0].links[3].knownResidual(), std::nullopt);
  EXPECT_EQ(imported.patches[0].links[1].knownSigma(), 0.1);
  EXPECT_EQ(imported.patches[0].links[2].knownSigma(), std::nullopt);
  const ResidualSummary summary = summariseResiduals(imported);
  ASSERT_THAT(summary.links, SizeIs(3));
  EXPECT_EQ(summary.links[0].residual_rad, 0.4);
  EXPECT_THAT(summary.poses, IsEmpty());
  EXPECT_EQ(summariseCells(imported)[2].worst_residual_rad, 0.4);
}

TEST(ReviewSummary, ALinkThatWasSolvedOrMeasuredHasMetrics) {
  LinkEstimate link;
  EXPECT_FALSE(link.hasMetrics());
  link.used = true;
  EXPECT_TRUE(link.hasMetrics());
  link.used = false;
  link.pose_residual_rad = {std::nullopt, 0.0};
  EXPECT_TRUE(link.hasMetrics());
  EXPECT_EQ(link.knownResidual(), 0.0) << "measured, and nothing is left";
}

TEST(ReviewSummary, RatiosCountWhatIsPredicted) {
  const ResidualSummary summary = summariseResiduals(threeLinks());
  std::size_t count = 0;
  for (const ValueBin& bin : summary.ratios) {
    count += bin.count;
    if (bin.count > 0) {
      const bool half = bin.lower <= 0.5 + 1e-9 && bin.upper >= 0.5 - 1e-9;
      const bool four = bin.lower <= 4 + 1e-9 && bin.upper >= 4 - 1e-9;
      EXPECT_TRUE(half || four) << bin.lower;
    }
  }
  EXPECT_EQ(count, 2U);
  EXPECT_THAT(summariseResiduals(Reconstruction()).ratios, IsEmpty());
}

TEST(ReviewSummary, TheWorstScaleIsTheOneFurthestFromOne) {
  Reconstruction result = threeLinks();
  result.patches[0].cells[1].accel_scale = Eigen::Vector3d(1.02, 0.95, 1.04);
  const std::vector<CellSummary> cells = summariseCells(result);
  EXPECT_FALSE(cells[0].worst_scale_error.has_value());
  ASSERT_TRUE(cells[1].worst_scale_error.has_value());
  EXPECT_NEAR(*cells[1].worst_scale_error, -0.05, 1e-12);
}

TEST(ReviewSummary, CellsCarryTheWorstOfTheirLinks) {
  const std::vector<CellSummary> cells = summariseCells(threeLinks());
  ASSERT_THAT(cells, SizeIs(4));
  EXPECT_TRUE(cells[0].origin);
  EXPECT_EQ(cells[0].worst_residual_rad, 0.1);
  EXPECT_EQ(cells[1].worst_residual_rad, 0.4);
  EXPECT_EQ(cells[2].worst_residual_rad, 0.4);
  EXPECT_EQ(cells[3].worst_residual_rad, 0.2);
  EXPECT_FALSE(cells[1].stated.has_value());
}

}  // namespace
}  // namespace hexoderm
