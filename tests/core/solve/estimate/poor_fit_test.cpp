#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/testing.h"

#include <cmath>

namespace hexoderm {
namespace {

Session skinOf(const std::string& patch, std::uint64_t seed, std::size_t poses) {
  SimulatedSkinOptions options;
  options.patch = patch;
  options.seed = seed;
  SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  return simulateSession(skin, poses, 100);
}

/// A number between -1 and 1 for every cell.
double drawnFor(CellId cell) { return std::sin(7.3 * cell.value()); }

void expectRefuted(const Session& session, const std::string& what) {
  const auto result = reconstruct(*session.snapshot());
  const Finding* finding = findingOf(*result, FindingCode::PoorFit);
  ASSERT_NE(finding, nullptr);
  EXPECT_THAT(finding->message.english(), HasSubstr(what));
  EXPECT_EQ(result->assessment.level, VerdictLevel::NotTrusted) << result->assessment.reason;
  EXPECT_FALSE(result->assessment.orientation_95_rad);
  for (const CellPlacement& cell : largestPatch(*result)->cells) EXPECT_FALSE(cell.cov_t_r);
}

TEST(PoorFit, ChipsThatAreAllTurnedInTheirCellsRefuteThePatch) {
  const Session session = changed(skinOf("x17", 3, 4), [](std::size_t /*pose*/, GravitySample& sample) {
    sample.mean_g = expSO3({0, 0, 9 * kDegree * drawnFor(sample.cell)}) * sample.mean_g;
  });
  expectRefuted(session, "The links");
}

TEST(PoorFit, CrossAxisSensitivitiesThatNoChipHasRefuteThePatch) {
  const Session session = changed(skinOf("sheet:5x5", 4, 6), [](std::size_t /*pose*/, GravitySample& sample) {
    const double share = 0.05 * drawnFor(sample.cell);
    const Eigen::Vector3d read_g = sample.mean_g;
    sample.mean_g += share * Eigen::Vector3d(read_g.y() - read_g.z(), read_g.z(), read_g.x());
  });
  expectRefuted(session, "The readings");
}

TEST(PoorFit, HealthySkinsAreNotAccused) {
  for (const std::string patch : {"x17", "ring12:closed", "sheet:5x5"}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const auto result = reconstruct(*skinOf(patch, seed, 2 + seed % 5).snapshot());
      EXPECT_THAT(*result, Not(HasFinding(FindingCode::PoorFit))) << patch << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace hexoderm
