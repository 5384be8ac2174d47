#include "hexoderm/capture/stillness_trace.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::_;
using ::testing::FieldsAre;

constexpr double kStep_s = 0.05;

HoldStatus holdOf(std::uint32_t cell, bool armed = true, std::uint64_t restarts = 0) {
  HoldStatus hold;
  hold.stillness.excess_cell = CellId(cell);
  hold.stillness.armed = armed;
  hold.stillness.excess_limit_g = 0.030;
  hold.restarts = restarts;
  return hold;
}

SkinPreview previewOf(double time_s, double x_of_seven = 0, double x_of_nine = 0) {
  return {time_s, {{CellId(7), {x_of_seven, 0, 1}}, {CellId(9), {x_of_nine, 0, 1}}}};
}

class StillnessTraceTest : public testing::Test {
 protected:
  StillnessTrace trace_;
};

TEST_F(StillnessTraceTest, KeepsTenSecondsAndNoMore) {
  for (int k = 0; k < 1000; ++k) trace_.add(holdOf(7), previewOf(k * kStep_s));
  EXPECT_NEAR(trace_.points().back().time_s - trace_.points().front().time_s, StillnessTrace::kSpan_s, 1e-9);
  EXPECT_EQ(trace_.points().size(), 201U);
}

TEST_F(StillnessTraceTest, ACellAtRestDeviatesByNothingAndAJumpShowsAndFadesWithinASecond) {
  int k = 0;
  for (; k < 60; ++k) trace_.add(holdOf(7), previewOf(k * kStep_s, 0.2));
  EXPECT_NEAR(trace_.points().back().deviation_g->norm(), 0, 1e-12);
  trace_.add(holdOf(7), previewOf(k++ * kStep_s, 0.3));
  EXPECT_NEAR(trace_.points().back().deviation_g->x(), 0.1 * 20 / 21, 0.002);
  for (int later = 0; later < 25; ++later) trace_.add(holdOf(7), previewOf(k++ * kStep_s, 0.3));
  EXPECT_NEAR(trace_.points().back().deviation_g->norm(), 0, 1e-12);
}

TEST_F(StillnessTraceTest, ShowsTheDecisiveCellAndChangesToAnotherOnlyAfterASecond) {
  double time_s = 0;
  const auto run = [&](std::uint32_t cell, int steps) {
    for (int k = 0; k < steps; ++k) {
      time_s += kStep_s;
      trace_.add(holdOf(cell), previewOf(time_s, 0.0, std::sin(5 * time_s)));
    }
  };
  run(7, 40);
  EXPECT_EQ(trace_.cell(), CellId(7));
  run(9, 10);
  run(7, 1);
  EXPECT_EQ(trace_.cell(), CellId(7));
  run(9, 25);
  EXPECT_EQ(trace_.cell(), CellId(9));
  // Its past comes with it.
  double largest = 0;
  for (std::size_t k = 0; k < 40; ++k) largest = std::max(largest, trace_.points()[k].deviation_g->norm());
  EXPECT_GT(largest, 0.3);
}

TEST_F(StillnessTraceTest, APickedCellIsShownUntilItIsLetGo) {
  for (int k = 0; k < 20; ++k) trace_.add(holdOf(7), previewOf(k * kStep_s, 0.0, 0.1 * (k % 2)));
  trace_.pick(CellId(9));
  EXPECT_EQ(trace_.cell(), CellId(9));
  EXPECT_TRUE(trace_.isPicked());
  EXPECT_GT(trace_.points().back().deviation_g->norm(), 0.02);
  trace_.pick(std::nullopt);
  EXPECT_EQ(trace_.cell(), CellId(7));
  EXPECT_NEAR(trace_.points().back().deviation_g->norm(), 0, 1e-12);
}

TEST_F(StillnessTraceTest, ACellThatSendsNothingHasNoDeviation) {
  trace_.add(holdOf(7), previewOf(0));
  trace_.pick(CellId(5));
  trace_.add(holdOf(7), previewOf(kStep_s));
  EXPECT_FALSE(trace_.points().back().deviation_g);
}

TEST_F(StillnessTraceTest, MarksCapturesArmingAndStartsOver) {
  trace_.add(holdOf(7, true, 3), previewOf(0));
  EXPECT_TRUE(trace_.events().empty()) << "what was before it looked is no event";
  trace_.addCaptured(PoseId(4), 0.02);
  trace_.add(holdOf(7, false, 3), previewOf(1));
  trace_.add(holdOf(7, true, 3), previewOf(2));
  trace_.add(holdOf(7, true, 4), previewOf(3));
  EXPECT_THAT(trace_.events(),
              ElementsAre(FieldsAre(_, TraceEventKind::Captured, PoseId(4)),
                          FieldsAre(2, TraceEventKind::ArmedAgain, _), FieldsAre(_, TraceEventKind::StartsOver, _)));
  trace_.add(holdOf(7, true, 4), previewOf(12.5));
  EXPECT_EQ(trace_.events().size(), 1U) << "events leave with their time";
}

TEST_F(StillnessTraceTest, SaysWhatThePartDid) {
  HoldStatus hold = holdOf(7);
  trace_.add(hold, previewOf(0));
  hold.stillness.still = true;
  trace_.add(hold, previewOf(1));
  hold.phase = HoldPhase::Collecting;
  trace_.add(hold, previewOf(2));
  EXPECT_EQ(trace_.points()[0].state, TraceState::Moving);
  EXPECT_EQ(trace_.points()[1].state, TraceState::Still);
  EXPECT_EQ(trace_.points()[2].state, TraceState::Collecting);
}

TEST_F(StillnessTraceTest, StartsAnewWhenTheDevicesClockGoesBackAndIgnoresTimesThatAreNoNumber) {
  trace_.add(holdOf(7), previewOf(100));
  trace_.add(holdOf(7), previewOf(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(trace_.points().size(), 1U);
  trace_.add(holdOf(7), previewOf(1));
  EXPECT_EQ(trace_.points().size(), 1U);
  EXPECT_EQ(trace_.now_s(), 1);
}

TEST_F(StillnessTraceTest, OfALargeSkinOnlyTheShownCellsPastIsKept) {
  SkinPreview preview;
  for (std::uint32_t id = 1; id <= StillnessTrace::kMaxKeptCells + 1; ++id) {
    preview.means.push_back({CellId(id), {0.1 * id, 0, 1}});
  }
  for (int k = 0; k < 10; ++k) {
    preview.time_s = k * kStep_s;
    trace_.add(holdOf(7), preview);
  }
  EXPECT_TRUE(trace_.points().front().deviation_g);
  trace_.pick(CellId(9));
  EXPECT_FALSE(trace_.points().front().deviation_g);
  preview.time_s = 1;
  trace_.add(holdOf(7), preview);
  EXPECT_TRUE(trace_.points().back().deviation_g);
}

}  // namespace
}  // namespace hexoderm
