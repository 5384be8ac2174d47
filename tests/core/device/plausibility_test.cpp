#include "hexoderm/device/plausibility.h"

#include "hexoderm/skin/cell_model.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using std::chrono::milliseconds;
using Pace = ClockCheck::Pace;

const Accelerometer kSensor = builtInCellModel("hex-bma150").accelerometer;

TEST(ProtocolViolationOfNorm, TellsUnitsByGravity) {
  const auto kindOf = [](double norm) -> std::optional<ProtocolViolationKind> {
    const std::optional<ProtocolViolation> offence = offenceOfNorm(norm, kSensor, "field");
    return offence ? std::optional(offence->kind) : std::nullopt;
  };
  for (const double norm : {0.5, 0.8, 1.0, 1.3, 2.0}) EXPECT_EQ(kindOf(norm), std::nullopt) << norm;
  for (const double norm : {9.0, 9.81, 11.0, 900.0, 1000.0, 1200.0, 256.0}) {
    EXPECT_EQ(kindOf(norm), ProtocolViolationKind::AccelerationUnit) << norm;
  }
  for (const double norm : {0.0, 0.1, 2.5, 5.0, 64.0, 16'384.0})
    EXPECT_EQ(kindOf(norm), ProtocolViolationKind::NotGravity) << norm;
  EXPECT_THAT(offenceOfNorm(9.7, kSensor, "samples.mean_g")->reason.english(),
              HasSubstr("samples.mean_g: the norm of the readings is 9.70 in the median: are these m/s2?"));
}

SampleFrame frameOf(double norm_g) { return {0, {{CellId(1), Eigen::Vector3d(0, 0, norm_g)}}}; }

TEST(ReadingCheck, IsSoonAboutUnitsAndPatientAboutShocks) {
  ReadingCheck check;
  int frames = 0;
  while (!check.add(frameOf(9.81), kSensor, "f")) ASSERT_LT(++frames, 20);
  check = {};
  // A shock of 100 frames between rest, again and again.
  for (int k = 0; k < 5000; ++k) {
    const bool shaken = k % 400 >= 200 && k % 400 < 300;
    EXPECT_FALSE(check.add(frameOf(shaken ? 3 : 1), kSensor, "f")) << k;
  }
  for (frames = 0; !check.add(frameOf(0), kSensor, "f"); ++frames) ASSERT_LT(frames, 500);
  EXPECT_GT(frames, 100);
}

/// The cells send in turn, one in each frame.
TEST(ReadingCheck, APartThatIsWhirledIsNoOffence) {
  for (const unsigned cells : {1U, 50U}) {
    ReadingCheck check;
    for (unsigned k = 0; k < 20'000; ++k) {
      const Eigen::Vector3d gravity_g = Eigen::AngleAxisd(0.1 * k, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d::UnitX();
      const CellSample sample{CellId(1 + k % cells), Eigen::Vector3d(3, 0, 0) + gravity_g};
      EXPECT_FALSE(check.add({0, {sample}}, kSensor, "f")) << cells << " cells, frame " << k;
    }
    int frames = 0;
    while (!check.add({0, {{CellId(1), Eigen::Vector3d(3, 0, 0)}}}, kSensor, "f")) ASSERT_LT(++frames, 1000);
  }
}

std::optional<ProtocolViolation> addEvery(std::uint64_t step_us, double stated_hz, bool is_whole = true,
                                          int samples = 50) {
  ClockCheck check;
  std::optional<ProtocolViolation> found;
  for (std::uint64_t time_us = 1'000'000; samples > 0; --samples, time_us += step_us) {
    if (auto offence = check.addSample(CellId(1), time_us, stated_hz, 1000, is_whole)) found = offence;
  }
  return found;
}

TEST(ClockCheck, ComparesStepsWithTheStatedRate) {
  for (const std::uint64_t step_us : {1000ULL, 2000ULL, 500ULL, 10'000ULL, 100'000ULL}) {
    EXPECT_FALSE(addEvery(step_us, 1000)) << step_us << ": a device may lose or skip samples";
  }
  EXPECT_THAT(addEvery(10, 100)->reason.english(), HasSubstr("10 us apart, but hello.rate_hz says 100 Hz: are these "
                                                             "milliseconds?"));
  EXPECT_THAT(addEvery(10'000'000, 100)->reason.english(), HasSubstr("are these nanoseconds?"));
  EXPECT_FALSE(addEvery(1000, 0)) << "no rate is stated, and the sensor's is 1 kHz";
  EXPECT_FALSE(addEvery(100, 0)) << "a quicker sensor than the model's";
  EXPECT_THAT(addEvery(10, 0)->reason.english(), HasSubstr("are these milliseconds?"));
}

TEST(ClockCheck, ARateThatIsNotTheStatedOneIsSaidUnlessSamplesWereLost) {
  const auto judge = [](std::uint64_t step_us, bool is_whole) { return addEvery(step_us, 100, is_whole, 100); };
  const std::optional<ProtocolViolation> slower = judge(35'714, true);
  ASSERT_TRUE(slower);
  EXPECT_EQ(slower->kind, ProtocolViolationKind::WrongValue);
  EXPECT_THAT(slower->reason.english(),
              HasSubstr("hello.rate_hz: says 100 Hz, but a cell's samples come 28.0 times a second"));
  EXPECT_TRUE(judge(5'000, true)) << "twice as often";
  EXPECT_FALSE(judge(35'714, false)) << "it may have sent them";
  EXPECT_FALSE(judge(9'000, true));
  EXPECT_FALSE(judge(12'000, true));
}

/// Times that run `factor` times as fast as the host's clock, looked at every 50 ms.
std::optional<ProtocolViolation> run(ClockCheck& check, double factor, Pace pace, int looks = 100,
                                     double start_us = 1e6, ClockCheck::Clock::time_point start = {}) {
  for (int k = 0; k < looks; ++k) {
    const auto us = static_cast<std::uint64_t>(start_us + 50'000.0 * k * factor);
    if (auto offence = check.compare(us, start + milliseconds(50 * k), pace)) return offence;
  }
  return std::nullopt;
}

TEST(ClockCheck, ComparesWithTheHostsClock) {
  for (const double factor : {0.05, 0.5, 1.0, 5.0, 20.0}) {
    ClockCheck check;
    EXPECT_FALSE(run(check, factor, Pace::Live)) << factor;
  }
  ClockCheck slow;
  EXPECT_THAT(run(slow, 1e-3, Pace::Live)->reason.english(), HasSubstr("are these milliseconds?"));
  ClockCheck quick;
  EXPECT_THAT(run(quick, 1e3, Pace::Live)->reason.english(), HasSubstr("are these nanoseconds?"));
  ClockCheck file;
  EXPECT_FALSE(run(file, 1e3, Pace::Faster)) << "a file is read as fast as it goes";
  ClockCheck played;
  EXPECT_FALSE(run(played, 1e-3, Pace::Free)) << "somebody steps through a recording";
}

TEST(ClockCheck, ASilenceAndAClockThatIsSetAreNoUnit) {
  ClockCheck silent;
  for (int k = 0; k < 1000; ++k)
    EXPECT_FALSE(silent.compare(1'000'000 + (k < 5 ? 1000 * k : 5000),
                                ClockCheck::Clock::time_point(milliseconds(50 * k)), Pace::Live));
  ClockCheck jumped;
  EXPECT_FALSE(run(jumped, 1, Pace::Live, 60));
  EXPECT_FALSE(run(jumped, 1, Pace::Live, 60, 3.6e9, ClockCheck::Clock::time_point(milliseconds(3000))));
  EXPECT_FALSE(run(jumped, 1, Pace::Live, 60, 0, ClockCheck::Clock::time_point(milliseconds(6000))));
}

}  // namespace
}  // namespace hexoderm
