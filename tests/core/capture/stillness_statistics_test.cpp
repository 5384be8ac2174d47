#include "hexoderm/capture/stillness_statistics.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

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
  HoldStatus collecting = blockedBy(Blocker::NotMoved, 19);
  collecting.phase = HoldPhase::Collecting;
  ledger.add(collecting);

  EXPECT_DOUBLE_EQ(ledger.watched_s(), 9);
  EXPECT_DOUBLE_EQ(ledger.still_s(), 3);
  const std::vector<BlockedTime> blocked = ledger.blocked();
  ASSERT_EQ(blocked.size(), 2U);
  EXPECT_EQ(blocked[0].blocker, Blocker::Shaking);
  EXPECT_DOUBLE_EQ(blocked[0].duration_s, 5);
  EXPECT_EQ(blocked[0].cell, CellId(9));
  EXPECT_DOUBLE_EQ(blocked[0].cell_s, 3);
  EXPECT_EQ(blocked[1].blocker, Blocker::Waiting);
  EXPECT_DOUBLE_EQ(blocked[1].duration_s, 1);
  EXPECT_EQ(blocked[1].cell, CellId());
  EXPECT_EQ(blocked[1].message.english(), "Waiting for samples");
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
