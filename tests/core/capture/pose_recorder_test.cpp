#include "hexoderm/capture/pose_recorder.h"

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/util/error.h"
#include "tests/core/capture/captures_of.h"
#include "tests/core/capture/synthetic_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace hexoderm {
namespace {

using test::Captures;
using test::StreamOptions;
using test::SyntheticStream;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

SkinDescription skinOf(std::size_t cells, double rate_hz = 1000) {
  SkinDescription skin;
  auto model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  model->accelerometer.rate_hz = rate_hz;
  skin.model = std::move(model);
  for (std::size_t k = 1; k <= cells; ++k) {
    CellReport cell;
    cell.id = CellId(static_cast<std::uint32_t>(k));
    skin.neighbors.push_back(cell);
  }
  return skin;
}

void feed(PoseRecorder& recorder, const std::vector<SampleFrame>& frames) {
  for (const SampleFrame& frame : frames) recorder.addFrame(frame);
}

StreamOptions cells(std::size_t count, double rate_hz = 1000) {
  StreamOptions options;
  options.cells = count;
  options.rate_hz = rate_hz;
  return options;
}

/// Frames of [from, to] in device time.
std::vector<SampleFrame> between(const std::vector<SampleFrame>& frames, double after_s, double to_s) {
  std::vector<SampleFrame> some;
  for (const SampleFrame& frame : frames) {
    if (frame.time_s > after_s && frame.time_s <= to_s) some.push_back(frame);
  }
  return some;
}

TEST(PoseRecorder, CapturesTheMeanOfEveryCellWithCovarianceAndCount) {
  SyntheticStream stream(cells(3));
  stream.hold(2);
  Captures captures;
  PoseRecorderOptions options;
  options.keep_frames = true;
  options.wall_clock_ms = [] { return std::int64_t{1234567}; };
  PoseRecorder recorder(captures, options);
  recorder.setSkin(skinOf(3));
  recorder.setNextPoseId(PoseId(7));
  for (SampleFrame& frame : stream.frames) frame.temperatures.push_back({CellId(2), 31.5});
  feed(recorder, stream.frames);

  ASSERT_THAT(captures.poses, SizeIs(1));
  const CapturedPose& captured = captures.poses.front();
  EXPECT_EQ(captured.pose->id, PoseId(7));
  EXPECT_EQ(captured.pose->taken_at_ms, 1234567);
  EXPECT_FALSE(captured.forced);
  EXPECT_FALSE(captured.repeats);
  EXPECT_THAT(captured.silent_cells, IsEmpty());
  EXPECT_THAT(captured.short_cells, IsEmpty());
  EXPECT_NEAR(captured.end_s - captured.start_s, 0.1, 1e-6);
  EXPECT_THAT(captured.frames, SizeIs(100));
  const PoseCapture expected = averageFrames(between(stream.frames, captured.start_s, captured.end_s), PoseId(7), {});
  ASSERT_THAT(captured.pose->samples, SizeIs(3));
  for (std::size_t k = 0; k < 3; ++k) {
    const GravitySample& sample = captured.pose->samples[k];
    EXPECT_EQ(sample.cell, expected.samples[k].cell);
    EXPECT_EQ(sample.count, 100U);
    EXPECT_EQ(sample.mean_g, expected.samples[k].mean_g);
    EXPECT_EQ(sample.cov_g2, expected.samples[k].cov_g2);
    EXPECT_EQ(sample.temperature_c, k == 1 ? std::optional(31.5) : std::nullopt);
  }
}

TEST(PoseRecorder, HandsOverWhereTheRobotsJointsStoodMeanwhile) {
  SyntheticStream stream(cells(3));
  stream.hold(2);
  const auto captured = [&](double joints_from_s, double joints_to_s) {
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin(skinOf(3));
    double next_s = joints_from_s;
    for (const SampleFrame& frame : stream.frames) {
      if (frame.time_s >= next_s && frame.time_s <= joints_to_s) {
        recorder.addJoints({frame.time_s, {{{"elbow", frame.time_s}, {"wrist", 0.25}}}});
        next_s += 0.02;
      }
      recorder.addFrame(frame);
    }
    EXPECT_THAT(captures.poses, SizeIs(1));
    return captures.poses.front();
  };
  const double begin_s = stream.frames.front().time_s;
  const CapturedPose with = captured(begin_s, begin_s + 10);
  ASSERT_EQ(with.joint_angles.positions.size(), 2U);
  EXPECT_NEAR(with.joint_angles.positions.at("elbow"), (with.start_s + with.end_s) / 2, 0.011);
  EXPECT_EQ(with.joint_angles.positions.at("wrist"), 0.25);

  // The last word counts for a second.
  EXPECT_EQ(captured(with.start_s - 0.5, with.start_s - 0.4).joint_angles.positions.size(), 2U);
  EXPECT_TRUE(captured(begin_s + 100, begin_s + 200).joint_angles.positions.empty());
}

TEST(PoseRecorder, TakesAsManySamplesAsTheRateAllows) {
  const auto samplesAt = [](double model_hz, double rate_hz, std::uint32_t asked) {
    SyntheticStream stream(cells(2, rate_hz));
    stream.hold(5);
    Captures captures;
    PoseRecorderOptions options;
    options.samples_per_cell = asked;
    PoseRecorder recorder(captures, options);
    recorder.setSkin(skinOf(2, model_hz));
    feed(recorder, stream.frames);
    return captures.poses.empty() ? 0U : captures.poses.front().pose->samples.front().count;
  };
  EXPECT_EQ(samplesAt(1000, 1000, 0), 100U);
  EXPECT_EQ(samplesAt(200, 200, 0), 100U);
  EXPECT_NEAR(samplesAt(1000, 100, 0), 75, 3);
  EXPECT_NEAR(samplesAt(50, 50, 0), 38, 2);
  EXPECT_EQ(samplesAt(1000, 10, 0), 10U);
  EXPECT_EQ(samplesAt(100, 100, 120), 120U);
}

/// Feeds holds of a simulated skin, joined by moves of 1 s in which every cell's reading goes straight to where it will
/// be and is 1 g. Calls `after_hold` with the frames of each.
template <class AfterMove, class AfterHold>
void feedHolds(SimulatedSkin& skin, PoseRecorder& recorder, std::size_t poses, std::size_t hold_frames,
               const AfterMove& after_move, const AfterHold& after_hold) {
  double time_s = 0;
  std::vector<CellSample> last;
  for (const Eigen::Vector3d& up : scriptedUpDirections(poses)) {
    std::vector<SampleFrame> hold = skin.record(up, hold_frames);
    for (int k = 1; k < 1000 && !last.empty(); ++k) {
      SampleFrame move;
      move.time_s = time_s += 0.001;
      for (std::size_t c = 0; c < last.size(); ++c) {
        const Eigen::Vector3d& from = last[c].acceleration_g;
        const Eigen::Vector3d& to = hold.front().samples[c].acceleration_g;
        move.samples.push_back({last[c].cell, from == to ? from : (from + k * (to - from) / 1000).normalized()});
      }
      recorder.addFrame(move);
    }
    after_move();
    for (SampleFrame& frame : hold) {
      frame.time_s = time_s += 0.001;
      recorder.addFrame(frame);
    }
    last = hold.back().samples;
    after_hold(hold);
  }
}

TEST(PoseRecorder, CapturesEveryHoldOfASimulatedSkinOnce) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedSkinOptions options;
    options.seed = seed;
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin({Message::verbatim("simulated"), std::make_shared<CellModel>(skin.model()), skin.neighbors()});
    std::size_t held = 0;
    feedHolds(
        skin, recorder, 4, 1500, [&] { EXPECT_THAT(captures.poses, SizeIs(held)) << "captured on the way"; },
        [&](const std::vector<SampleFrame>& hold) {
          ++held;
          ASSERT_THAT(captures.poses, SizeIs(held))
              << "seed " << seed << ": " << captures.holds.back().message.english();
          const PoseCapture& pose = *captures.poses.back().pose;
          const PoseCapture expected = averageFrames(hold, PoseId(1), {});
          EXPECT_EQ(pose.id, PoseId(static_cast<std::uint32_t>(held)));
          ASSERT_THAT(pose.samples, SizeIs(17));
          for (std::size_t c = 0; c < 17; ++c) {
            EXPECT_LT(angleBetween(pose.samples[c].mean_g, expected.samples[c].mean_g), 2 * kDegree);
          }
        });
  }
}

TEST(PoseRecorder, ABrokenCellKeepsNothingFromBeingCaptured) {
  for (const SkinFault fault : {SkinFault::Dead, SkinFault::Stuck, SkinFault::StuckAxis, SkinFault::Saturated,
                                SkinFault::Noisy, SkinFault::NoSamples, SkinFault::WrongGain, SkinFault::DeadAxis}) {
    SimulatedSkinOptions options;
    options.faults = {{fault, CellId(1)}, {fault, CellId(9)}, {fault, CellId(14)}};
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin({Message::verbatim("simulated"), std::make_shared<CellModel>(skin.model()), skin.neighbors()});
    std::size_t held = 0;
    feedHolds(
        skin, recorder, 3, 4500, [&] { EXPECT_THAT(captures.poses, SizeIs(held)); },
        [&](const std::vector<SampleFrame>&) {
          ++held;
          EXPECT_THAT(captures.poses, SizeIs(held))
              << "fault " << static_cast<int>(fault) << ": " << captures.holds.back().message.english();
        });
    if (fault == SkinFault::NoSamples) {
      EXPECT_THAT(captures.poses.back().silent_cells, ElementsAre(CellId(1), CellId(9), CellId(14)));
    }
  }
}

TEST(PoseRecorder, MotionStartsTheHoldOver) {
  SyntheticStream stream(cells(3));
  stream.hold(1.2);
  stream.move(30 * kDegree, 0.5);
  const double held_from_s = stream.hold(4).first;
  Captures captures;
  PoseRecorderOptions options;
  options.samples_per_cell = 1000;
  PoseRecorder recorder(captures, options);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  EXPECT_GT(captures.poses.front().start_s, held_from_s);
  EXPECT_EQ(captures.poses.front().pose->samples.front().count, 1000U);
  EXPECT_EQ(captures.holds.back().restarts, 1U);

  // The ring grows while the part is held, falls with the motion, and ends full.
  double before_move = 0, after_move = 1, last = 0;
  for (const HoldStatus& hold : captures.holds) {
    const double time_s = hold.stillness.time_s;
    EXPECT_GE(hold.progress, 0);
    EXPECT_LE(hold.progress, 1);
    if (time_s < 11.2) before_move = std::max(before_move, hold.progress);
    if (time_s > 11.4 && time_s < 11.8) after_move = std::min(after_move, hold.progress);
    if (time_s <= captures.poses.front().end_s + 0.1) last = hold.progress;
  }
  EXPECT_GT(before_move, 0.4);
  EXPECT_LT(after_move, 0.1);
  EXPECT_GT(last, 0.9);
}

TEST(PoseRecorder, WaitsForTheOperatorUnlessItIsAutomatic) {
  SyntheticStream stream(cells(2));
  stream.hold(2);
  Captures captures;
  PoseRecorderOptions options;
  options.automatic = false;
  PoseRecorder recorder(captures, options);
  feed(recorder, stream.frames);
  EXPECT_THAT(captures.poses, IsEmpty());
  EXPECT_EQ(captures.holds.back().message.english(), "Still: ready to capture");

  recorder.setAutomatic(true);
  stream.frames.clear();
  stream.hold(1);
  feed(recorder, stream.frames);
  EXPECT_THAT(captures.poses, SizeIs(1));
}

TEST(PoseRecorder, CapturesAnywayWhenAsked) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 2);
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, IsEmpty());
  recorder.captureNow();
  stream.frames.clear();
  stream.turn(20 * kDegree, 1);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  EXPECT_TRUE(captures.poses.front().forced);
  EXPECT_EQ(captures.poses.front().start_s, stream.frames.front().time_s);
  EXPECT_EQ(captures.poses.front().pose->samples.front().count, 100U);
  // The next samples, from the first on.
  const PoseCapture expected = averageFrames(std::span(stream.frames).first(100), PoseId(1), {});
  EXPECT_EQ(captures.poses.front().pose->samples.front().mean_g, expected.samples.front().mean_g);
}

TEST(PoseRecorder, CapturesAnywayWithTheVeryFirstSamples) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 0.3);
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.captureNow();
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  EXPECT_THAT(captures.poses.front().pose->samples, SizeIs(2));
}

TEST(PoseRecorder, GivesUpACaptureWhenAsked) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 1);
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.captureNow();
  feed(recorder, between(stream.frames, 0, 10.05));
  recorder.cancelCapture();
  feed(recorder, between(stream.frames, 10.05, 20));
  EXPECT_THAT(captures.poses, IsEmpty());
}

TEST(PoseRecorder, NamesThePoseThatIsRepeated) {
  SyntheticStream stream(cells(3));
  stream.hold(2);
  const Eigen::Vector3d axis = stream.someAxis();
  stream.turnAbout(axis, 80 * kDegree, 1);
  stream.hold(2);
  stream.turnAbout(axis, -76 * kDegree, 1);
  stream.hold(2);
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(3));
  EXPECT_FALSE(captures.poses[0].repeats);
  EXPECT_FALSE(captures.poses[1].repeats);
  EXPECT_EQ(captures.poses[2].repeats, PoseId(1));
  EXPECT_NEAR(toDegrees(captures.poses[2].repeat_angle_rad), 4, 0.5);

  // The session's own list counts: without the first pose nothing is repeated.
  Captures again;
  PoseRecorder other(again);
  other.setEarlierPoses({captures.poses[1].pose});
  stream.frames.clear();
  stream.hold(2);
  feed(other, stream.frames);
  ASSERT_THAT(again.poses, SizeIs(1));
  EXPECT_FALSE(again.poses[0].repeats);
}

TEST(PoseRecorder, IgnoresAndCountsLateFrames) {
  SyntheticStream stream(cells(2));
  stream.hold(2);
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
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, frames);
  EXPECT_THAT(captures.poses, SizeIs(1));
  EXPECT_EQ(captures.holds.back().late_frames, stream.frames.size() / 10 + 1);
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

TEST(PoseRecorder, TakesATickThatComesInSeveralFramesAsOne) {
  SyntheticStream stream(cells(5));
  stream.hold(2);
  Captures whole;
  PoseRecorder first(whole);
  first.setSkin(skinOf(5));
  feed(first, stream.frames);
  ASSERT_THAT(whole.poses, SizeIs(1));
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.setSkin(skinOf(5));
  std::vector<SampleFrame> parts = inParts(stream.frames, 2);
  feed(recorder, parts);
  ASSERT_THAT(captures.poses, SizeIs(1));
  EXPECT_THAT(captures.poses[0].silent_cells, IsEmpty());
  EXPECT_EQ(captures.holds.back().late_frames, 0U);
  ASSERT_THAT(captures.poses[0].pose->samples, SizeIs(5));
  for (std::size_t k = 0; k < 5; ++k) {
    const GravitySample& sample = captures.poses[0].pose->samples[k];
    const GravitySample& expected = whole.poses[0].pose->samples[k];
    EXPECT_EQ(sample.cell, expected.cell);
    EXPECT_EQ(sample.count, expected.count);
    EXPECT_LT((sample.mean_g - expected.mean_g).norm(), 1e-3) << "by a sample more or less at its ends";
  }

  // A repetition is not another part.
  recorder.addFrame(parts.back());
  recorder.addFrame(parts[parts.size() - 3]);
  const SampleFrame later{stream.frames.back().time_s + 0.06, stream.frames.back().samples};
  recorder.addFrame(later);
  EXPECT_EQ(captures.holds.back().late_frames, 2U);
}

TEST(PoseRecorder, GoesOnAfterTheDevicesClockWasSetBack) {
  SyntheticStream stream(cells(2));
  stream.hold(2);
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  stream.frames.clear();
  stream.move(60 * kDegree, 1);
  stream.hold(3);
  for (SampleFrame& frame : stream.frames) frame.time_s -= 12;
  feed(recorder, stream.frames);
  EXPECT_THAT(captures.poses, SizeIs(2));
  EXPECT_EQ(captures.holds.back().late_frames, 0U) << "a new clock is not late";

  for (SampleFrame& frame : stream.frames) frame.time_s -= 12;
  feed(recorder, inParts(stream.frames, 1));
  EXPECT_THAT(captures.poses, SizeIs(3));
  EXPECT_EQ(captures.holds.back().late_frames, 0U);
}

TEST(PoseRecorder, DoesNotWaitForCellsThatFallSilent) {
  SyntheticStream stream(cells(4));
  stream.hold(6);
  for (SampleFrame& frame : stream.frames) {
    std::erase_if(frame.samples,
                  [&](const CellSample& sample) { return sample.cell == CellId(2) && frame.time_s > 10.9; });
  }
  Captures captures;
  PoseRecorderOptions options;
  options.samples_per_cell = 500;
  PoseRecorder recorder(captures, options);
  recorder.setSkin(skinOf(5));
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  const CapturedPose& captured = captures.poses.front();
  EXPECT_LT(captured.end_s, 13);
  EXPECT_THAT(captured.short_cells, ElementsAre(CellId(2)));
  EXPECT_THAT(captured.silent_cells, ElementsAre(CellId(5)));
  ASSERT_THAT(captured.pose->samples, SizeIs(4));
  EXPECT_LT(captured.pose->samples[1].count, 200U);
  EXPECT_EQ(captured.pose->samples[0].count, 500U);
}

TEST(PoseRecorder, GivesSlowCellsAsLongAgainAsTheOthersTook) {
  SyntheticStream stream(cells(4));
  stream.hold(3);
  for (std::size_t k = 0; k < stream.frames.size(); ++k) {
    if (k % 20 != 0) stream.frames[k].samples.resize(3);
  }
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, stream.frames);
  ASSERT_THAT(captures.poses, SizeIs(1));
  EXPECT_NEAR(captures.poses.front().end_s - captures.poses.front().start_s, 0.2, 0.06);
  EXPECT_THAT(captures.poses.front().short_cells, ElementsAre(CellId(4)));
  EXPECT_NEAR(captures.poses.front().pose->samples[3].count, 10, 3);
}

TEST(PoseRecorder, BearsDropOuts) {
  StreamOptions options = cells(6, 200);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    options.seed = seed;
    SyntheticStream stream(options);
    stream.hold(4);
    stream.move(40 * kDegree, 1);
    stream.hold(4);
    std::mt19937 random(seed);
    std::erase_if(stream.frames, [&](const SampleFrame&) { return random() % 10 < 2; });
    for (SampleFrame& frame : stream.frames) {
      std::erase_if(frame.samples, [&](const CellSample&) { return random() % 10 < 3; });
    }
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin(skinOf(6, 200));
    feed(recorder, stream.frames);
    EXPECT_THAT(captures.poses, SizeIs(2)) << seed;
    for (const CapturedPose& captured : captures.poses) EXPECT_THAT(captured.pose->samples, SizeIs(6));
  }
}

TEST(PoseRecorder, PoolsMeansThatTheDeviceMadeByTheirCounts) {
  SyntheticStream stream(cells(2));
  stream.hold(4);
  std::vector<SampleFrame> means;
  for (std::size_t k = 0, size = 10; k + size <= stream.frames.size(); k += size, size = 10 + (k / 10) % 21) {
    const auto batch = std::span(stream.frames).subspan(k, size);
    SampleFrame frame;
    frame.time_s = batch.back().time_s;
    for (const GravitySample& sample : averageFrames(batch, PoseId(1), {}).samples) {
      frame.means.push_back({sample.cell, sample.mean_g, sample.count * sample.cov_g2.diagonal(), sample.count});
    }
    means.push_back(frame);
  }
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, means);
  ASSERT_THAT(captures.poses, SizeIs(1));
  const CapturedPose& captured = captures.poses.front();
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

TEST(PoseRecorder, ShowsThePresentReadingsAtMostTwentyTimesASecond) {
  SyntheticStream stream(cells(3));
  stream.hold(3);
  stream.frames[10].temperatures.push_back({CellId(2), 31.5});
  stream.frames[1000].temperatures.push_back({CellId(2), 32.5});
  Captures captures;
  PoseRecorder recorder(captures);
  feed(recorder, stream.frames);
  EXPECT_NEAR(static_cast<double>(captures.previews.size()), 59, 1);
  EXPECT_EQ(captures.holds.size(), captures.previews.size());
  const SkinPreview& preview = captures.previews.back();
  ASSERT_THAT(preview.temperatures, SizeIs(1));
  EXPECT_EQ(preview.temperatures[0].cell, CellId(2));
  EXPECT_EQ(preview.temperatures[0].temperature_c, 32.5) << "the last one said";
  const PoseCapture recent =
      averageFrames(between(stream.frames, preview.time_s - 0.1005, preview.time_s - 0.0005), PoseId(1), {});
  ASSERT_THAT(preview.means, SizeIs(3));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(preview.means[k].cell, recent.samples[k].cell);
    EXPECT_LT((preview.means[k].acceleration_g - recent.samples[k].mean_g).norm(), 1e-6);
  }
}

TEST(PoseRecorder, StartsOverWithAnotherSkin) {
  SyntheticStream stream(cells(3));
  stream.hold(2);
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.setSkin(skinOf(3));
  feed(recorder, stream.frames);
  recorder.setSkin(skinOf(3, 500));
  for (SampleFrame& frame : stream.frames) frame.time_s -= 9;
  feed(recorder, stream.frames);
  EXPECT_THAT(captures.poses, SizeIs(2));
  EXPECT_EQ(captures.holds.back().late_frames, 0U);
}

/// Holds of one cell or several, at many rates, with and without noise, apart by moves of 6 to 180 degrees, and slow
/// turns of 3 deg/s: every hold is captured, and nothing while the part turns.
TEST(PoseRecorder, CapturesHoldsAndNothingElse) {
  int holds = 0, captured_holds = 0;
  unsigned seed = 0;
  for (const double rate_hz : {50.0, 100.0, 333.0, 1000.0}) {
    for (const double noise_g : {0.0003, 0.003, 0.011}) {
      StreamOptions options = cells(1 + seed % 3, rate_hz);
      options.noise_g = noise_g;
      options.lsb_g = noise_g / 3;
      options.offset_g = 0.1;
      options.gain = 0.9;
      options.jitter = 0.05;
      options.seed = ++seed;
      SyntheticStream stream(options);
      std::vector<std::pair<double, double>> truth = {stream.hold(3)};
      for (const double angle_deg : {6.0, 90.0, 15.0, 180.0}) {
        const double speed_deg_s = std::exp(stream.uniform(std::log(15), std::log(200)));
        stream.move(angle_deg * kDegree, std::max(0.3, angle_deg / speed_deg_s));
        stream.turn(3 * kDegree, 3);
        truth.push_back(stream.hold(stream.uniform(2.5, 6)));
      }
      Captures captures;
      PoseRecorder recorder(captures);
      recorder.setSkin(skinOf(options.cells, rate_hz));
      feed(recorder, stream.frames);
      holds += static_cast<int>(truth.size());
      for (const CapturedPose& captured : captures.poses) {
        // At the end of a move the part counts as still a little early, once its speed is below 1 deg/s.
        const bool inside = std::ranges::any_of(truth, [&](const auto& hold) {
          return captured.start_s >= hold.first - 0.2 && captured.end_s <= hold.second;
        });
        EXPECT_TRUE(inside) << "seed " << seed << ": captured from " << captured.start_s << " s on";
        captured_holds += inside ? 1 : 0;
      }
      EXPECT_LE(captures.poses.size(), truth.size()) << "seed " << seed;
    }
  }
  EXPECT_EQ(captured_holds, holds);
}

TEST(PoseRecorder, RefusesOptionsThatMakeNoSense) {
  Captures captures;
  PoseRecorderOptions options;
  options.collect_s = 0;
  EXPECT_THROW(PoseRecorder(captures, options), InvalidArgument);
  options = {};
  options.repeat_angle_rad = -1;
  EXPECT_THROW(PoseRecorder(captures, options), InvalidArgument);
  options = {};
  options.stillness.hold_s = -1;
  EXPECT_THROW(PoseRecorder(captures, options), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
