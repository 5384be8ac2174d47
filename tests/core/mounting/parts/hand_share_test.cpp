#include "hexoderm/mounting/parts/compared_poses.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// The evidence of `count` normal errors, each of which has the mean square `seen` where a usual hand has 1.
double evidenceOf(double share, double seen, int count) { return -count / 2. * (seen / share + std::log(share)); }

double shareBy(double seen, int count) {
  return meanHandShare([&](double share) { return evidenceOf(share, seen, count); });
}

TEST(HandShare, GoesByWhatWasSeen) {
  EXPECT_NEAR(shareBy(1, 1000), 1, 0.01);
  EXPECT_NEAR(shareBy(0.25, 1000), 0.25, 0.01);
  EXPECT_NEAR(shareBy(0, 1000), 1. / 64, 1e-6);
}

TEST(HandShare, IsNeverMoreThanAUsualHands) { EXPECT_NEAR(shareBy(50, 1000), 1, 1e-6); }

// Nothing seen: the mean of all shares.
TEST(HandShare, WithoutEvidenceIsBetween) { EXPECT_NEAR(shareBy(1, 0), (2 - 1. / 64) / 7, 1e-12); }

}  // namespace
}  // namespace hexoderm
