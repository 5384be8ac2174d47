#include "hexoderm/capture/pose_recorder.h"

#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::_;
using ::testing::DoubleEq;
using ::testing::FieldsAre;

HoldStatus blockedBy(Blocker blocker, double time_s, CellId cell = {}) {
  HoldStatus hold;
  hold.stillness.blocker = blocker;
  hold.stillness.time_s = time_s;
  hold.stillness.excess_cell = hold.stillness.turning_cell = cell;
  hold.stillness.message = message("Waiting for samples");
  return hold;
}

TEST(StillnessStatistics, AddsUpWhatBlockedAndWhichCellDecided) {
  StillnessStatistics ledger;
  EXPECT_FALSE(ledger.last());
  ledger.add(blockedBy(Blocker::Waiting, 10));
  ledger.add(blockedBy(Blocker::Waiting, 11));
  ledger.add(blockedBy(Blocker::Shaking, 12, CellId(7)));
  ledger.add(blockedBy(Blocker::Shaking, 15, CellId(9)));
  ledger.add(blockedBy(Blocker::Shaking, 16, CellId(7)));
  ledger.add(blockedBy(Blocker::None, 18));
  ledger.add(test::with(blockedBy(Blocker::NotMoved, 19), &HoldStatus::phase, HoldPhase::Collecting));

  EXPECT_DOUBLE_EQ(ledger.watched_s(), 9);
  EXPECT_DOUBLE_EQ(ledger.still_s(), 3);
  const auto waiting = ::testing::Property(&Message::english, "Waiting for samples");
  EXPECT_THAT(ledger.blocked(), ElementsAre(FieldsAre(Blocker::Shaking, DoubleEq(5), CellId(9), DoubleEq(3), waiting),
                                            FieldsAre(Blocker::Waiting, DoubleEq(1), CellId(), _, waiting)));
}

TEST(StillnessStatistics, CountsNothingWhereTheClockGoesBack) {
  StillnessStatistics ledger;
  ledger.add(blockedBy(Blocker::Turning, 100));
  ledger.add(blockedBy(Blocker::Turning, 3));
  ledger.add(blockedBy(Blocker::Turning, 5));
  EXPECT_DOUBLE_EQ(ledger.watched_s(), 2);
}

}  // namespace
}  // namespace hexoderm
