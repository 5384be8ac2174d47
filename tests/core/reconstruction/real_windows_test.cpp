// Motionless windows of very different length of a real robot's leg.

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/hold_out.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

TEST(RealWindows, OfAnyLengthAreForetoldAsStated) {
  const Session session =
      readSessionJson(HEXODERM_REFERENCE_DATA "/real/icub_leg/one_long_and_twelve_short_windows.session.json");
  ASSERT_EQ(session.poses().size(), 15U);
  std::vector<double> ratios;
  for (const SessionPose& pose : session.poses()) {
    const HoldOutResult result = evaluateHoldOut(*session.snapshot(), pose.capture->id);
    ASSERT_EQ(result.outcome, HoldOutOutcome::Evaluated);
    const double ratio = result.rms_rad / result.expected_rms_rad;
    EXPECT_EQ(result.agreement, HoldOutAgreement::AsStated)
        << "pose " << pose.capture->id.value() << ": rms " << ratio << " times what is expected, turning "
        << result.turning_rad_s2 / result.expected_turning_rad_s2;
    ratios.push_back(ratio);
  }
  std::ranges::sort(ratios);
  EXPECT_GT(ratios[7], 0.7);
  EXPECT_LT(ratios[7], 1.3);
}

}  // namespace
}  // namespace hexoderm
