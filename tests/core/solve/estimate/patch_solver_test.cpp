#include "hexoderm/solve/estimate/patch_solver.h"

#include "hexoderm/solve/estimate/patch_description.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

class PatchSolverTest : public ::testing::Test {
 protected:
  PatchSolverTest() {
    options_.gap_model = GapModel::Pivot;  // like the skin
    links_.estimateEdges();
    weights_ = linkWeights(links_);
  }

  std::shared_ptr<const SessionSnapshot> snapshot_ = bentX17().session(orthogonalUps(3)).snapshot();
  SolverOptions options_;
  std::vector<Finding> findings_;
  SkinLinks links_{*snapshot_, options_, findings_};
  std::vector<double> weights_;
};

TEST_F(PatchSolverTest, SolvingAddsTheJointEstimate) {
  std::vector<PatchSolver> patches;
  patches.emplace_back(links_, weights_, 0);
  EXPECT_FALSE(patches[0].isSolved());
  EXPECT_EQ(patches[0].joint(), nullptr);
  ASSERT_EQ(patches[0].solve(nullptr, {}), Completion::Finished);
  EXPECT_TRUE(patches[0].isSolved());
  ASSERT_NE(patches[0].joint(), nullptr);
  const std::vector<PatchReconstruction> described = describePatches(links_, patches, weights_);
  for (const CellPlacement& cell : described[0].cells) EXPECT_TRUE(cell.accel_offset_g) << cell.cell;
  EXPECT_TRUE(described[0].gap_share);
  EXPECT_NE(described[0].covariance, nullptr);
}

TEST_F(PatchSolverTest, NoMisfitIsMoreThanItsQuickBound) {
  const auto snapshot = test::simulatedSession(test::skinOptions("sheet:5x5"), 3).snapshot();
  const SolverOptions solver_options;
  SkinLinks links(*snapshot, solver_options, findings_);
  links.estimateEdges();
  PatchSolver patch(links, linkWeights(links), 0);
  ASSERT_EQ(patch.solve(nullptr, {}), Completion::Finished);
  for (const std::size_t cell : patch.cells()) {
    const Misfit exact = patch.joint()->misfitOf(cell);
    const Misfit bound = patch.joint()->mostMisfitOf(cell);
    EXPECT_GT(exact.chi_squared, 0) << cell;
    EXPECT_GE(bound.chi_squared, exact.chi_squared) << cell;
    EXPECT_EQ(bound.degrees, exact.degrees) << cell;
  }
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
