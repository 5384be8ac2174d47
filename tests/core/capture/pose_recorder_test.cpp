#include "hexoderm/capture/pose_recorder.h"

#include "tests/core/capture/pose_recorder_fixture.h"
#include "tests/support/options.h"

#include <span>

namespace hexoderm::pose_recorder_test {
namespace {

TEST_F(PoseRecorderTest, CapturesTheMeanOfEveryCellWithCovarianceAndCount) {
  SyntheticStream stream = held(2, cells(3));
  PoseRecorderOptions options;
  options.keep_frames = true;
  options.wall_clock_ms = [] { return std::int64_t{1234567}; };
  PoseRecorder recorder(captures_, options);
  recorder.setSkin(skinOf(3));
  recorder.setNextPoseId(PoseId(7));
  for (SampleFrame& frame : stream.frames) frame.temperatures.push_back({CellId(2), 31.5});
  feed(recorder, stream.frames);

  ASSERT_THAT(captures_.poses, SizeIs(1));
  const CapturedPose& captured = captures_.poses.front();
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
  SyntheticStream stream = held(2, cells(3));
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
    SyntheticStream stream = held(5, cells(2, rate_hz));
    Captures captures;
    PoseRecorder recorder(captures, test::with(&PoseRecorderOptions::samples_per_cell, asked));
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

TEST_F(PoseRecorderTest, WaitsForTheOperatorUnlessItIsAutomatic) {
  SyntheticStream stream = held(2, cells(2));
  PoseRecorder recorder(captures_, test::with(&PoseRecorderOptions::automatic, false));
  feed(recorder, stream.frames);
  EXPECT_THAT(captures_.poses, IsEmpty());
  EXPECT_EQ(captures_.holds.back().message.english(), "Still: ready to capture");

  recorder.setAutomatic(true);
  stream.frames.clear();
  stream.hold(1);
  feed(recorder, stream.frames);
  EXPECT_THAT(captures_.poses, SizeIs(1));
}

TEST_F(PoseRecorderTest, CapturesAnywayWhenAsked) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 2);
  feed(recorder_, stream.frames);
  ASSERT_THAT(captures_.poses, IsEmpty());
  recorder_.captureNow();
  stream.frames.clear();
  stream.turn(20 * kDegree, 1);
  feed(recorder_, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  EXPECT_TRUE(captures_.poses.front().forced);
  EXPECT_EQ(captures_.poses.front().start_s, stream.frames.front().time_s);
  EXPECT_EQ(captures_.poses.front().pose->samples.front().count, 100U);
  // The next samples, from the first on.
  const PoseCapture expected = averageFrames(std::span(stream.frames).first(100), PoseId(1), {});
  EXPECT_EQ(captures_.poses.front().pose->samples.front().mean_g, expected.samples.front().mean_g);
}

TEST_F(PoseRecorderTest, CapturesAnywayWithTheVeryFirstSamples) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 0.3);
  recorder_.captureNow();
  feed(recorder_, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  EXPECT_THAT(captures_.poses.front().pose->samples, SizeIs(2));
}

TEST_F(PoseRecorderTest, GivesUpACaptureWhenAsked) {
  SyntheticStream stream(cells(2));
  stream.turn(20 * kDegree, 1);
  recorder_.captureNow();
  feed(recorder_, between(stream.frames, 0, 10.05));
  recorder_.cancelCapture();
  feed(recorder_, between(stream.frames, 10.05, 20));
  EXPECT_THAT(captures_.poses, IsEmpty());
}

TEST_F(PoseRecorderTest, NamesThePoseThatIsRepeated) {
  SyntheticStream stream = held(2, cells(3));
  const Eigen::Vector3d axis = stream.someAxis();
  stream.turnAbout(axis, 80 * kDegree, 1);
  stream.hold(2);
  stream.turnAbout(axis, -76 * kDegree, 1);
  stream.hold(2);
  feed(recorder_, stream.frames);
  ASSERT_THAT(collect(captures_.poses, &CapturedPose::repeats), ElementsAre(std::nullopt, std::nullopt, PoseId(1)));
  EXPECT_NEAR(toDegrees(captures_.poses[2].repeat_angle_rad), 4, 0.5);

  // The session's own list counts: without the first pose nothing is repeated.
  Captures again;
  PoseRecorder other(again);
  other.setEarlierPoses({captures_.poses[1].pose});
  stream.frames.clear();
  stream.hold(2);
  feed(other, stream.frames);
  ASSERT_THAT(again.poses, SizeIs(1));
  EXPECT_FALSE(again.poses[0].repeats);
}

TEST_F(PoseRecorderTest, ShowsThePresentReadingsAtMostTwentyTimesASecond) {
  SyntheticStream stream = held(3, cells(3));
  stream.frames[10].temperatures.push_back({CellId(2), 31.5});
  stream.frames[1000].temperatures.push_back({CellId(2), 32.5});
  feed(recorder_, stream.frames);
  EXPECT_NEAR(static_cast<double>(captures_.previews.size()), 59, 1);
  EXPECT_EQ(captures_.holds.size(), captures_.previews.size());
  const SkinPreview& preview = captures_.previews.back();
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

TEST_F(PoseRecorderTest, StartsOverWithAnotherSkin) {
  SyntheticStream stream = held(2, cells(3));
  recorder_.setSkin(skinOf(3));
  feed(recorder_, stream.frames);
  recorder_.setSkin(skinOf(3, 500));
  for (SampleFrame& frame : stream.frames) frame.time_s -= 9;
  feed(recorder_, stream.frames);
  EXPECT_THAT(captures_.poses, SizeIs(2));
  EXPECT_EQ(captures_.holds.back().late_frames, 0U);
}

TEST_F(PoseRecorderTest, RefusesOptionsThatMakeNoSense) {
  for (const PoseRecorderOptions& options :
       {test::with(&PoseRecorderOptions::collect_s, 0), test::with(&PoseRecorderOptions::repeat_angle_rad, -1),
        test::with(&PoseRecorderOptions::stillness, test::with(&StillnessOptions::hold_s, -1))}) {
    EXPECT_THROW(PoseRecorder(captures_, options), InvalidArgument);
  }
}

}  // namespace
}  // namespace hexoderm::pose_recorder_test
