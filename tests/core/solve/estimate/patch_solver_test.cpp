#include "hexoderm/solve/estimate/patch_solver.h"

#include "hexoderm/solve/estimate/patch_description.h"
#include "tests/support/estimated_links.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/solvers.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(PatchSolver, SolvingAddsTheJointEstimate) {
  test::EstimatedLinks estimated(bentX17().session(orthogonalUps(3)), test::by(Solver::Global, GapModel::Pivot));
  const std::vector<double> weights = linkWeights(estimated.links);
  std::vector<PatchSolver> patches;
  patches.emplace_back(estimated.links, weights, 0);
  EXPECT_FALSE(patches[0].isSolved());
  EXPECT_EQ(patches[0].joint(), nullptr);
  ASSERT_EQ(patches[0].solve(nullptr, {}), Completion::Finished);
  EXPECT_TRUE(patches[0].isSolved());
  ASSERT_NE(patches[0].joint(), nullptr);
  const std::vector<PatchReconstruction> described = describePatches(estimated.links, patches, weights);
  for (const CellPlacement& cell : described[0].cells) EXPECT_TRUE(cell.accel_offset_g) << cell.cell;
  EXPECT_TRUE(described[0].gap_share);
  EXPECT_NE(described[0].covariance, nullptr);
}

TEST(PatchSolver, AnEstimateThatHasNotConvergedIsAFinding) {
  std::vector<Finding> findings;
  GlobalSolution solution;
  nameUnconverged(CellId(7), solution, findings);
  EXPECT_TRUE(findings.empty());
  solution.termination = GlobalTermination::StepLimit;
  solution.iterations = 100;
  nameUnconverged(CellId(7), solution, findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, FindingCode::NotConverged);
  EXPECT_EQ(findings[0].severity, Severity::Warning) << "no such result is called good";
  EXPECT_EQ(findings[0].cells, std::vector<CellId>{CellId(7)});
  EXPECT_NE(findings[0].message.english().find("100 steps"), std::string::npos);
}

}  // namespace
}  // namespace hexoderm
