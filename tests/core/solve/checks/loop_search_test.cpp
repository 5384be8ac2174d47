#include "hexoderm/solve/checks/loop_search.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

std::shared_ptr<const Reconstruction> solvedBy(const PinJointedSkin& skin, Solver solver = Solver::Tree) {
  return reconstruct(*skin.session(orthogonalUps(3)).snapshot(), test::by(solver, GapModel::Pivot));
}

TEST(LoopSearch, FindsTheTwoPortsOfAnOpenRingWithTheirGap) {
  const auto result = solvedBy(ringOfEight(44 * kDegree));
  const std::vector<FoundLoop> loops = findLoops(*result);
  ASSERT_THAT(loops, SizeIs(1));
  const LoopEvaluation expected = evaluateLoop(*result, kRingFirst, kRingLast);
  EXPECT_FALSE(loops[0].closed);
  EXPECT_THAT(loops[0].cells, SizeIs(8));
  EXPECT_EQ(loops[0].closure.first, kRingFirst);
  EXPECT_EQ(loops[0].closure.second, kRingLast);
  EXPECT_LT((loops[0].closure.gap_m - expected.gap_m).norm(), 1e-12);
  EXPECT_NEAR(loops[0].closure.length_m, expected.length_m, 1e-12);
  EXPECT_NEAR(loops[0].closure.loop_length_m, expected.loop_length_m, 1e-12);
  EXPECT_NEAR(loops[0].closure.percent, expected.percent, 1e-9);
}

TEST(LoopSearch, PortsFurtherApartThanHalfAPitchDoNotFaceEachOther) {
  for (const double bend_deg : {43.5, 43.0, 42.5, 42.0, 41.5, 41.0, 20.0}) {
    const auto result = solvedBy(ringOfEight(bend_deg * kDegree));
    const double gap_m = evaluateLoop(*result, kRingFirst, kRingLast).length_m;
    EXPECT_EQ(findLoops(*result).size(), gap_m < result->model->reach_m() ? 1 : 0) << bend_deg << ", " << gap_m;
  }
}

TEST(LoopSearch, AClosedRingIsOneLoopThatCloses) {
  for (const Solver solver : {Solver::Tree, Solver::Global}) {
    PinJointedSkin skin = ringOfEight(45 * kDegree);
    skin.connect(kRingFirst, kRingLast);
    const std::vector<FoundLoop> loops = findLoops(*solvedBy(skin, solver));
    ASSERT_THAT(loops, SizeIs(1));
    EXPECT_TRUE(loops[0].closed);
    EXPECT_THAT(loops[0].cells, SizeIs(8));
    EXPECT_LT(loops[0].closure.length_m, 1e-5);
    EXPECT_NEAR(loops[0].closure.loop_length_m, 0.22228, 1e-5) << "the paper's 16 port vectors";
  }
}

TEST(LoopSearch, AClosedLoopsGapIsThatOfItsOrientationsWhicheverWayPositionsWereSolved) {
  // Orientations of a ring that is not quite one; only its links say that it is closed.
  PinJointedSkin skin = ringOfEight(44 * kDegree);
  const auto open = findLoops(*solvedBy(skin));
  skin.connect(kRingFirst, kRingLast);
  const auto closed = findLoops(*solvedBy(skin));
  ASSERT_THAT(closed, SizeIs(1));
  EXPECT_TRUE(closed[0].closed);
  EXPECT_NEAR(closed[0].closure.length_m, open.at(0).closure.length_m, 1e-9);
}

TEST(LoopSearch, ATreeHasNoLoop) {
  EXPECT_THAT(findLoops(*solvedBy(bentX17())), IsEmpty());
  EXPECT_THAT(findLoops(*reconstruct(*test::simulatedSession({}, 3).snapshot())), IsEmpty());
  EXPECT_THAT(findLoops(Reconstruction()), IsEmpty());
}

TEST(LoopSearch, JoinedCellsWithMorePortsOnTheirSidesAreNoLoop) {
  CellModel model = builtInCellModel("hex-bma150");
  model.ports.push_back({PortNumber(5), {0.012, -0.006, 0}});
  model.ports.push_back({PortNumber(6), {-0.012, 0.008, 0}});
  EXPECT_THAT(findLoops(*solvedBy(ringOfEight(20 * kDegree, model))), IsEmpty());
}

TEST(LoopSearch, ASheetHasEveryIndependentLoopOnceTheWorstFirst) {
  const auto result = reconstruct(*test::simulatedSession(test::skinOptions("sheet:4x5"), 3).snapshot());
  const std::vector<FoundLoop> loops = findLoops(*result);
  const PatchReconstruction& patch = result->patches.front();
  const auto closed = static_cast<std::size_t>(std::ranges::count(loops, true, &FoundLoop::closed));
  EXPECT_EQ(closed, patch.links.size() - patch.cells.size() + 1);
  EXPECT_EQ(closed, loops.size()) << "the edges of a flat sheet face nothing";
  for (const FoundLoop& loop : loops) {
    EXPECT_THAT(loop.cells, SizeIs(4)) << "loops of a sheet are its meshes";
    EXPECT_LT(loop.closure.length_m, 0.005);
  }
  EXPECT_TRUE(std::ranges::is_sorted(loops, std::ranges::greater(),
                                     [](const FoundLoop& loop) { return loop.closure.length_m; }));
}

}  // namespace
}  // namespace hexoderm
