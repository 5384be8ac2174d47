#include "hexoderm/capture/calm_up.h"

#include "tests/support/normal_draw.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Eigen::Vector3d turned(double angle_deg) {
  return expSO3(angle_deg * kDegree * Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitZ();
}

/// How a hand trembles: 0.6 degrees, 1 sigma, about each of two axes, as the readings of a tenth of a second have it.
Eigen::Vector3d trembling(test::NormalDraw& draw, const Eigen::Vector3d& up) {
  return expSO3(0.6 * kDegree * draw.vector()) * up;
}

TEST(CalmUp, APartThatIsHeldStaysWhereItIs) {
  CalmUp calm;
  test::NormalDraw draw(7);
  Eigen::Vector3d shown = *calm.follow(trembling(draw, Eigen::Vector3d::UnitZ()));
  int moves = 0;
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Vector3d next = *calm.follow(trembling(draw, Eigen::Vector3d::UnitZ()));
    moves += next != shown;
    shown = next;
  }
  EXPECT_LT(moves, 50) << "of a thousand readings";
  EXPECT_LT(angleBetween(shown, Eigen::Vector3d::UnitZ()), CalmUp::kMovesOn_rad + 0.5 * kDegree);
}

TEST(CalmUp, ALargeMoveIsFollowedAtOnce) {
  CalmUp calm;
  test::NormalDraw draw(7);
  for (int k = 0; k < 100; ++k) calm.follow(trembling(draw, Eigen::Vector3d::UnitZ()));
  EXPECT_EQ(*calm.follow(turned(30)), turned(30));
  EXPECT_EQ(*calm.follow(turned(60)), turned(60));
}

TEST(CalmUp, ASlowTurnIsFollowedAndNotLostInSmallSteps) {
  CalmUp calm;
  test::NormalDraw draw(7);
  for (int k = 0; k < 100; ++k) calm.follow(trembling(draw, Eigen::Vector3d::UnitZ()));
  // Half a degree a second.
  std::optional<Eigen::Vector3d> shown;
  double farthest = 0;
  for (int k = 0; k < 800; ++k) {
    const Eigen::Vector3d is = turned(0.025 * k);
    shown = calm.follow(trembling(draw, is));
    farthest = std::max(farthest, angleBetween(*shown, is));
  }
  EXPECT_LT(toDegrees(farthest), 3);
  EXPECT_LT(toDegrees(angleBetween(*shown, turned(20))), 2);
}

TEST(CalmUp, WhatIsNotKnownIsNotShownAndBeginsAnew) {
  CalmUp calm;
  EXPECT_EQ(calm.follow(std::nullopt), std::nullopt);
  EXPECT_EQ(*calm.follow(turned(10)), turned(10));
  EXPECT_EQ(calm.follow(std::nullopt), std::nullopt);
  EXPECT_EQ(*calm.follow(turned(10.5)), turned(10.5));
}

}  // namespace
}  // namespace hexoderm
