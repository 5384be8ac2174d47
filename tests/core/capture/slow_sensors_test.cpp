// Simulated streams of slow, coarse, shaken and repeating sensors: what stands still is captured, what turns is not.

#include "hexoderm/capture/pose_recorder.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "tests/core/capture/pose_recorder_fixture.h"

namespace hexoderm {
namespace {

using pose_recorder_test::Captures;

constexpr double k12Bits_g = 4.0 / 4096;
constexpr double k8Bits_g = 4.0 / 256;
constexpr double kHeld_s = 20;
constexpr double kFastest_rad_s = 20 * kDegree;

struct Sensors {
  double rate_hz = 20;
  std::size_t cells = 10;
  double vibration_g = 0;    ///< rms of the axis that is shaken most; the others between 8/35 of it and this
  double correlation_s = 0;  ///< 0: white
  double step_g = k12Bits_g;
  double frames_per_reading = 1;
  double turn_rad_s = 3 * kDegree;  ///< of the slow turn between the holds
  double stated_noise = 0.0003;     ///< of the data sheet, g / sqrt(Hz) at 100 Hz: 2 mg
};

void PrintTo(const Sensors& s, std::ostream* out) {
  *out << s.rate_hz << " Hz, " << s.cells << " cells, " << 1000 * s.vibration_g << " mg"
       << (s.correlation_s > 0 ? " coloured" : " white") << ", steps of " << 1000 * s.step_g << " mg, each reading "
       << s.frames_per_reading << " times, turns by " << toDegrees(s.turn_rad_s) << " deg/s";
}

/// A part that is held, moved, turned slowly, and so on; its cells are read one by one at their own time.
class ShakenPart {
 public:
  ShakenPart(const Sensors& sensors, unsigned seed) : sensors_(sensors), random_(seed) {
    std::uniform_real_distribution<double> axis(8.0 / 35, 1);
    for (std::size_t k = 0; k < sensors.cells; ++k) {
      Cell cell{expSO3(drawn()), {}, drawn(), {}, now_s_ + uniform(0, 1) / sensors.rate_hz};
      cell.rms_g = sensors.vibration_g * Eigen::Vector3d(axis(random_), axis(random_), axis(random_));
      cell.shown_g = rounded(cell.R_u_b * up());
      cells_.push_back(cell);
    }
  }

  std::pair<double, double> turn(double rate_rad_s, double duration_s, const auto& take) {
    const double begin_s = now_s_;
    const double step_s = 1 / (sensors_.rate_hz * sensors_.frames_per_reading);
    for (; now_s_ < begin_s + duration_s; now_s_ += step_s, angle_rad_ += rate_rad_s * step_s) {
      SampleFrame frame{now_s_ + 0.04 * step_s * uniform(-1, 1)};
      for (std::size_t k = 0; k < cells_.size(); ++k) {
        if (sensors_.frames_per_reading == 1 || now_s_ >= cells_[k].next_s) read(cells_[k]);
        frame.samples.push_back({CellId(static_cast<std::uint32_t>(k + 1)), cells_[k].shown_g});
      }
      take(frame);
    }
    return {begin_s, now_s_};
  }

 private:
  struct Cell {
    Eigen::Matrix3d R_u_b;
    Eigen::Vector3d rms_g;
    Eigen::Vector3d shaken;  ///< of variance 1
    Eigen::Vector3d shown_g;
    double next_s;  ///< when it is read next
  };
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Eigen::Vector3d drawn() {
    const double x = normal_(random_), y = normal_(random_);
    return {x, y, normal_(random_)};
  }
  [[nodiscard]] Eigen::Vector3d up() const {
    return Eigen::Vector3d(0.3, std::sin(angle_rad_), std::cos(angle_rad_)).normalized();
  }
  [[nodiscard]] Eigen::Vector3d rounded(const Eigen::Vector3d& g) const {
    return sensors_.step_g * (g / sensors_.step_g).array().round();
  }
  void read(Cell& cell) {
    cell.next_s += (1 + 0.05 * uniform(-1, 1)) / sensors_.rate_hz;
    const double kept = sensors_.correlation_s > 0 ? std::exp(-1 / (sensors_.rate_hz * sensors_.correlation_s)) : 0;
    cell.shaken = kept * cell.shaken + std::sqrt(1 - kept * kept) * drawn();
    cell.shown_g = rounded(cell.R_u_b * up() + cell.rms_g.cwiseProduct(cell.shaken));
  }

  Sensors sensors_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<Cell> cells_;
  double now_s_ = 10;
  double angle_rad_ = 0;
};

SkinDescription described(const Sensors& sensors) {
  SkinDescription skin = pose_recorder_test::skinOf(sensors.cells, 100);
  CellModel model = *skin.model;
  model.accelerometer.lsb_g = k12Bits_g;
  model.accelerometer.noise_g_per_sqrt_hz = sensors.stated_noise;
  skin.model = std::make_shared<const CellModel>(std::move(model));
  return skin;
}

/// What is made of a part that is held for so long.
Captures heldFor(double duration_s, const Sensors& sensors, unsigned seed) {
  Captures captures;
  PoseRecorder recorder(captures);
  recorder.setSkin(described(sensors));
  ShakenPart(sensors, seed).turn(0, duration_s, [&](const SampleFrame& frame) { recorder.addFrame(frame); });
  return captures;
}

class SlowSensors : public ::testing::TestWithParam<Sensors> {};

TEST_P(SlowSensors, EveryHoldIsCapturedOnceAndNoTurn) {
  const Sensors& sensors = GetParam();
  std::size_t judged = 0, accused = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Captures captures;
    PoseRecorder recorder(captures);
    recorder.setSkin(described(sensors));
    ShakenPart part(sensors, seed);
    const auto take = [&](const SampleFrame& frame) { recorder.addFrame(frame); };
    std::vector<std::pair<double, double>> holds = {part.turn(0, kHeld_s, take)};
    part.turn(kFastest_rad_s, 2, take);
    part.turn(sensors.turn_rad_s, 8, take);
    part.turn(kFastest_rad_s, 2, take);
    holds.push_back(part.turn(0, kHeld_s, take));
    part.turn(-kFastest_rad_s, 2, take);
    holds.push_back(part.turn(0, kHeld_s, take));

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
          Sensors sensors{rate_hz, cells, vibration_g, correlation_s};
          all.push_back(sensors);
          sensors.step_g = k8Bits_g;
          all.push_back(sensors);
          sensors.step_g = k12Bits_g;
          for (const double times : {4.0, 4.5, 5.0}) {
            sensors.frames_per_reading = times;
            if (rate_hz <= 20) all.push_back(sensors);
          }
        }
      }
    }
  }
  for (const double turn_deg_s : {5.0, 20.0}) {
    for (const double vibration_g : {0.0, 0.035}) {
      for (const double rate_hz : {5.0, 20.0, 100.0}) {
        Sensors sensors{rate_hz, 3, vibration_g, 0.04};
        sensors.turn_rad_s = turn_deg_s * kDegree;
        all.push_back(sensors);
        sensors.stated_noise = 0.005;  // more than there is
        all.push_back(sensors);
      }
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, SlowSensors, ::testing::ValuesIn(allSensors()));

/// A gateway's repetitions are no information: neither for the rate nor for what a mean is worth.
TEST(RepeatedReadings, CountOnce) {
  Sensors sensors{.vibration_g = 0.02};
  for (const double times : {1.0, 4.5}) {
    sensors.frames_per_reading = times;
    const Captures captures = heldFor(10, sensors, 3);
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
  const Captures captures = heldFor(5, {.rate_hz = 100, .vibration_g = 0.15 * k12Bits_g}, 2);
  ASSERT_EQ(captures.poses.size(), 1U);
  EXPECT_NEAR(captures.holds.back().stillness.rate_hz, 100, 5);
}

TEST(HoldStatus, SaysThatReadingsScatterTooMuchToTell) {
  const Captures captures = heldFor(15, {5, 1, 0.2, 0}, 1);
  EXPECT_TRUE(captures.poses.empty());
  for (const HoldStatus& hold : captures.holds) EXPECT_NE(hold.stillness.blocker, Blocker::Turning);
}

}  // namespace
}  // namespace hexoderm
