#include "hexoderm/solve/estimate/patch_solver.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

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
