// Readings of the simulated skin's accelerometers.

#include "hexoderm/base/units.h"
#include "hexoderm/device/pose_capture.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/core/sim/standard_skin.h"
#include "tests/support/independent_chips.h"
#include "tests/support/options.h"
#include "tests/support/sample_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const double kWhite_g = kModel.accelerometer.noise_g_per_sqrt_hz * std::sqrt(500.0);

SimulatedSkinOptions withFault(SkinFault kind, unsigned cell) {
  return test::with(SimulatedSkinOptions(), &SimulatedSkinOptions::faults, {{kind, CellId(cell)}});
}

/// All readings of one cell, in the order of the frames.
std::vector<Eigen::Vector3d> readingsOf(const std::vector<SampleFrame>& frames, unsigned cell) {
  std::vector<Eigen::Vector3d> readings;
  for (const SampleFrame& frame : frames) {
    for (const CellSample& sample : frame.samples) {
      if (sample.cell == CellId(cell)) readings.push_back(sample.acceleration_g);
    }
  }
  return readings;
}

/// Of a cell in the scripted poses.
std::vector<Eigen::Vector3d> readingsInPoses(SimulatedSkin& skin, std::size_t poses, unsigned cell) {
  std::vector<Eigen::Vector3d> readings;
  for (const Eigen::Vector3d& up : scriptedUpDirections(poses)) {
    std::ranges::copy(readingsOf(skin.record(up), cell), std::back_inserter(readings));
  }
  return readings;
}

Eigen::Vector3d meanOf(const std::vector<Eigen::Vector3d>& readings) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& reading : readings) sum += reading;
  return sum / static_cast<double>(readings.size());
}

/// Standard deviation per axis.
Eigen::Vector3d scatterOf(const std::vector<Eigen::Vector3d>& readings) {
  const Eigen::Vector3d mean = meanOf(readings);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& reading : readings) sum += (reading - mean).cwiseAbs2();
  return (sum / static_cast<double>(readings.size() - 1)).cwiseSqrt();
}

TEST(SimulatedReadings, OfAStandingPartAreGainTimesUpInTheCellFramePlusOffset) {
  const auto without_noise = test::with(&SimulatedSkinOptions::sensor_noise, false);
  for (const SimulatedSkinOptions& options : {SimulatedSkinOptions::ideal(), without_noise}) {
    for (const Eigen::Vector3d& up : scriptedUpDirections(8)) {
      SimulatedSkin skin(kModel, options);
      const std::vector<SampleFrame> frames = skin.record(3 * up, 2);
      ASSERT_EQ(frames.size(), 2U);
      for (const SampleFrame& frame : frames) {
        ASSERT_EQ(frame.samples.size(), 17U);
        for (std::size_t k = 0; k < frame.samples.size(); ++k) {
          const TrueCell& cell = skin.truth().at(k);
          EXPECT_EQ(frame.samples[k].cell, cell.id);
          const Eigen::Matrix3d R_a_b = (cell.T_b_u.R * cell.R_u_askew).transpose();
          const Eigen::Vector3d expected = cell.gain * (R_a_b * up) + cell.offset_g;
          EXPECT_LT((frame.samples[k].acceleration_g - expected).norm(), 1e-14);
        }
      }
    }
  }
}

TEST(SimulatedReadings, SensorErrorsHaveTheModelsSpread) {
  const SimulatedSkin skin(independentChips(),
                           test::with(SimulatedSkinOptions(), &SimulatedSkinOptions::patch, "sheet:50x40"));
  double offset = 0;
  double scale = 0;
  double cross = 0;
  for (const TrueCell& cell : skin.truth()) {
    const Eigen::Matrix3d error = cell.gain - Eigen::Matrix3d::Identity();
    offset += cell.offset_g.squaredNorm();
    scale += error.diagonal().squaredNorm();
    cross += error.squaredNorm() - error.diagonal().squaredNorm();
  }
  // 6,000 draws of each: 4 % is more than four standard deviations.
  const double count = static_cast<double>(skin.truth().size());
  EXPECT_NEAR(std::sqrt(offset / (3 * count)) / 0.06, 1, 0.04);
  EXPECT_NEAR(std::sqrt(scale / (3 * count)) / 0.02, 1, 0.04);
  EXPECT_NEAR(std::sqrt(cross / (6 * count)) / 0.005, 1, 0.04);
}

TEST(SimulatedReadings, OffsetsDriftWithTheModelsSigmasOwnAndShared) {
  constexpr std::size_t kSession = 30;  // recordings
  SimulatedSkinOptions options = SimulatedSkinOptions::ideal();
  options.patch = "sheet:10x10";
  SimulatedSkin still(kModel, options);
  options.drifts_after = kSession;
  SimulatedSkin skin(kModel, options);
  // Per recording, what each cell reads more than it would.
  std::vector<std::vector<Eigen::Vector3d>> drift;
  std::vector<Eigen::Vector3d> shared;
  double own = 0;
  for (std::size_t k = 0; k < 2 * kSession; ++k) {
    const SampleFrame drifted = skin.record(kUp, 1).front();
    const SampleFrame same = still.record(kUp, 1).front();
    drift.emplace_back();
    for (std::size_t cell = 0; cell < same.samples.size(); ++cell) {
      drift.back().push_back(drifted.samples[cell].acceleration_g - same.samples[cell].acceleration_g);
    }
    shared.push_back(meanOf(drift.back()));
    if (k < kSession) own += scatterOf(drift.back()).squaredNorm() / (3 * kSession);
  }
  const Accelerometer& a = kModel.accelerometer;
  EXPECT_NEAR(std::sqrt(own), a.offset_instability_sigma_g, 0.05 * a.offset_instability_sigma_g);
  const std::vector<Eigen::Vector3d> first(shared.begin(), shared.begin() + kSession);
  const std::vector<Eigen::Vector3d> second(shared.begin() + kSession, shared.end());
  EXPECT_NEAR(scatterOf(first).norm() / std::sqrt(3.0), a.offset_instability_shared_sigma_g, 0.0006);
  EXPECT_NEAR(scatterOf(second).norm() / std::sqrt(3.0), a.offset_instability_shared_sigma_g, 0.0006);
  EXPECT_NEAR(scatterOf(drift.back()).norm() / std::sqrt(3.0), a.offset_drift_sigma_g, 0.1 * a.offset_drift_sigma_g);
  EXPECT_GT((meanOf(second) - meanOf(first)).norm(), 0.002) << "all drifted together between the sessions";
  EXPECT_LT((meanOf(second) - meanOf(first)).norm(), 0.020);
}

TEST(SimulatedReadings, NoiseIsWhiteWithTheSensorsDensityAndQuantised) {
  SimulatedSkin skin(kModel, SimulatedSkinOptions());
  const std::vector<SampleFrame> frames = skin.record(kUp, 4000);
  const std::vector<Eigen::Vector3d> readings = readingsOf(frames, 1);
  ASSERT_EQ(readings.size(), 4000U);
  const double lsb = kModel.accelerometer.lsb_g;
  const double expected = std::sqrt(kWhite_g * kWhite_g + lsb * lsb / 12);
  const Eigen::Vector3d scatter = scatterOf(readings);
  const Eigen::Vector3d mean = meanOf(readings);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(scatter(axis) / expected, 1, 0.05);
    double neighbours = 0;
    for (std::size_t k = 1; k < readings.size(); ++k) {
      neighbours += (readings[k](axis) - mean(axis)) * (readings[k - 1](axis) - mean(axis));
    }
    EXPECT_NEAR(neighbours / 4000 / (expected * expected), 0, 0.07);
  }
  for (const Eigen::Vector3d& reading : readings) {
    const Eigen::Vector3d steps = reading / lsb;
    EXPECT_LT((steps - Eigen::Vector3d(steps.array().round())).norm(), 1e-9);
  }
}

TEST(SimulatedReadings, AreCutOffAtTheRange) {
  CellModel narrow = kModel;
  narrow.accelerometer.range_g = 0.5;
  SimulatedSkin skin(narrow, SimulatedSkinOptions::ideal());
  double largest = 0;
  const std::vector<SampleFrame> frames = skin.record({1, 0, 0}, 1);
  for (const CellSample& sample : frames.front().samples) {
    largest = std::max(largest, sample.acceleration_g.cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(largest, 0.5);
}

TEST(SimulatedReadings, ComeAtTheModelsRateOnARunningClock) {
  SimulatedSkin skin(kModel, SimulatedSkinOptions());
  const std::vector<SampleFrame> first = skin.record(kUp);
  const std::vector<SampleFrame> second = skin.record(kUp);
  ASSERT_EQ(first.size(), 100U);
  for (std::size_t k = 1; k < first.size(); ++k) EXPECT_NEAR(first[k].time_s - first[k - 1].time_s, 0.001, 1e-12);
  EXPECT_GT(second.front().time_s, first.back().time_s);
  EXPECT_TRUE(skin.record(kUp, 0).empty());
}

TEST(SimulatedReadings, FramesOneByOneAreThoseThatAreKept) {
  SimulatedSkinOptions options;
  options.faults = {{SkinFault::Stuck, CellId(3)}, {SkinFault::Swapped, CellId(5)}, {SkinFault::NoSamples, CellId(9)}};
  SimulatedSkin keeps(kModel, options);
  SimulatedSkin forgets(kModel, options);
  for (const Eigen::Vector3d& up : keeps.upDirections(3)) {
    const std::vector<SampleFrame> kept = keeps.record(up, 20);
    std::size_t next = 0;
    forgets.record(up, 20, [&](const SampleFrame& frame) {
      ASSERT_LT(next, kept.size());
      EXPECT_EQ(frame.samples.size(), 16U) << "cell 9 sends none";
      test::expectSameFrame(frame, kept[next]);
      ++next;
    });
    EXPECT_EQ(next, 20U);
  }
}

/// The direction that pointed up while frames were recorded, as the cells of a skin without sensor errors saw it.
Eigen::Vector3d meanUpSeen(const SimulatedSkin& skin, const std::vector<SampleFrame>& frames) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const SampleFrame& frame : frames) {
    for (std::size_t k = 0; k < frame.samples.size(); ++k) {
      sum += skin.truth()[k].T_b_u.R * frame.samples[k].acceleration_g;
    }
  }
  return sum.normalized();
}

SimulatedSkinOptions onlyHand(const std::string& patch = "x17") {
  return test::with(SimulatedSkinOptions::ideal(), &SimulatedSkinOptions::hand_held, true, &SimulatedSkinOptions::patch,
                    patch);
}

/// A skin in a hand of which this alone is not perfect, after the first pose, on the table.
SimulatedSkin inHandWith(double SimulatedSkinOptions::*imperfection, const std::string& patch = "x17") {
  SimulatedSkinOptions options = onlyHand(patch);
  for (double SimulatedSkinOptions::*each :
       {&SimulatedSkinOptions::hand_orientation_sigma_rad, &SimulatedSkinOptions::tremor_angle_sigma_rad,
        &SimulatedSkinOptions::tremor_acceleration_g, &SimulatedSkinOptions::drift_rad_per_s}) {
    if (each != imperfection) options.*each = 0;
  }
  SimulatedSkin skin(kModel, options);
  skin.record(kUp, 1);
  return skin;
}

TEST(SimulatedHand, TheFirstRecordingStandsOnATable) {
  SimulatedSkin skin(kModel, onlyHand());
  const std::vector<Eigen::Vector3d> readings = readingsOf(skin.record(kUp, 50), 3);
  for (const Eigen::Vector3d& reading : readings) EXPECT_EQ(reading, readings.front());
  EXPECT_LT((readings.front() - skin.truth()[2].T_b_u.R.transpose() * kUp).norm(), 1e-14);
}

TEST(SimulatedHand, MissesTheAskedOrientationByAFewDegrees) {
  SimulatedSkin skin = inHandWith(&SimulatedSkinOptions::hand_orientation_sigma_rad);
  double sum = 0;
  const int count = 500;
  for (int k = 0; k < count; ++k) sum += std::pow(angleBetween(meanUpSeen(skin, skin.record(kUp, 1)), kUp), 2);
  // Two horizontal axes of 3 degrees each.
  EXPECT_NEAR(toDegrees(std::sqrt(sum / count)), 3 * std::sqrt(2.0), 0.45);
}

TEST(SimulatedHand, Drifts) {
  SimulatedSkin skin = inHandWith(&SimulatedSkinOptions::drift_rad_per_s);
  double largest = 0;
  for (int k = 0; k < 30; ++k) {
    const std::vector<SampleFrame> frames = skin.record(kUp, 1001);
    const double moved = toDegrees(angleBetween(meanUpSeen(skin, {frames.front()}), meanUpSeen(skin, {frames.back()})));
    EXPECT_LT(moved, 0.501);  // drift about the vertical does not show
    largest = std::max(largest, moved);
  }
  EXPECT_GT(largest, 0.45);
}

TEST(SimulatedHand, HeldForLongIsStillTheSamePose) {
  SimulatedSkin skin = inHandWith(&SimulatedSkinOptions::drift_rad_per_s);
  const std::vector<SampleFrame> half_a_minute = skin.record(kUp, 30'000);
  double largest = 0;
  for (std::size_t k = 0; k < half_a_minute.size(); k += 100) {
    largest = std::max(largest, toDegrees(angleBetween(meanUpSeen(skin, {half_a_minute[k]}), kUp)));
  }
  EXPECT_GT(largest, 0.7);
  EXPECT_LT(largest, 1.501) << "drift that never comes back would be 15 degrees";
}

TEST(SimulatedHand, TremorShakesAllCellsAlike) {
  SimulatedSkin skin = inHandWith(&SimulatedSkinOptions::tremor_acceleration_g);
  double variance = 0;
  const int count = 20;
  for (int k = 0; k < count; ++k) {
    const std::vector<SampleFrame> frames = skin.record(kUp, 1000);
    const double of_first = scatterOf(readingsOf(frames, 1)).squaredNorm();
    EXPECT_NEAR(scatterOf(readingsOf(frames, 17)).squaredNorm(), of_first, 1e-12);
    variance += of_first / (3 * count);
  }
  EXPECT_NEAR(std::sqrt(variance) / 0.010, 1, 0.05);
}

TEST(SimulatedHand, TremorTurnsAndActsOnLeverArms) {
  SimulatedSkin skin = inHandWith(&SimulatedSkinOptions::tremor_angle_sigma_rad, "sheet:2x40");
  const unsigned middle = 20;
  const unsigned end = 1;
  double near = 0;
  double far = 0;
  const int count = 40;
  for (int k = 0; k < count; ++k) {
    const std::vector<SampleFrame> frames = skin.record(kUp, 500);
    near += std::pow(scatterOf(readingsOf(frames, middle)).z(), 2) / count;
    far += std::pow(scatterOf(readingsOf(frames, end)).z(), 2) / count;
  }
  // The mean of f^4 between 4 and 12 Hz is (8.87 Hz)^4; the hand is about in the middle of the strip.
  const double acceleration = std::pow(2 * kPi * 8.87, 2) * 0.05 * kDegree;
  const double arm = (skin.truth()[0].T_b_u.t - skin.truth()[79].T_b_u.t).norm() / 2;
  EXPECT_NEAR(std::sqrt(far) / (acceleration * arm / kStandardGravity), 1, 0.15);
  EXPECT_LT(std::sqrt(near), std::sqrt(far) / 5);
}

TEST(SimulatedHand, ReadingsAreTheDerivativesOfOneRigidMotion) {
  // Three collinear cells of a flat sheet: accelerations of a rigid body are linear in position.
  SimulatedSkin skin(kModel, test::with(onlyHand(), &SimulatedSkinOptions::surface, "plane"));
  skin.record(kUp, 1);
  const std::vector<SampleFrame> frames = skin.record({1, 0, 0}, 50);
  ASSERT_EQ(frames.size(), 50U);
  for (const SampleFrame& frame : frames) {
    const auto at = [&](std::size_t id) { return frame.samples[id - 1].acceleration_g; };  // flat: all frames alike
    EXPECT_LT((at(5) + at(9) - 2 * at(1)).norm(), 1e-13);
    EXPECT_LT((at(13) + at(17) - 2 * at(1)).norm(), 1e-13);
    EXPECT_GT((at(5) - at(9)).norm(), 1e-6);
  }
}

class SimulatedSkinSeed : public testing::TestWithParam<SimulatedSkinOptions> {};
INSTANTIATE_TEST_SUITE_P(Motions, SimulatedSkinSeed,
                         testing::Values(SimulatedSkinOptions(), SimulatedSkinOptions::robot()));

TEST_P(SimulatedSkinSeed, RepeatsEverythingAndAnotherOneNothing) {
  SimulatedSkinOptions options = GetParam();
  SimulatedSkin a(kModel, options);
  SimulatedSkin b(kModel, options);
  options.seed = 2;
  SimulatedSkin c(kModel, options);
  for (std::size_t k = 0; k < a.truth().size(); ++k) {
    EXPECT_EQ(a.truth()[k].T_b_u.R, b.truth()[k].T_b_u.R);
    EXPECT_EQ(a.truth()[k].T_b_u.t, b.truth()[k].T_b_u.t);
    EXPECT_EQ(a.truth()[k].offset_g, b.truth()[k].offset_g);
    EXPECT_EQ(a.truth()[k].gain, b.truth()[k].gain);
    EXPECT_NE(a.truth()[k].T_b_u.t, c.truth()[k].T_b_u.t);
    EXPECT_NE(a.truth()[k].offset_g, c.truth()[k].offset_g);
  }
  std::vector<Eigen::Vector3d> poses;
  for (int pose = 0; pose < 3; ++pose) {
    const std::vector<Eigen::Vector3d> of_a = readingsOf(a.record(kUp), 5);
    EXPECT_EQ(of_a, readingsOf(b.record(kUp), 5));
    EXPECT_NE(of_a, readingsOf(c.record(kUp), 5));
    for (const Eigen::Vector3d& earlier : poses) EXPECT_NE(of_a.front(), earlier);
    poses.push_back(of_a.front());
  }
}

TEST(SimulatedFault, LeavesTheOtherCellsAsTheyWere) {
  for (const SkinFault kind : {SkinFault::Dead, SkinFault::Stuck, SkinFault::StuckAxis, SkinFault::Saturated,
                               SkinFault::Noisy, SkinFault::NoSamples, SkinFault::WrongGain, SkinFault::DeadAxis}) {
    SimulatedSkin whole(kModel, SimulatedSkinOptions());
    SimulatedSkin broken(kModel, withFault(kind, 4));
    for (int pose = 0; pose < 2; ++pose) {
      const auto as_whole = whole.record(kUp, 20);
      const auto as_broken = broken.record(kUp, 20);
      for (const unsigned cell : {3U, 5U}) EXPECT_EQ(readingsOf(as_whole, cell), readingsOf(as_broken, cell));
      EXPECT_NE(readingsOf(as_whole, 4), readingsOf(as_broken, 4));
    }
  }
}

TEST(SimulatedFault, DeadReadsNoiseAboutZero) {
  SimulatedSkin skin(kModel, withFault(SkinFault::Dead, 4));
  const std::vector<Eigen::Vector3d> readings = readingsOf(skin.record(kUp, 400), 4);
  EXPECT_LT(meanOf(readings).norm(), 0.005);
  EXPECT_NEAR(scatterOf(readings).x(), kWhite_g, 0.002);
}

TEST(SimulatedFault, StuckRepeatsItsFirstReadingForEver) {
  SimulatedSkin skin(kModel, withFault(SkinFault::Stuck, 4));
  const Eigen::Vector3d first = readingsOf(skin.record(kUp), 4).front();
  EXPECT_GT(first.norm(), 0.7);
  EXPECT_THAT(readingsInPoses(skin, 3, 4), testing::Each(first));
}

TEST(SimulatedFault, StuckAxisHoldsOneAxisOnly) {
  SimulatedSkin skin(kModel, withFault(SkinFault::StuckAxis, 4));
  EXPECT_EQ((scatterOf(readingsInPoses(skin, 3, 4)).array() == 0).count(), 1);
}

TEST(SimulatedFault, SaturatedSitsAtItsRangeInEveryPose) {
  SimulatedSkin skin(kModel, withFault(SkinFault::Saturated, 4));
  for (const Eigen::Vector3d& up : scriptedUpDirections(6)) {
    const Eigen::Vector3d mean = meanOf(readingsOf(skin.record(up), 4));
    EXPECT_EQ(mean.cwiseAbs().maxCoeff(), kModel.accelerometer.range_g);
  }
}

TEST(SimulatedFault, NoisyScattersTwentyTimesAsMuch) {
  SimulatedSkin skin(kModel, withFault(SkinFault::Noisy, 4));
  const Eigen::Vector3d scatter = scatterOf(readingsOf(skin.record(kUp, 2000), 4));
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(scatter(axis) / (20 * kWhite_g), 1, 0.07);
}

TEST(SimulatedFault, WrongGainAmplifiesAllAxesAlike) {
  SimulatedSkinOptions options = withFault(SkinFault::WrongGain, 4);
  options.sensor_noise = false;
  SimulatedSkin broken(kModel, options);
  options.faults.clear();
  SimulatedSkin whole(kModel, options);
  for (const Eigen::Vector3d& up : scriptedUpDirections(4)) {
    const Eigen::Vector3d as_whole = readingsOf(whole.record(up, 1), 4).front();
    EXPECT_LT((readingsOf(broken.record(up, 1), 4).front() - 1.25 * as_whole).norm(), 1e-12);
  }
}

TEST(SimulatedFault, DeadAxisReadsNoiseAboutZeroInEveryPose) {
  std::array<int, 3> drawn{};
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SimulatedSkin skin(kModel, test::with(withFault(SkinFault::DeadAxis, 4), &SimulatedSkinOptions::seed, seed));
    const std::vector<Eigen::Vector3d> readings = readingsInPoses(skin, 3, 4);
    const Eigen::Vector3d scatter = scatterOf(readings);
    int axis = 0;
    scatter.minCoeff(&axis);
    ++drawn[axis];
    EXPECT_NEAR(meanOf(readings)(axis), 0, 0.003);
    EXPECT_NEAR(scatter(axis) / kWhite_g, 1, 0.2);
    EXPECT_EQ((scatter.array() > 0.2).count(), 2);
  }
  for (const int count : drawn) EXPECT_GT(count, 0);
}

TEST(SimulatedSkin, RefusesDirectionsThatAreNoneAndCellsThatAreNotThere) {
  SimulatedSkin skin(kModel, SimulatedSkinOptions());
  for (const Eigen::Vector3d& none :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, std::numeric_limits<double>::infinity())}) {
    EXPECT_THROW(skin.record(none), InvalidArgument);
    EXPECT_THROW(skin.turnTo(none), InvalidArgument);
  }
  for (const unsigned cell : {0U, 18U}) {
    EXPECT_THROW(SimulatedSkin(kModel, withFault(SkinFault::Dead, cell)), InvalidArgument);
    EXPECT_THROW(skin.breakCell({SkinFault::Dead, CellId(cell)}), InvalidArgument);
    EXPECT_THROW(skin.mendCell(CellId(cell)), InvalidArgument);
  }
}

TEST(ScriptedUpDirections, AreUnitAndApart) {
  EXPECT_TRUE(scriptedUpDirections(0).empty());
  const std::vector<Eigen::Vector3d> directions = scriptedUpDirections(60);
  ASSERT_EQ(directions.size(), 60U);
  for (std::size_t a = 0; a < directions.size(); ++a) {
    EXPECT_NEAR(directions[a].norm(), 1, 1e-14);
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT(angleBetween(directions[a], directions[b]), 4 * kDegree);
  }
}

TEST(ScriptedUpDirections, StartStandingThenOrthogonalThenTheFacesOfACube) {
  const std::vector<Eigen::Vector3d> directions = scriptedUpDirections(6);
  EXPECT_EQ(directions[0], kUp);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_EQ(directions[a].dot(directions[b]), 0);
    EXPECT_EQ(directions[a + 3], -directions[a]);
  }
  EXPECT_EQ(scriptedUpDirections(2), std::vector<Eigen::Vector3d>(directions.begin(), directions.begin() + 2));
}

TEST(ScriptedUpDirections, FillTheSphereEvenly) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& up : scriptedUpDirections(1000)) {
    spread += up * up.transpose() / 1000;
    mean += up / 1000;
  }
  EXPECT_LT(mean.norm(), 0.01);
  EXPECT_LT((3 * spread - Eigen::Matrix3d::Identity()).norm(), 0.03);
}

}  // namespace
}  // namespace hexoderm
