#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

SimulatedSkin x17(SimulatedSkinOptions options) { return {builtInCellModel("hex-bma150"), std::move(options)}; }

/// Up in the body, as a perfect cell sees it.
Eigen::Vector3d upSeenBy(const SimulatedSkin& skin, const SampleFrame& frame, std::size_t cell) {
  return skin.truth()[cell].T_b_u.R * frame.samples[cell].acceleration_g;
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

TEST(SimulatedRobotMotion, ShakesEachCellByEightToThirtyFiveMilligTwentyTimesASecond) {
  SimulatedSkin skin = x17(SimulatedSkinOptions::robot());
  EXPECT_EQ(skin.rate_hz(), 20);
  const std::vector<SampleFrame> frames = skin.record(Eigen::Vector3d::UnitZ(), 2000);
  EXPECT_DOUBLE_EQ(frames[1].time_s - frames[0].time_s, 0.05);
  double least_g = 1, most_g = 0;
  for (std::size_t cell = 0; cell < 17; ++cell) {
    Eigen::Array3d mean = Eigen::Array3d::Zero(), squares = Eigen::Array3d::Zero(), products = Eigen::Array3d::Zero();
    for (const SampleFrame& frame : frames) mean += frame.samples[cell].acceleration_g.array() / 2000;
    for (std::size_t k = 1; k < frames.size(); ++k) {
      const Eigen::Array3d now = frames[k].samples[cell].acceleration_g.array() - mean;
      squares += now * now;
      products += now * (frames[k - 1].samples[cell].acceleration_g.array() - mean);
    }
    const Eigen::Array3d rms = (squares / 1999).sqrt();
    least_g = std::min(least_g, rms.minCoeff());
    most_g = std::max(most_g, rms.maxCoeff());
    // The sensors' own noise, 11 mg, comes on top and is white.
    EXPECT_GT((products / squares).minCoeff(), -0.1);
    EXPECT_LT((products / squares).maxCoeff(), 0.4);
  }
  EXPECT_GT(least_g, 0.012);
  EXPECT_LT(most_g, 0.040);
  EXPECT_GT(most_g - least_g, 0.010);
}

TEST(SimulatedRobotMotion, TurnsAboutOneAxisAndHolds) {
  SimulatedSkinOptions options = SimulatedSkinOptions::robot();
  options.least_vibration_g = options.most_vibration_g = 0;
  options.sensor_errors = options.sensor_noise = false;
  SimulatedSkin skin = x17(options);
  double held_s = 0, longest_s = 0;
  int holds = 0;
  Eigen::Vector3d before = upSeenBy(skin, skin.next(), 0);
  for (int tick = 0; tick < 20 * 120; ++tick) {
    const Eigen::Vector3d now = upSeenBy(skin, skin.next(), 0);
    EXPECT_NEAR(now.x(), 0, 0.02) << "its axis";
    EXPECT_GT(now.z(), std::cos(61 * kDegree));
    const double moved_rad = angleBetween(before, now);
    EXPECT_LT(moved_rad, 22 * kDegree / 20) << "20 degrees a second";
    if (moved_rad < 1e-9) {
      held_s += 0.05;
      if (held_s > 2.8 && held_s - 0.05 <= 2.8) ++holds;
      longest_s = std::max(longest_s, held_s);
    } else {
      held_s = 0;
    }
    before = now;
  }
  EXPECT_GE(holds, 8);
  EXPECT_LT(longest_s, 8.2);
}

TEST(SimulatedRobotMotion, RefusesAVibrationThatEndsBeforeItBegins) {
  SimulatedSkinOptions options = SimulatedSkinOptions::robot();
  options.least_vibration_g = 0.04;
  EXPECT_THROW(x17(options), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
