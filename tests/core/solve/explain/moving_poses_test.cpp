#include "hexoderm/solve/reconstructor.h"
#include "tests/support/corrupted_readings.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

constexpr std::size_t kPoses = 5;
constexpr std::size_t kShaken = 2;

/// A skin of which all cells are shaken in one pose.
Session shakenSkin(const char* patch, const char* surface, std::uint64_t seed) {
  constexpr double kVibration_g = 0.1;
  constexpr double kRate_hz = 100;
  test::NormalDraw random(seed);
  return test::shaken(test::simulatedSession(test::skinOptions(patch, surface, seed), kPoses), kShaken, kVibration_g,
                      kRate_hz, random);
}

TEST(MovingPoses, AShakenPoseIsTheOnlyFindingAndIsNotUsed) {
  for (const auto& [patch, surface] : {std::pair("x17", ""), std::pair("sheet:5x5", "cylinder:r=0.08")}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      const Session session = shakenSkin(patch, surface, seed);
      const auto result = reconstruct(*session.snapshot());
      ASSERT_FALSE(result->findings.empty()) << patch << ", seed " << seed;
      for (const Finding& finding : result->findings) {
        EXPECT_THAT(finding.cells, IsEmpty()) << finding.message.english() << patch << ", seed " << seed;
        EXPECT_THAT(finding.poses, ElementsAre(session.poses()[kShaken].capture->id)) << patch << ", seed " << seed;
      }
      EXPECT_TRUE(result->assessment.isUsable()) << patch << ", seed " << seed;
    }
  }
}

TEST(MovingPoses, ACellThatTurnedIsNotTakenForAPoseInMotion) {
  SimulatedSkinOptions options = test::skinOptions("x17", "", 3);
  const Session session = changed(test::simulatedSession(options, kPoses), [](std::size_t pose, GravitySample& sample) {
    if (pose == kShaken && sample.cell == CellId(5)) {
      sample.mean_g = expSO3(Eigen::Vector3d(0.5, 0.3, 0)) * sample.mean_g;
    }
  });
  const auto result = reconstruct(*session.snapshot());
  EXPECT_THAT(result->findings, Not(Contains(Field(&Finding::code, FindingCode::InconsistentPose))));
}

}  // namespace
}  // namespace hexoderm
