#include "hexoderm/device/pose_average.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::_;
using ::testing::FieldsAre;

TEST(AverageFrames, GivesMeanCovarianceOfTheMeanAndCount) {
  const std::vector<SampleFrame> frames = {
      {0.000, {{CellId(7), {0, 0, 1.0}}}},
      {0.001, {{CellId(7), {2, 0, 1.0}}}},
      {0.002, {{CellId(7), {1, 3, 1.0}}}},
  };
  const PoseCapture pose = averageFrames(frames, PoseId(4), Message::verbatim("standing"));
  EXPECT_EQ(pose.id, PoseId(4));
  EXPECT_EQ(pose.label.english(), "standing");
  ASSERT_EQ(pose.samples.size(), 1U);
  const GravitySample& sample = pose.samples.front();
  EXPECT_EQ(sample.cell, CellId(7));
  EXPECT_EQ(sample.count, 3U);
  EXPECT_LT((sample.mean_g - Eigen::Vector3d(1, 1, 1)).norm(), 1e-15);
  // Sample covariance xx = 1, yy = 3, xy = 0; of the mean: a third.
  Eigen::Matrix3d expected;
  expected << 1.0 / 3, 0, 0, 0, 1, 0, 0, 0, 0;
  EXPECT_LT((sample.cov_g2 - expected).norm(), 1e-15);
}

TEST(AverageFrames, CovarianceIsSymmetricAndShrinksWithTheCount) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.01);
  std::vector<SampleFrame> frames(10000);
  for (SampleFrame& frame : frames) {
    const double x = normal(random);
    frame.samples.push_back({CellId(1), {x, 0.5 * x + normal(random), 1e3 + normal(random)}});
  }
  const Eigen::Matrix3d cov = averageFrames(frames, PoseId(1), {}).samples.front().cov_g2;
  EXPECT_EQ(cov, cov.transpose());
  EXPECT_NEAR(cov(0, 0) / (1e-4 / 10000), 1, 0.05);
  EXPECT_NEAR(cov(0, 1) / (0.5e-4 / 10000), 1, 0.1);
  EXPECT_NEAR(cov(2, 2) / (1e-4 / 10000), 1, 0.05);
}

TEST(AverageFrames, CellsMayBeMissingFromFrames) {
  const std::vector<SampleFrame> frames = {
      {0, {{CellId(2), {0, 0, 1}}, {CellId(1), {1, 0, 0}}}},
      {0, {{CellId(2), {0, 0, 1}}}},
  };
  const PoseCapture pose = averageFrames(frames, PoseId(1), {});
  EXPECT_THAT(pose.samples, ElementsAre(FieldsAre(CellId(1), _, Eigen::Matrix3d(Eigen::Matrix3d::Zero()), 1U, _),
                                        FieldsAre(CellId(2), _, _, 2U, _)));
}

TEST(AverageFrames, LeavesOutWhatIsNoReading) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const SampleFrame frame{
      0,
      {{CellId(1), {nan, 0, 0}}, {CellId(1), {0, infinite, 0}}, {CellId(1), {0, 0, 1e30}}, {CellId(2), {0, 0, 1}}},
      {{CellId(3), {0, 1e7, 0}, {0, 0, 0}, 5},
       {CellId(4), {0, 1, 0}, {1e30, 0, 0}, 5},
       {CellId(4), {2, 0, 1}, {-4, 0, 0}, 5},
       {CellId(4), {2, 0, 1}, {4, 0, 0}, 0},
       {CellId(5), {0, 1, 0}, {0, 0, 0}, UINT32_MAX},
       {CellId(5), {0, 1, 0}, {0, 0, 0}, UINT32_MAX}}};
  const PoseCapture pose = averageFrames({&frame, 1}, PoseId(1), {});
  EXPECT_THAT(pose.samples, ElementsAre(FieldsAre(CellId(2), Eigen::Vector3d(0, 0, 1), _, 1U, _),
                                        FieldsAre(CellId(5), _, _, UINT32_MAX, _)));
  EXPECT_TRUE(pose.samples.back().cov_g2.allFinite());
}

TEST(AverageFrames, PoolsMeansThatTheDeviceMadeWithSamples) {
  // 0, 2 and 4 by the device (variance 4), and 6 as a sample: mean 3, sample variance 20 / 3.
  std::vector<SampleFrame> frames(2);
  frames[0].means.push_back({CellId(1), {2, 0, 1}, {4, 0, 0}, 3});
  frames[1].samples.push_back({CellId(1), {6, 0, 1}});
  const GravitySample sample = averageFrames(frames, PoseId(1), {}).samples.front();
  EXPECT_EQ(sample.count, 4U);
  EXPECT_LT((sample.mean_g - Eigen::Vector3d(3, 0, 1)).norm(), 1e-15);
  EXPECT_NEAR(sample.cov_g2(0, 0), 20.0 / 3 / 4, 1e-15);
  EXPECT_EQ(sample.cov_g2(1, 1), 0);
}

TEST(AverageFrames, OfNothingIsAPoseWithoutSamples) { EXPECT_TRUE(averageFrames({}, PoseId(1), {}).samples.empty()); }

}  // namespace
}  // namespace hexoderm
