// What further poses do to the stated uncertainty; and skins with more poses than the joint equations find angular
// accelerations for: what a hand does must make no healthy cell look broken.

#include "hexoderm/base/units.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

constexpr std::size_t kMany = test::kSlowBuild ? 60 : 200;
constexpr const char* kSheet = test::kSlowBuild ? "sheet:6x6" : "sheet:10x10";

Session measured(const std::string& patch, std::size_t poses) {
  return test::simulatedSession(test::skinOptions(patch, "", 3), poses);
}

/// Cells whose accelerometers are said to be broken.
std::vector<CellId> blamedCells(const Reconstruction& result) {
  std::vector<CellId> cells;
  for (const Finding& finding : result.findings) {
    if (finding.code == FindingCode::InconsistentSensor) cells.push_back(finding.cells.at(0));
  }
  return cells;
}

double orientationError_rad(const Session& session, const Reconstruction& result) {
  return compareToTruth(result, *session.truth()).at(0).orientation_rms_rad;
}

class ManyPosesOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Skins, ManyPosesOf, ::testing::Values("x17", "ring31:closed", kSheet));

TEST_P(ManyPosesOf, BlameNoHealthyCellAndMakeNothingWorse) {
  const Session few = measured(GetParam(), 40);
  const Session many = measured(GetParam(), kMany);
  const auto from_few = reconstruct(*few.snapshot());
  const auto from_many = reconstruct(*many.snapshot());
  EXPECT_THAT(blamedCells(*from_many), IsEmpty());
  EXPECT_EQ(from_many->poses.size(), kMany);
  EXPECT_THAT(*from_many, IsFinite());
  EXPECT_LT(orientationError_rad(many, *from_many), 1.1 * orientationError_rad(few, *from_few));
}

#ifdef NDEBUG
// Far from the middle a hand's swings weigh most: these cells were called broken by the hundred.
TEST(ManyPoses, ALargeSkinHasNoBrokenCellsJustBecauseItsPosesAreMany) {
  double actual_rad2 = 0;  // sums over the cells but the origin
  double stated_rad2 = 0;
  for (const std::uint64_t seed : {3U, 101U, 104U}) {
    SimulatedSkin skin = test::simulatedSkin(test::skinOptions("sheet:35x36", "cylinder:r=0.25", seed));
    const auto result = reconstruct(*simulateSession(skin, 60).snapshot());
    EXPECT_THAT(blamedCells(*result), IsEmpty()) << "seed " << seed;
    const PatchReconstruction& patch = result->patches.front();
    for (const CellPlacement& cell : patch.cells) {
      if (cell.cell == patch.origin) continue;
      const SE3 T_o_u = test::truePlacement(skin, patch.origin).inverse() * test::truePlacement(skin, cell.cell);
      actual_rad2 += logSO3(cell.T_o_u.R.transpose() * T_o_u.R).squaredNorm();
      stated_rad2 += cell.cov_t_r->bottomRightCorner<3, 3>().trace();
    }
  }
  EXPECT_LT(std::sqrt(actual_rad2), 1.1 * std::sqrt(stated_rad2));
  EXPECT_GT(std::sqrt(actual_rad2), 0.7 * std::sqrt(stated_rad2));
}
#endif

TEST(ManyPoses, ABrokenCellIsNamedAndNoOther) {
  // A cell whose second axis is wired the wrong way round: no rotation of the cell explains that.
  static constexpr CellId kBroken{24};
  const Session session = changed(measured(kSheet, kMany), [](std::size_t, GravitySample& sample) {
    if (sample.cell == kBroken) sample.mean_g.y() *= -1;
  });
  const auto result = reconstruct(*session.snapshot());
  EXPECT_THAT(blamedCells(*result), ElementsAre(kBroken));
}

// --- one pose more

/// A session's first poses only.
std::shared_ptr<const Reconstruction> solveFirst(const Session& whole, std::size_t poses) {
  Session session = whole;
  while (session.poses().size() > poses) session.removePose(session.poses().size() - 1);
  return reconstruct(*session.snapshot());
}

TEST(MorePoses, NeverMakeTheStatedUncertaintyMuchWorse) {
  // A pose in which the hand swung harder than in the others may raise it, but no model switches on.
  constexpr double kMuch = 1.1;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Session session = test::simulatedSession(test::skinOptions("x17", "cylinder:r=0.0501", seed), 10);
    double before_rad = kPi;
    for (std::size_t poses = 2; poses <= 10; ++poses) {
      const auto result = solveFirst(session, poses);
      const double now_rad = *result->assessment.orientation_95_rad;
      EXPECT_LE(toDegrees(now_rad), kMuch * toDegrees(before_rad)) << "seed " << seed << ", pose " << poses;
      before_rad = now_rad;
    }
  }
}

TEST(MorePoses, AreForeseenAsTheyComeOut) {
  // The forecast of a session's assessment against what the advised pose then brings.
  double ratio_sum = 0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Session session = test::simulatedSession(test::skinOptions("x17", "", seed), 3);
    const auto two = solveFirst(session, 2);
    const auto three = solveFirst(session, 3);
    ASSERT_TRUE(two->assessment.wantsPose());
    EXPECT_LT(*three->assessment.orientation_95_rad, 0.85 * *two->assessment.orientation_95_rad);
    ratio_sum += *three->assessment.orientation_95_rad / *two->assessment.orientation_95_rad;
    ++count;
  }
  EXPECT_LT(ratio_sum / static_cast<double>(count), 0.6);
}

}  // namespace
}  // namespace hexoderm
