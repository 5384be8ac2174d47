// Simulated streams of slow, coarse, shaken and repeating sensors: what stands still is captured, what turns is not.

#include "hexoderm/capture/pose_recorder.h"

#include "tests/core/capture/pose_recorder_fixture.h"

namespace hexoderm::pose_recorder_test {
namespace {

constexpr double k12Bits_g = 4.0 / 4096;
constexpr double k8Bits_g = 4.0 / 256;
constexpr double kHeld_s = 20;
constexpr double kFastest_rad_s = 20 * kDegree;

struct Sensors {
  StreamOptions stream;
  double turn_rad_s = 3 * kDegree;  ///< of the slow turn between the holds
  double stated_noise = 0.0003;     ///< of the data sheet, g / sqrt(Hz) at 100 Hz: 2 mg
};

/// Sensors that are read at this rate.
Sensors readAt(double rate_hz, std::size_t cells, double vibration_g, double correlation_s = 0,
               double step_g = k12Bits_g, double frames_per_reading = 1) {
  return {{.cells = cells,
           .rate_hz = rate_hz * frames_per_reading,
           .jitter = 0.04,
           .noise_g = 0,
           .lsb_g = step_g,
           .vibration_g = vibration_g,
           .correlation_s = correlation_s,
           .frames_per_reading = frames_per_reading}};
}

void PrintTo(const Sensors& s, std::ostream* out) {
  *out << s.stream.rate_hz << " frames a second, " << s.stream.cells << " cells, " << 1000 * s.stream.vibration_g
       << " mg" << (s.stream.correlation_s > 0 ? " coloured" : " white") << ", steps of " << 1000 * s.stream.lsb_g
       << " mg, each reading " << s.stream.frames_per_reading << " times, turns by " << toDegrees(s.turn_rad_s)
       << " deg/s";
}

SkinDescription described(const Sensors& sensors) {
  SkinDescription skin = skinOf(sensors.stream.cells, 100);
  CellModel model = *skin.model;
  model.accelerometer.lsb_g = k12Bits_g;
  model.accelerometer.noise_g_per_sqrt_hz = sensors.stated_noise;
  skin.model = std::make_shared<const CellModel>(std::move(model));
  return skin;
}

/// What is made of a part that is held for so long.
Captures heldFor(double duration_s, Sensors sensors, unsigned seed) {
  sensors.stream.seed = seed;
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.setSkin(described(sensors));
  feed(recorder, held(duration_s, sensors.stream).frames);
  return captures;
}

class SlowSensors : public ::testing::TestWithParam<Sensors> {};

TEST_P(SlowSensors, EveryHoldIsCapturedOnceAndNoTurn) {
  Sensors sensors = GetParam();
  std::size_t judged = 0, accused = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    sensors.stream.seed = seed;
    SyntheticStream part(sensors.stream);
    std::vector<std::pair<double, double>> holds = {part.hold(kHeld_s)};
    part.turn(kFastest_rad_s, 2);
    part.turn(sensors.turn_rad_s, 8);
    part.turn(kFastest_rad_s, 2);
    holds.push_back(part.hold(kHeld_s));
    part.turn(kFastest_rad_s, 2);
    holds.push_back(part.hold(kHeld_s));
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin(described(sensors));
    feed(recorder, part.frames);

    std::vector<int> captured(holds.size(), 0);
    for (const CapturedPose& pose : captures.poses) {
      // At the end of a move the part counts as still a little early: its own weights fall off to both ends.
      const auto hold = std::ranges::find_if(
          holds, [&](const auto& h) { return pose.start_s >= h.first - 0.2 && pose.end_s <= h.second + 0.1; });
      ASSERT_NE(hold, holds.end()) << "seed " << seed << ": captured from " << pose.start_s << " to " << pose.end_s;
      ++captured[static_cast<std::size_t>(hold - holds.begin())];
    }
    EXPECT_EQ(captured, std::vector<int>(holds.size(), 1)) << "seed " << seed;
    for (const HoldStatus& hold : captures.holds) {
      const double time_s = hold.stillness.time_s;
      // What it says while its longest window lies within a hold.
      if (std::ranges::none_of(holds, [&](const auto& h) { return time_s > h.first + 6 && time_s < h.second; }))
        continue;
      ++judged;
      if (hold.stillness.blocker == Blocker::Turning || hold.stillness.blocker == Blocker::CellTurning) ++accused;
    }
  }
  EXPECT_GT(judged, 300U);
  // By chance, of judgements that follow each other at 5 to 20 Hz, one in a hundred.
  EXPECT_LE(accused, judged / 100) << "of a part that stands still";
}

std::vector<Sensors> allSensors() {
  std::vector<Sensors> all;
  for (const double rate_hz : {5.0, 10.0, 20.0, 50.0, 100.0}) {
    for (const std::size_t cells : {1U, 10U}) {
      for (const double vibration_g : {0.0, 0.011, 0.035}) {
        for (const double correlation_s : {0.0, 0.04}) {
          if (vibration_g == 0 && correlation_s > 0) continue;
          for (const double step_g : {k12Bits_g, k8Bits_g}) {
            all.push_back(readAt(rate_hz, cells, vibration_g, correlation_s, step_g));
          }
          for (const double times : {4.0, 4.5, 5.0}) {
            if (rate_hz > 20) continue;
            all.push_back(readAt(rate_hz, cells, vibration_g, correlation_s, k12Bits_g, times));
          }
        }
      }
    }
  }
  for (const double turn_deg_s : {5.0, 20.0}) {
    for (const double vibration_g : {0.0, 0.035}) {
      for (const double rate_hz : {5.0, 20.0, 100.0}) {
        Sensors turned = readAt(rate_hz, 3, vibration_g, 0.04);
        turned.turn_rad_s = turn_deg_s * kDegree;
        all.push_back(turned);
        turned.stated_noise = 0.005;  // more than there is
        all.push_back(turned);
      }
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, SlowSensors, ::testing::ValuesIn(allSensors()));

/// A gateway's repetitions are no information: neither for the rate nor for what a mean is worth.
TEST(RepeatedReadings, CountOnce) {
  for (const double times : {1.0, 4.5}) {
    const Captures captures = heldFor(10, readAt(20, 10, 0.02, 0, k12Bits_g, times), 3);
    ASSERT_EQ(captures.poses.size(), 1U) << times;
    EXPECT_NEAR(captures.holds.back().stillness.rate_hz, 20, 2) << times;
    for (const GravitySample& sample : captures.poses.front().pose->samples) {
      EXPECT_NEAR(sample.count, 15, 2) << times;  // in 0.75 s
      const double sample_sigma_g = std::sqrt(sample.cov_g2.trace() / 3 * sample.count);
      EXPECT_GT(sample_sigma_g, 0.004) << times;
      EXPECT_LT(sample_sigma_g, 0.03) << times;
    }
  }
}

TEST(RepeatedReadings, OfAQuietSensorAreReadings) {
  // Its noise is below its step: three readings in four are equal by chance, and none is a repetition.
  const Captures captures = heldFor(5, readAt(100, 10, 0.15 * k12Bits_g), 2);
  ASSERT_EQ(captures.poses.size(), 1U);
  EXPECT_NEAR(captures.holds.back().stillness.rate_hz, 100, 5);
}

TEST(HoldStatus, SaysThatReadingsScatterTooMuchToTell) {
  const Captures captures = heldFor(15, readAt(5, 1, 0.2), 1);
  EXPECT_TRUE(captures.poses.empty());
  for (const HoldStatus& hold : captures.holds) EXPECT_NE(hold.stillness.blocker, Blocker::Turning);
}

}  // namespace
}  // namespace hexoderm::pose_recorder_test
