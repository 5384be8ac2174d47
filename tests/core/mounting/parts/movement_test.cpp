#include "hexoderm/mounting/parts/rigid_fit.h"

#include "tests/core/mounting/parts/gravity_draw.h"

namespace hexoderm {
namespace {

/// Of what two bodies see, drawn for b first: inside a call the order would be the compiler's choice.
MovementTest testDrawn(GravityDraw& draw, const std::vector<Eigen::Vector3d>& up_a,
                       const std::vector<Eigen::Vector3d>& up_b) {
  const GravitySeen b = draw.see(up_b, {});
  return testMovement(draw.see(up_a, {}), b);
}

// However many poses there are.
TEST(Movement, TurnsAboutTheLineOfGravityHide) {
  GravityDraw draw(3);
  const Eigen::Vector3d line = draw.direction();
  std::vector<Eigen::Vector3d> up;
  for (int k = 0; k < 12; ++k) up.push_back((k % 2 == 0 ? 1 : -1) * (line + 0.02 * draw.vector()).normalized());
  EXPECT_TRUE(testDrawn(draw, up, up).on_one_line);
  up.push_back(draw.direction());
  EXPECT_FALSE(testDrawn(draw, up, up).on_one_line);
}

// Whatever axis the joint has: with the turns that the test thinks of, two bodies are not taken for one.
TEST(Movement, JointsThatMoveAreNotTakenForOnePart) {
  constexpr int kSeeds = 3000;
  int apart = 0;
  int together = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    GravityDraw draw(static_cast<std::uint64_t>(seed));
    const DrawnHinge hinge = drawHinge(draw, 4, kTypicalTurn_rad);
    const MovementTest test = testDrawn(draw, hinge.up_a, hinge.up_b);
    const bool fits = test.fit.misfit.probability() >= 1e-3;
    apart += fits ? 0 : 1;
    together += fits && test.log_odds >= std::log(20) ? 1 : 0;
  }
  EXPECT_GE(apart, 0.97 * kSeeds);
  EXPECT_EQ(together, 0) << "by the limits of PartsOptions";
}

// Turns as large as are called noticeable are noticed, and those of a third of it are not.
TEST(Movement, NoticeableTurnsAreNoticed) {
  int noticed = 0;
  int unnoticed = 0;
  constexpr int kSeeds = 100;
  for (int seed = 0; seed < kSeeds; ++seed) {
    GravityDraw draw(static_cast<std::uint64_t>(seed));
    const std::vector<Eigen::Vector3d> still = draw.directions(8);
    const double noticeable = testDrawn(draw, still, still).noticeable_rad;
    EXPECT_LT(noticeable, 20 * kDegree);
    const auto isNoticed = [&](double spread_rad) {
      const DrawnHinge hinge = drawHinge(draw, 8, spread_rad);
      return testDrawn(draw, hinge.up_a, hinge.up_b).fit.misfit.probability() < 0.05;
    };
    noticed += isNoticed(3 * noticeable) ? 1 : 0;
    unnoticed += isNoticed(noticeable / 5) ? 0 : 1;
  }
  EXPECT_GE(noticed, 95);
  EXPECT_GE(unnoticed, 80);
}

}  // namespace
}  // namespace hexoderm
