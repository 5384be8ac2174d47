#include "hexoderm/solve/estimate/patch_solver.h"

#include "tests/support/estimated_links.h"
#include "tests/support/simulated_skins.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(PatchSolver, NoMisfitIsMoreThanItsQuickBound) {
  test::EstimatedLinks estimated(test::simulatedSession(test::skinOptions("sheet:5x5"), 3));
  PatchSolver patch(estimated.links, linkWeights(estimated.links), 0);
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
