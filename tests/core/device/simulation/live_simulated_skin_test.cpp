#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/units.h"

#include <gtest/gtest.h>
#include <limits>

namespace hexoderm {
namespace {

SimulatedSkin x17(SimulatedSkinOptions options) { return {builtInCellModel("hex-bma150"), std::move(options)}; }

/// Up in the body, as a perfect cell sees it.
Eigen::Vector3d upSeenBy(const SimulatedSkin& skin, const SampleFrame& frame, std::size_t cell) {
  return skin.truth()[cell].T_b_u.R * frame.samples[cell].acceleration_g;
}

TEST(LiveSimulatedSkin, LiesOnATableUntilItIsTurned) {
  SimulatedSkin skin = x17(SimulatedSkinOptions::ideal());
  for (int tick = 0; tick < 5; ++tick) {
    const SampleFrame frame = skin.next();
    EXPECT_DOUBLE_EQ(frame.time_s, tick / 1000.0);
    ASSERT_EQ(frame.samples.size(), 17U);
    EXPECT_LT((upSeenBy(skin, frame, 3) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
  EXPECT_FALSE(skin.turning());
}

TEST(LiveSimulatedSkin, TurnsWithoutAJumpAndArrives) {
  SimulatedSkin skin = x17(SimulatedSkinOptions::ideal());
  Eigen::Vector3d before = upSeenBy(skin, skin.next(), 0);
  const Eigen::Vector3d up = Eigen::Vector3d(1, 2, -1).normalized();
  skin.turnTo(up);
  EXPECT_TRUE(skin.turning());
  int ticks = 0;
  double farthest = 0;
  while (skin.turning()) {
    ASSERT_LT(++ticks, 10000);
    const Eigen::Vector3d now = upSeenBy(skin, skin.next(), 0);
    // The turning itself is felt too: cells lie apart from the hand. It is far below 1 g.
    EXPECT_NEAR(now.norm(), 1, 0.2);
    farthest = std::max(farthest, (now - before).norm());
    before = now;
  }
  EXPECT_GT(ticks, 500);
  EXPECT_LT(farthest, 0.01);
  EXPECT_LT((upSeenBy(skin, skin.next(), 0) - up).norm(), 1e-12);

  // On the way it may be sent elsewhere.
  skin.turnTo(-up);
  for (int k = 0; k < 200; ++k) before = upSeenBy(skin, skin.next(), 0);
  skin.turnTo(up);
  EXPECT_LT((upSeenBy(skin, skin.next(), 0) - before).norm(), 0.05);
  while (skin.turning()) skin.next();
  EXPECT_LT((upSeenBy(skin, skin.next(), 0) - up).norm(), 1e-12);
}

TEST(LiveSimulatedSkin, AHandMissesByAFewDegreesAndTrembles) {
  SimulatedSkinOptions options;
  options.sensor_errors = false;
  options.sensor_noise = false;
  SimulatedSkin skin = x17(options);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitX();
  skin.turnTo(up);
  while (skin.turning()) skin.next();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  constexpr int kTicks = 1000;
  for (int k = 0; k < kTicks; ++k) {
    const Eigen::Vector3d seen = upSeenBy(skin, skin.next(), 0);
    sum += seen;
    squares += seen.cwiseAbs2();
  }
  const Eigen::Vector3d mean = sum / kTicks;
  EXPECT_GT(angleBetween(mean, up), 0.1 * kDegree);
  EXPECT_LT(angleBetween(mean, up), 12 * kDegree);
  const double scatter = std::sqrt((squares / kTicks - mean.cwiseAbs2()).sum());
  EXPECT_GT(scatter, 0.005);
  EXPECT_LT(scatter, 0.05);
}

TEST(LiveSimulatedSkin, CellsBreakAndAreMendedWhileItRuns) {
  SimulatedSkin skin = x17(SimulatedSkinOptions::ideal());
  skin.breakCell({SkinFault::Dead, CellId(5)});
  EXPECT_EQ(skin.next().samples[4].acceleration_g, Eigen::Vector3d::Zero());
  skin.breakCell({SkinFault::NoSamples, CellId(6)});
  EXPECT_EQ(skin.next().samples.size(), 16U);
  skin.mendCell(CellId(5));
  skin.mendCell(CellId(6));
  const SampleFrame frame = skin.next();
  ASSERT_EQ(frame.samples.size(), 17U);
  EXPECT_NEAR(frame.samples[4].acceleration_g.norm(), 1, 1e-9);
}

TEST(LiveSimulatedSkin, RefusesWhatIsNotThere) {
  SimulatedSkin skin = x17(SimulatedSkinOptions::ideal());
  EXPECT_THROW(skin.turnTo(Eigen::Vector3d::Zero()), InvalidArgument);
  EXPECT_THROW(skin.turnTo({0, std::numeric_limits<double>::quiet_NaN(), 1}), InvalidArgument);
  EXPECT_THROW(skin.breakCell({SkinFault::Dead, CellId(18)}), InvalidArgument);
  EXPECT_THROW(skin.mendCell(CellId(0)), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
