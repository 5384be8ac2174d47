#include "hexoderm/capture/stillness_detector.h"

#include "hexoderm/base/text.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/core/capture/synthetic_stream.h"
#include "tests/support/options.h"

namespace hexoderm {
namespace {

using test::held;
using test::StreamOptions;
using test::SyntheticStream;
using ::testing::MatchesRegex;

Accelerometer accelerometer() { return builtInCellModel("hex-bma150").accelerometer; }

class StillnessDetectorTest : public testing::Test {
 protected:
  StillnessDetector detector_{accelerometer()};
};

void feed(StillnessDetector& detector, const std::vector<SampleFrame>& frames) {
  for (const SampleFrame& frame : frames) detector.add(frame);
}

/// Share of the judgements after the first second that say still.
double stillShare(StillnessDetector& detector, const std::vector<SampleFrame>& frames) {
  double judged = 0, still = 0;
  for (const SampleFrame& frame : frames) {
    if (!detector.add(frame) || frame.time_s < frames.front().time_s + 1) continue;
    ++judged;
    still += detector.stillness().still ? 1 : 0;
  }
  return judged > 0 ? still / judged : 0;
}

const OddCell* oddOne(const Stillness& stillness, std::uint32_t cell) {
  const auto found = std::ranges::find(stillness.odd_cells, CellId(cell), &OddCell::cell);
  return found == stillness.odd_cells.end() ? nullptr : &*found;
}

/// Changes the readings of one cell.
void spoil(std::vector<SampleFrame>& frames, std::uint32_t cell,
           const std::function<Eigen::Vector3d(const Eigen::Vector3d&, double)>& spoiled) {
  for (SampleFrame& frame : frames) {
    for (CellSample& sample : frame.samples) {
      if (sample.cell == CellId(cell)) sample.acceleration_g = spoiled(sample.acceleration_g, frame.time_s);
    }
  }
}

TEST_F(StillnessDetectorTest, WaitsUntilItHasAWindowOfSamples) {
  EXPECT_EQ(detector_.stillness().blocker, Blocker::Waiting);
  EXPECT_EQ(detector_.stillness().message.english(), "Waiting for samples");
  feed(detector_, held(0.5).frames);
  EXPECT_FALSE(detector_.stillness().still);
  EXPECT_EQ(detector_.stillness().message.english(), "Waiting for samples: fewer than 0.8 s so far");
}

TEST_F(StillnessDetectorTest, FindsATableStillAndSaysForHowLong) {
  feed(detector_, held(3).frames);
  const Stillness& stillness = detector_.stillness();
  EXPECT_TRUE(stillness.ready()) << stillness.message.english();
  EXPECT_EQ(stillness.blocker, Blocker::None);
  EXPECT_EQ(stillness.message.english(), "");
  EXPECT_NEAR(stillness.still_for_s, 2.75, 0.11);
  EXPECT_NEAR(stillness.rate_hz, 1000, 25);
  EXPECT_EQ(stillness.cells, 1U);
  EXPECT_EQ(stillness.cells_used, 1U);
}

TEST_F(StillnessDetectorTest, TakesReadingsThatNeverChangeForStill) {
  feed(detector_, held(2, {.noise_g = 0}).frames);
  EXPECT_TRUE(detector_.stillness().still) << detector_.stillness().message.english();
}

TEST(StillnessDetector, AcceptsTheTremorOfTheSimulatedHand) {
  // The sheet is 0.8 m long: 100 mg at its ends.
  for (const char* patch : {"x17", "sheet:3x30"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SimulatedSkin skin(
          builtInCellModel("hex-bma150"),
          test::with(SimulatedSkinOptions(), &SimulatedSkinOptions::patch, patch, &SimulatedSkinOptions::seed, seed));
      skin.record({0, 0, 1}, 1);  // the first stands on a table
      StillnessDetector detector(skin.model().accelerometer);
      EXPECT_GE(stillShare(detector, skin.record({0, 1, 0}, 4000)), 0.95) << patch << ", seed " << seed;
      EXPECT_TRUE(detector.stillness().odd_cells.empty());
    }
  }
}

TEST(StillnessDetector, SaysHowFastThePartTurns) {
  for (const double rate_hz : {50.0, 100.0, 1000.0}) {
    SyntheticStream stream({.cells = 5, .rate_hz = rate_hz});
    stream.turn(3 * kDegree, 4);
    StillnessDetector detector(accelerometer());
    EXPECT_EQ(stillShare(detector, stream.frames), 0);
    const Stillness& stillness = detector.stillness();
    EXPECT_EQ(stillness.blocker, Blocker::Turning);
    EXPECT_NEAR(toDegrees(stillness.drift_rad_s), 3, 0.6) << rate_hz;
    EXPECT_EQ(stillness.message.english(),
              "Hold still: the part turns by " + formatFixed(toDegrees(stillness.drift_rad_s), 1) + " deg/s, limit 1");
  }
}

TEST_F(StillnessDetectorTest, DriftIsExactWithoutNoise) {
  SyntheticStream stream({.cells = 3, .noise_g = 0, .lsb_g = 0});
  stream.turn(2 * kDegree, 2);
  feed(detector_, stream.frames);
  EXPECT_NEAR(toDegrees(detector_.stillness().drift_rad_s), 2, 0.01);
}

TEST_F(StillnessDetectorTest, NamesTheCellThatMoves) {
  const SyntheticStream shaken = held(5, {.cells = 4, .tremor_g = 0.06});
  double judged = 0, shakes = 0;
  for (const SampleFrame& frame : shaken.frames) {
    if (!detector_.add(frame)) continue;
    const Stillness& stillness = detector_.stillness();
    ++judged;
    if (stillness.blocker != Blocker::Shaking) continue;
    ++shakes;
    EXPECT_GT(stillness.excess_g, stillness.excess_limit_g);
    EXPECT_EQ(stillness.message.english(), "Hold still: cell " + toString(stillness.excess_cell) + " moves " +
                                               formatFixed(1000 * stillness.excess_g, 0) + " mg, limit 30");
  }
  EXPECT_GT(shakes, judged / 4);
  EXPECT_FALSE(detector_.stillness().still);
}

TEST(StillnessDetector, TheNormOfAReadingNeverBlocks) {
  for (const double gain : {0.3, 0.9, 1.5}) {
    StillnessDetector detector(accelerometer());
    EXPECT_EQ(stillShare(detector, held(3, {.offset_g = 0.1, .gain = gain}).frames), 1) << gain;
  }
}

TEST_F(StillnessDetectorTest, IsArmedAgainByAMoveOfMoreThanFiveDegrees) {
  SyntheticStream stream = held(1.5, {.cells = 5, .offset_g = 0.1});
  feed(detector_, stream.frames);
  ASSERT_TRUE(detector_.stillness().ready());
  detector_.disarm(averageFrames(stream.frames, PoseId(1), {}));
  EXPECT_FALSE(detector_.stillness().armed);

  stream.frames.clear();
  stream.move(3 * kDegree, 0.5);
  stream.hold(2);
  feed(detector_, stream.frames);
  EXPECT_TRUE(detector_.stillness().still);
  EXPECT_FALSE(detector_.stillness().ready());
  EXPECT_EQ(detector_.stillness().blocker, Blocker::NotMoved);
  EXPECT_NEAR(toDegrees(detector_.stillness().moved_rad), 3, 0.3);
  EXPECT_THAT(detector_.stillness().message.english(),
              MatchesRegex("Turn the part: it has moved [23]\\.[0-9] deg since the last capture, "
                           "more than 5 are needed"));

  stream.frames.clear();
  const Eigen::Vector3d up = stream.up();
  stream.move(20 * kDegree, 0.5);
  stream.move(1 * kDegree, 0.2);
  ASSERT_GT(angleBetween(up, stream.up()), 15 * kDegree);
  stream.hold(2);
  feed(detector_, stream.frames);
  EXPECT_TRUE(detector_.stillness().ready()) << detector_.stillness().message.english();
}

TEST_F(StillnessDetectorTest, StaysArmedWhenThePartReturns) {
  SyntheticStream first = held(1.5);
  feed(detector_, first.frames);
  detector_.disarm(averageFrames(first.frames, PoseId(1), {}));
  first.frames.clear();
  const Eigen::Vector3d axis = first.someAxis();
  first.turnAbout(axis, 20 * kDegree, 1);
  first.turnAbout(axis, -20 * kDegree, 1);
  first.hold(2);
  feed(detector_, first.frames);
  EXPECT_LT(toDegrees(detector_.stillness().moved_rad), 2);
  EXPECT_TRUE(detector_.stillness().ready()) << detector_.stillness().message.english();
}

/// The kind that one bad cell of five is given while the part is held, moved and held again; it must not block.
struct BadCell {
  std::string name;
  OddCellKind kind;
  std::function<Eigen::Vector3d(const Eigen::Vector3d&, double)> spoiled;
};
void PrintTo(const BadCell& cell, std::ostream* out) { *out << cell.name; }

class StillnessDetectorWith : public ::testing::TestWithParam<BadCell> {};

TEST_P(StillnessDetectorWith, OneBadCellDoesNotBlockAndIsNamed) {
  for (const double rate_hz : {100.0, 1000.0}) {
    SyntheticStream stream = held(5, {.cells = 5, .rate_hz = rate_hz, .tremor_g = 0.005});
    stream.move(60 * kDegree, 2);
    const double still_from_s = stream.hold(6).first + 1;
    spoil(stream.frames, 3, GetParam().spoiled);
    StillnessDetector detector(accelerometer());
    double last_blocked_s = 0;
    for (const SampleFrame& frame : stream.frames) {
      if (detector.add(frame) && !detector.stillness().still) last_blocked_s = frame.time_s;
    }
    EXPECT_LT(last_blocked_s, still_from_s + StillnessOptions().patience_s) << detector.stillness().message.english();
    const OddCell* odd = oddOne(detector.stillness(), 3);
    ASSERT_NE(odd, nullptr);
    EXPECT_EQ(odd->kind, GetParam().kind);
    EXPECT_THAT(describe(*odd).english(), StartsWith("Cell 3 is "));
    EXPECT_EQ(detector.stillness().odd_cells.size(), 1U);
  }
}

std::mt19937_64 noise_source(7);
Eigen::Vector3d noise(double sigma_g) {
  std::normal_distribution<double> normal(0, sigma_g);
  return {normal(noise_source), normal(noise_source), normal(noise_source)};
}

Eigen::Vector3d circling(const Eigen::Vector3d&, double time_s) {
  return {std::cos(0.3 * time_s), std::sin(0.3 * time_s), 0};
}

std::vector<BadCell> badCells() {
  return {
      {"noisy", OddCellKind::Noisy, [](const Eigen::Vector3d& g, double) { return Eigen::Vector3d(g + noise(0.22)); }},
      {"dead", OddCellKind::Dead, [](const Eigen::Vector3d&, double) { return noise(0.011); }},
      {"stuck", OddCellKind::Stuck, [](const Eigen::Vector3d&, double) { return Eigen::Vector3d(0.1, -0.7, 0.6); }},
      {"restless", OddCellKind::Restless, circling}};
}

INSTANTIATE_TEST_SUITE_P(Kinds, StillnessDetectorWith, ::testing::ValuesIn(badCells()),
                         [](const auto& cell) { return cell.param.name; });

TEST(StillnessDetector, SaysWhatADeadCellReads) {
  EXPECT_EQ(describe({CellId(4), OddCellKind::Dead, 0.012}).english(), "Cell 4 is dead: it reads 12 mg, no gravity");
}

TEST_F(StillnessDetectorTest, ACellThatTurnsAloneBlocksForAWhile) {
  SyntheticStream stream = held(8, {.cells = 5});
  spoil(stream.frames, 2,
        [](const auto&, double t) { return Eigen::Vector3d(std::cos(0.2 * t), std::sin(0.2 * t), 0); });
  double first_still_s = 0;
  for (const SampleFrame& frame : stream.frames) {
    if (!detector_.add(frame)) continue;
    const Stillness& stillness = detector_.stillness();
    if (stillness.blocker == Blocker::CellTurning) {
      EXPECT_EQ(stillness.turning_cell, CellId(2));
      EXPECT_THAT(stillness.message.english(),
                  MatchesRegex("Hold still: cell 2 turns by 11\\.[3-6] deg/s against the rest, limit 2"));
    }
    if (stillness.still && first_still_s == 0) first_still_s = frame.time_s - stream.frames.front().time_s;
  }
  EXPECT_NEAR(first_still_s, 0.75 + StillnessOptions().patience_s, 0.2);
}

TEST_F(StillnessDetectorTest, LearnsThatACellIsQuieterThanItsModel) {
  EXPECT_NEAR(detector_.noiseFloor_g(CellId(1)), 0.0112, 0.0002);
  feed(detector_, held(5, {.noise_g = 0.001, .lsb_g = 0.0005}).frames);
  // Not below the model's step over the square root of 12: that is what its readings can't show.
  EXPECT_NEAR(detector_.noiseFloor_g(CellId(1)), 0.004 / std::sqrt(12.0), 0.0001);
}

TEST_F(StillnessDetectorTest, LearnsTheNoiseOfANoisyCell) {
  SyntheticStream stream = held(15, {.cells = 5});
  spoil(stream.frames, 4, [](const auto& g, double) { return Eigen::Vector3d(g + noise(0.1)); });
  feed(detector_, stream.frames);
  EXPECT_NEAR(detector_.noiseFloor_g(CellId(4)), 0.1, 0.01);
  EXPECT_NEAR(detector_.noiseFloor_g(CellId(3)), 0.011, 0.002);
}

TEST(StillnessDetector, NeverLearnsMotionAsNoise) {
  for (const double tremor_g : {0.02, 0.1}) {
    StillnessDetector detector(accelerometer());
    feed(detector, held(30, {.cells = 3, .tremor_g = tremor_g}).frames);
    for (std::uint32_t cell = 1; cell <= 3; ++cell) EXPECT_LT(detector.noiseFloor_g(CellId(cell)), 0.013) << tremor_g;
  }
}

TEST_F(StillnessDetectorTest, TakesWhiteScatterThatLastsForTheNoiseOfAPoorSensor) {
  const SyntheticStream stream = held(20, {.noise_g = 0.05});
  double first_still_s = 0;
  for (const SampleFrame& frame : stream.frames) {
    if (detector_.add(frame) && detector_.stillness().still && first_still_s == 0) first_still_s = frame.time_s - 10;
  }
  EXPECT_GT(first_still_s, 8);
  EXPECT_LT(first_still_s, 15);
}

TEST_F(StillnessDetectorTest, AGapInTimeBeginsANewWindow) {
  SyntheticStream stream = held(2);
  feed(detector_, stream.frames);
  ASSERT_TRUE(detector_.stillness().still);
  SampleFrame after_gap = stream.frames.back();
  after_gap.time_s += 0.6;
  EXPECT_TRUE(detector_.add(after_gap));
  EXPECT_EQ(detector_.stillness().blocker, Blocker::Waiting);
}

TEST_F(StillnessDetectorTest, IgnoresReadingsThatAreNoNumbers) {
  SyntheticStream stream = held(3, {.cells = 3});
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  spoil(stream.frames, 1, [=](const auto&, double) { return Eigen::Vector3d(nan, 0, infinite); });
  for (std::size_t k = 0; k < stream.frames.size(); k += 7) stream.frames[k].samples[1].acceleration_g.x() = 1e300;
  feed(detector_, stream.frames);
  EXPECT_TRUE(detector_.stillness().still) << detector_.stillness().message.english();
  EXPECT_EQ(detector_.stillness().cells_used, 2U);
  EXPECT_TRUE(std::isfinite(detector_.stillness().excess_g));
  ASSERT_NE(oddOne(detector_.stillness(), 1), nullptr);
  EXPECT_EQ(oddOne(detector_.stillness(), 1)->kind, OddCellKind::Silent);
}

TEST(StillnessDetector, CellsMaySendInTurnOrFailToSend) {
  for (const bool in_turn : {true, false}) {
    SyntheticStream stream = held(3, {.cells = 12});
    std::mt19937 random(5);
    for (std::size_t k = 0; k < stream.frames.size(); ++k) {
      auto& samples = stream.frames[k].samples;
      if (in_turn) {
        samples = {samples[k % samples.size()]};
      } else {
        std::erase_if(samples, [&](const CellSample&) { return random() % 10 < 7; });
      }
    }
    StillnessDetector detector(accelerometer());
    EXPECT_GE(stillShare(detector, stream.frames), 0.95) << detector.stillness().message.english();
    EXPECT_EQ(detector.stillness().cells_used, 12U);
  }
}

TEST(StillnessDetector, JudgesMeansThatTheDeviceMade) {
  for (const double mean_s : {0.02, 0.1, 0.5}) {
    SyntheticStream stream({.cells = 3});
    const double turned_s = stream.hold(6).second;
    stream.turn(5 * kDegree, 4);
    StillnessDetector detector(accelerometer());
    bool was_still = false;
    std::vector<SampleFrame> batch;
    for (const SampleFrame& frame : stream.frames) {
      batch.push_back(frame);
      if (frame.time_s < batch.front().time_s + mean_s) continue;
      SampleFrame means{frame.time_s};
      for (const GravitySample& sample : averageFrames(batch, PoseId(1), {}).samples) {
        means.means.push_back({sample.cell, sample.mean_g, sample.count * sample.cov_g2.diagonal(), sample.count});
      }
      batch.clear();
      detector.add(means);
      if (frame.time_s < turned_s) was_still |= detector.stillness().still;
    }
    EXPECT_TRUE(was_still) << mean_s;
    EXPECT_FALSE(detector.stillness().still) << mean_s;
    EXPECT_NEAR(toDegrees(detector.stillness().drift_rad_s), 5, 0.5) << mean_s;
  }
}

TEST(StillnessDetector, RefusesOptionsThatMakeNoSense) {
  const auto refused = [](const std::function<void(StillnessOptions&)>& change) {
    StillnessOptions options;
    change(options);
    return test::messageOf<InvalidArgument>([&] { StillnessDetector(accelerometer(), options); });
  };
  EXPECT_NO_THROW(StillnessDetector(accelerometer(), {}));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.drift_limit_rad_s = 0; }), HasSubstr("drift_limit_rad_s"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.excess_limit_g = -1; }), HasSubstr("excess_limit_g"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.hold_s = 0; }), HasSubstr("hold_s"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.drift_window_s = 0.3; }), HasSubstr("drift_window_s"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.rearm_angle_rad = 4; }), HasSubstr("rearm_angle_rad"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.release_factor = 0.5; }), HasSubstr("release_factor"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.quiet_fraction = 2; }), HasSubstr("quiet_fraction"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.patience_s = std::nan(""); }), HasSubstr("patience_s"));
  EXPECT_THAT(refused([](StillnessOptions& o) { o.silent_after_s = 0; }), HasSubstr("silent_after_s"));
}

}  // namespace
}  // namespace hexoderm
