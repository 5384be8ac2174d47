// Streams as devices send them: late, in parts, with gaps, with slow and silent cells, as means.

#include "tests/core/capture/pose_recorder_fixture.h"
#include "tests/support/options.h"

#include <span>

namespace hexoderm::pose_recorder_test {
namespace {

TEST_F(PoseRecorderTest, IgnoresAndCountsLateFrames) {
  SyntheticStream stream = held(2, cells(2));
  std::vector<SampleFrame> frames;
  for (std::size_t k = 0; k < stream.frames.size(); ++k) {
    frames.push_back(stream.frames[k]);
    if (k % 10 == 9) {
      SampleFrame late = stream.frames[k - k % 20 / 10 * 5];  // twice, or late
      for (CellSample& sample : late.samples) sample.acceleration_g = -sample.acceleration_g;
      frames.push_back(late);
    }
  }
  frames.push_back({std::numeric_limits<double>::quiet_NaN(), {}});
  frames.push_back(stream.frames.back());
  frames.back().time_s += 0.06;
  feed(recorder_, frames);
  EXPECT_THAT(captures_.poses, SizeIs(1));
  EXPECT_EQ(captures_.holds.back().late_frames, stream.frames.size() / 10 + 1);
}

/// Splits frames, like a device whose messages are too short for all its cells.
std::vector<SampleFrame> inParts(const std::vector<SampleFrame>& frames, std::size_t cells_in_part) {
  std::vector<SampleFrame> parts;
  for (const SampleFrame& frame : frames) {
    for (std::size_t k = 0; k < frame.samples.size(); ++k) {
      if (k % cells_in_part == 0) parts.push_back({frame.time_s});
      parts.back().samples.push_back(frame.samples[k]);
    }
  }
  return parts;
}

TEST_F(PoseRecorderTest, TakesATickThatComesInSeveralFramesAsOne) {
  SyntheticStream stream = held(2, cells(5));
  Captures whole;
  PoseRecorder first(whole);
  first.setSkin(skinOf(5));
  feed(first, stream.frames);
  ASSERT_THAT(whole.poses, SizeIs(1));
  recorder_.setSkin(skinOf(5));
  std::vector<SampleFrame> parts = inParts(stream.frames, 2);
  feed(recorder_, parts);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  EXPECT_THAT(captures_.poses[0].silent_cells, IsEmpty());
  EXPECT_EQ(captures_.holds.back().late_frames, 0U);
  ASSERT_THAT(captures_.poses[0].pose->samples, SizeIs(5));
  for (std::size_t k = 0; k < 5; ++k) {
    const GravitySample& sample = captures_.poses[0].pose->samples[k];
    const GravitySample& expected = whole.poses[0].pose->samples[k];
    EXPECT_EQ(sample.cell, expected.cell);
    EXPECT_EQ(sample.count, expected.count);
    EXPECT_LT((sample.mean_g - expected.mean_g).norm(), 1e-3) << "by a sample more or less at its ends";
  }

  // A repetition is not another part.
  recorder_.addFrame(parts.back());
  recorder_.addFrame(parts[parts.size() - 3]);
  const SampleFrame later{stream.frames.back().time_s + 0.06, stream.frames.back().samples};
  recorder_.addFrame(later);
  EXPECT_EQ(captures_.holds.back().late_frames, 2U);
}

TEST_F(PoseRecorderTest, GoesOnAfterTheDevicesClockWasSetBack) {
  SyntheticStream stream = held(2, cells(2));
  feed(recorder_, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  stream.frames.clear();
  stream.move(60 * kDegree, 1);
  stream.hold(3);
  for (SampleFrame& frame : stream.frames) frame.time_s -= 12;
  feed(recorder_, stream.frames);
  EXPECT_THAT(captures_.poses, SizeIs(2));
  EXPECT_EQ(captures_.holds.back().late_frames, 0U) << "a new clock is not late";

  for (SampleFrame& frame : stream.frames) frame.time_s -= 12;
  feed(recorder_, inParts(stream.frames, 1));
  EXPECT_THAT(captures_.poses, SizeIs(3));
  EXPECT_EQ(captures_.holds.back().late_frames, 0U);
}

TEST_F(PoseRecorderTest, DoesNotWaitForCellsThatFallSilent) {
  SyntheticStream stream = held(6, cells(4));
  for (SampleFrame& frame : stream.frames) {
    std::erase_if(frame.samples,
                  [&](const CellSample& sample) { return sample.cell == CellId(2) && frame.time_s > 10.9; });
  }
  PoseRecorder recorder(captures_, test::with(&PoseRecorderOptions::samples_per_cell, 500));
  recorder.setSkin(skinOf(5));
  feed(recorder, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  const CapturedPose& captured = captures_.poses.front();
  EXPECT_LT(captured.end_s, 13);
  EXPECT_THAT(captured.short_cells, ElementsAre(CellId(2)));
  EXPECT_THAT(captured.silent_cells, ElementsAre(CellId(5)));
  ASSERT_THAT(captured.pose->samples, SizeIs(4));
  EXPECT_LT(captured.pose->samples[1].count, 200U);
  EXPECT_EQ(captured.pose->samples[0].count, 500U);
}

TEST_F(PoseRecorderTest, GivesSlowCellsAsLongAgainAsTheOthersTook) {
  SyntheticStream stream = held(3, cells(4));
  for (std::size_t k = 0; k < stream.frames.size(); ++k) {
    if (k % 20 != 0) stream.frames[k].samples.resize(3);
  }
  feed(recorder_, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  EXPECT_NEAR(captures_.poses.front().end_s - captures_.poses.front().start_s, 0.2, 0.06);
  EXPECT_THAT(captures_.poses.front().short_cells, ElementsAre(CellId(4)));
  EXPECT_NEAR(captures_.poses.front().pose->samples[3].count, 10, 3);
}

TEST_F(PoseRecorderTest, PoolsMeansThatTheDeviceMadeByTheirCounts) {
  SyntheticStream stream = held(4, cells(2));
  std::vector<SampleFrame> means;
  for (std::size_t k = 0, size = 10; k + size <= stream.frames.size(); k += size, size = 10 + (k / 10) % 21) {
    const auto batch = std::span(stream.frames).subspan(k, size);
    SampleFrame frame{batch.back().time_s};
    for (const GravitySample& sample : averageFrames(batch, PoseId(1), {}).samples) {
      frame.means.push_back({sample.cell, sample.mean_g, sample.count * sample.cov_g2.diagonal(), sample.count});
    }
    means.push_back(frame);
  }
  feed(recorder_, means);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  const CapturedPose& captured = captures_.poses.front();
  // The first mean after the start may reach back beyond it and is left out.
  const auto first = std::ranges::find_if(means, [&](const SampleFrame& f) { return f.time_s > captured.start_s; });
  const PoseCapture expected = averageFrames(between(stream.frames, first->time_s, captured.end_s), PoseId(1), {});
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(captured.pose->samples[k].count, expected.samples[k].count);
    EXPECT_GE(captured.pose->samples[k].count, 100U);
    EXPECT_LT((captured.pose->samples[k].mean_g - expected.samples[k].mean_g).norm(), 1e-12);
    // The device tells the variances within its means only along the axes.
    EXPECT_LT((captured.pose->samples[k].cov_g2 - expected.samples[k].cov_g2).diagonal().norm(), 1e-15);
  }
}

}  // namespace
}  // namespace hexoderm::pose_recorder_test
