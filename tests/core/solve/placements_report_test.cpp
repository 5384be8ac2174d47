// What whoever does not want to wait for a whole result is told.

#include "hexoderm/solve/reconstructor.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

#include <stop_token>

namespace hexoderm {
namespace {

/// On a robot, where nothing is found afterwards that would change the placements.
Session stillSession(std::size_t poses) {
  return test::simulatedSession(test::robotOptions("sheet:5x6", "cylinder:r=0.1", 5), poses);
}

class PlacementsReport : public testing::Test {
 protected:
  PlacementsReport() {
    progress_.setPlacementsReport([this](auto placements) {
      stages_.push_back(progress_.stage());
      placements_.push_back(std::move(placements));
    });
  }

  SolveProgress progress_;
  std::vector<std::shared_ptr<const Reconstruction>> placements_;
  std::vector<SolveStage> stages_;  ///< in which each of them came
};

void expectSamePlacements(const Reconstruction& early, const Reconstruction& result) {
  ASSERT_EQ(early.patches.size(), result.patches.size());
  for (std::size_t patch = 0; patch < result.patches.size(); ++patch) {
    const PatchReconstruction& expected = result.patches[patch];
    EXPECT_EQ(early.patches[patch].origin, expected.origin);
    ASSERT_EQ(early.patches[patch].cells.size(), expected.cells.size());
    EXPECT_EQ(early.patches[patch].links.size(), expected.links.size());
    EXPECT_EQ(early.patches[patch].gravity.size(), expected.gravity.size());
    for (std::size_t cell = 0; cell < expected.cells.size(); ++cell) {
      EXPECT_EQ(early.patches[patch].cells[cell].cell, expected.cells[cell].cell);
      EXPECT_EQ(early.patches[patch].cells[cell].predecessor, expected.cells[cell].predecessor);
      EXPECT_EQ(early.patches[patch].cells[cell].T_o_u.R, expected.cells[cell].T_o_u.R);
      EXPECT_EQ(early.patches[patch].cells[cell].T_o_u.t, expected.cells[cell].T_o_u.t);
      EXPECT_EQ(early.patches[patch].cells[cell].sensors.size(), expected.cells[cell].sensors.size());
    }
  }
}

void expectNothingUnknown(const Reconstruction& early) {
  EXPECT_THAT(early.findings, IsEmpty());
  for (const PatchReconstruction& patch : early.patches) {
    EXPECT_EQ(patch.covariance, nullptr);
    EXPECT_FALSE(patch.gap_share);
    for (const CellPlacement& cell : patch.cells) {
      EXPECT_FALSE(cell.cov_t_r || cell.shape_cov_t_r || cell.accel_offset_g || cell.accel_scale);
    }
  }
}

TEST_F(PlacementsReport, OfTheTreeComesBeforeFaultsAreSearched) {
  const Session session = stillSession(3);
  const auto result = reconstruct(*session.snapshot(), test::by(Solver::Tree), nullptr, {}, &progress_);
  ASSERT_THAT(placements_, SizeIs(1));
  EXPECT_EQ(placements_[0]->revision, result->revision);
  EXPECT_EQ(placements_[0]->solver, "tree");
  EXPECT_EQ(placements_[0]->layout.cells.size(), result->layout.cells.size());
  expectNothingUnknown(*placements_[0]);
  expectSamePlacements(*placements_[0], *result);
}

TEST_F(PlacementsReport, OfTheGlobalSolverComesFromTheTreeAndThenFromTheJointEstimate) {
  const Session session = stillSession(3);
  const auto tree = reconstruct(*session.snapshot(), test::by(Solver::Tree));
  const auto result = reconstruct(*session.snapshot(), test::by(Solver::Global), nullptr, {}, &progress_);
  ASSERT_THAT(stages_, ElementsAre(SolveStage::Links, SolveStage::Patches));
  for (const auto& early : placements_) expectNothingUnknown(*early);
  const auto unwatched = reconstruct(*session.snapshot());
  expectSamePlacements(*unwatched, *result);
  for (std::size_t cell = 0; cell < result->patches[0].cells.size(); ++cell) {
    EXPECT_EQ(unwatched->patches[0].cells[cell].cov_t_r, result->patches[0].cells[cell].cov_t_r);
  }
  expectSamePlacements(*placements_[0], *tree);
  expectSamePlacements(*placements_[1], *result);
}

TEST_F(PlacementsReport, OfTheTreeIsNotMadeWhereAnEarlierResultIsBetter) {
  const auto before = reconstruct(*stillSession(2).snapshot(), test::by(Solver::Global));
  const Session session = stillSession(3);
  const auto result = reconstruct(*session.snapshot(), test::by(Solver::Global), before.get(), {}, &progress_);
  ASSERT_THAT(placements_, SizeIs(1));
  expectSamePlacements(*placements_[0], *result);
}

TEST_F(PlacementsReport, OfTheTreeIsMadeWhereTheEarlierResultIsOfAnotherSkinOrNoUse) {
  const Session session = stillSession(3);
  const auto before = reconstruct(*session.snapshot());
  static_cast<void>(reconstruct(*session.snapshot(), test::by(Solver::Tree), before.get(), {}, &progress_));
  EXPECT_THAT(placements_, SizeIs(1)) << "the tree does not start from it";
  placements_.clear();
  static_cast<void>(reconstruct(*test::simulatedSession({}, 3).snapshot(), {}, before.get(), {}, &progress_));
  EXPECT_THAT(placements_, SizeIs(2));
}

TEST_F(PlacementsReport, OfPatchesWithFaultsEndsWithThePlacementsOfTheResult) {
  SimulatedSkinOptions options = test::robotOptions("sheet:6x6", "cylinder:r=0.1", 5);
  options.faults = {{SkinFault::Swapped, CellId(15)}};
  const auto result = reconstruct(*test::simulatedSession(options, 4).snapshot(), {}, nullptr, {}, &progress_);
  ASSERT_FALSE(result->findings.empty());
  EXPECT_GT(placements_.size(), 2U) << "solved again without the fault";
  expectSamePlacements(*placements_.back(), *result);
}

TEST_F(PlacementsReport, OfSmallerSkinsThanWereAskedForIsNotMade) {
  const Session session = stillSession(2);
  const auto count = [&](std::size_t least_cells) {
    std::size_t reports = 0;
    SolveProgress progress;
    progress.setPlacementsReport([&](const auto&) { ++reports; }, least_cells);
    static_cast<void>(reconstruct(*session.snapshot(), test::by(Solver::Tree), nullptr, {}, &progress));
    return reports;
  };
  EXPECT_EQ(count(30), 1U);
  EXPECT_EQ(count(31), 0U);
}

TEST_F(PlacementsReport, WhoeverHasSeenEnoughStopsTheRest) {
  std::stop_source stop;
  SolveProgress progress;
  progress.setPlacementsReport([&](const auto&) { stop.request_stop(); });
  EXPECT_EQ(reconstruct(*stillSession(3).snapshot(), {}, nullptr, stop.get_token(), &progress), nullptr);
}

TEST_F(PlacementsReport, OfASkinWithoutCellsOrPosesIsNoError) {
  SessionSnapshot empty;
  empty.model = std::make_shared<const CellModel>(builtInCellModel("hex-bma150"));
  empty.neighbors = std::make_shared<const NeighborList>();
  ASSERT_NE(reconstruct(empty, {}, nullptr, {}, &progress_), nullptr);
  ASSERT_THAT(placements_, SizeIs(1)) << "of no cells an earlier result has all";
  EXPECT_EQ(placements_.back()->cellCount(), 0U);
  placements_.clear();
  ASSERT_NE(reconstruct(*stillSession(0).snapshot(), test::by(Solver::Tree), nullptr, {}, &progress_), nullptr);
  ASSERT_THAT(placements_, SizeIs(1));
  EXPECT_EQ(placements_.back()->cellCount(), 30U);
}

}  // namespace
}  // namespace hexoderm
