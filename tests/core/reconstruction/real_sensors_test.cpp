// What sessions of a real robot's leg tell of its sensors, and what they don't: gravity is seen from two directions
// only.

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/reconstruction/sensor_statistics.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

// Known of these boards otherwise.
constexpr double kOffset_g = 0.020;
constexpr double kScale = 0.005;
constexpr double kSymmetricCrossAxis = 0.015;  // half the sum of two elements

std::shared_ptr<const SessionSnapshot> read(const std::string& name) {
  return readSessionJson(std::string(HEXODERM_REFERENCE_DATA) + "/real/icub_leg/" + name + ".session.json").snapshot();
}

TEST(RealSensors, ThreeHoldsTellOffsetsAndNothingOfTheAxes) {
  const auto statistics = estimateSensorStatistics(std::vector{read("three_holds")});
  const SensorSigmas& sigmas = statistics->sigmas;
  EXPECT_EQ(statistics->cells_used, 5U);
  ASSERT_EQ(sigmas.offset_g.knowledge, SigmaKnowledge::Measured);
  EXPECT_LE(sigmas.offset_g.low_95, kOffset_g);
  EXPECT_GE(sigmas.offset_g.high_95, kOffset_g);
  EXPECT_EQ(sigmas.scale.knowledge, SigmaKnowledge::Unknown);
  EXPECT_EQ(sigmas.cross_axis.knowledge, SigmaKnowledge::Unknown);
}

TEST(RealSensors, FifteenWindowsTellTheCrossAxisSensitivityRoughly) {
  const auto statistics = estimateSensorStatistics(std::vector{read("one_long_and_twelve_short_windows")});
  const SensorSigmas& sigmas = statistics->sigmas;
  ASSERT_EQ(sigmas.cross_axis.knowledge, SigmaKnowledge::Measured);
  EXPECT_LE(sigmas.cross_axis.low_95, std::sqrt(2.0) * kSymmetricCrossAxis);
  EXPECT_GE(sigmas.cross_axis.high_95, std::sqrt(2.0) * kSymmetricCrossAxis);
  EXPECT_LT(sigmas.cross_axis.worth, 10);
  for (const auto& [estimate, known] : {std::pair(sigmas.offset_g, kOffset_g), std::pair(sigmas.scale, kScale)}) {
    EXPECT_NE(estimate.knowledge, SigmaKnowledge::Measured) << "two directions are not enough";
    EXPECT_TRUE(estimate.knowledge == SigmaKnowledge::Unknown || estimate.high_95 >= known) << estimate.high_95;
  }
}

TEST(RealSensors, ModelsThatGrantMoreThanTheBoardsNeedAreNotContradicted) {
  for (const char* const name : {"three_holds", "three_holds_cut_into_five", "one_long_and_twelve_short_windows"}) {
    EXPECT_EQ(std::ranges::count(reconstruct(*read(name))->findings, FindingCode::SensorsUnlikeModel, &Finding::code),
              0)
        << name;
  }
}

}  // namespace
}  // namespace hexoderm
