// What a further pose does to the stated uncertainty, on simulated skins.

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/units.h"
#include "tests/support/simulated_skins.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hexoderm {
namespace {

/// A session's first poses only.
std::shared_ptr<const Reconstruction> solveFirst(const Session& whole, std::size_t poses) {
  Session session = whole;
  while (session.poses().size() > poses) session.removePose(session.poses().size() - 1);
  return reconstruct(*session.snapshot());
}

TEST(MorePoses, NeverMakeTheStatedUncertaintyMuchWorse) {
  // A pose in which the hand swung harder than in the others may raise it, but no model switches on.
  constexpr double kMuch = 1.1;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Session session = test::simulatedSession(test::skinOptions("x17", "cylinder:r=0.0501", seed), 10);
    double before_rad = kPi;
    for (std::size_t poses = 2; poses <= 10; ++poses) {
      const auto result = solveFirst(session, poses);
      const double now_rad = *result->assessment.orientation_95_rad;
      EXPECT_LE(toDegrees(now_rad), kMuch * toDegrees(before_rad)) << "seed " << seed << ", pose " << poses;
      before_rad = now_rad;
    }
  }
}

TEST(MorePoses, AreForeseenAsTheyComeOut) {
  // The forecast of a session's assessment against what the advised pose then brings.
  double ratio_sum = 0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Session session = test::simulatedSession(test::skinOptions("x17", "", seed), 3);
    const auto two = solveFirst(session, 2);
    const auto three = solveFirst(session, 3);
    ASSERT_TRUE(two->assessment.wantsPose());
    EXPECT_LT(*three->assessment.orientation_95_rad, 0.85 * *two->assessment.orientation_95_rad);
    ratio_sum += *three->assessment.orientation_95_rad / *two->assessment.orientation_95_rad;
    ++count;
  }
  EXPECT_LT(ratio_sum / static_cast<double>(count), 0.6);
}

}  // namespace
}  // namespace hexoderm
