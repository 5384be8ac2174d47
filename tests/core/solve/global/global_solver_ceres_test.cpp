// Both solvers must find one optimum: of chips that share nothing, as the oracle has them.

#include "hexoderm/solve/global/global_solver.h"
#include "tests/core/solve/global/ceres_oracle.h"
#include "tests/core/solve/global/joint_case.h"
#include "tests/support/pin_jointed_skin.h"

#include <gtest/gtest.h>

#include <string>

namespace hexoderm {
namespace {

using oracle::CeresOracle;

double costByCeres(CeresOracle& oracle) {
  const ceres::Solver::Summary summary = oracle.solve();
  EXPECT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
  return summary.final_cost;
}

/// From one start both must end at one cost, and neither can improve what the other found.
void expectSameOptimum(const GlobalProblem& problem, const GlobalState& start, const std::string& what) {
  const GlobalSolution ours = GlobalSolver().solve(problem, start);
  EXPECT_EQ(ours.termination, GlobalTermination::Converged) << what;
  CeresOracle oracle(problem, start);
  const double ceres_cost = costByCeres(oracle);
  EXPECT_NEAR(ours.cost / ceres_cost, 1, 1e-6) << what << ", " << ours.iterations << " iterations";
  EXPECT_NEAR(jointCost(problem, oracle.state()) / ceres_cost, 1, 1e-8) << what << ": it is the same cost";

  CeresOracle onwards(problem, ours.state);
  EXPECT_LT(1 - costByCeres(onwards) / ours.cost, 1e-6) << what << ": Ceres improves our optimum";
  EXPECT_LT(1 - GlobalSolver().solve(problem, oracle.state()).cost / ceres_cost, 1e-6)
      << what << ": we improve Ceres' optimum";
}

TEST(GlobalSolverAgainstCeres, SameOptimumWithEveryGapModel) {
  struct Case {
    const char* patch;
    const char* surface;
    std::uint64_t seed;
    std::size_t poses;
  };
  for (const Case& c : {Case{"x17", "", 1, 2}, Case{"x17", "", 2, 2}, Case{"x17", "", 3, 2}, Case{"x17", "", 1, 3},
                        Case{"x17", "", 2, 3}, Case{"x17", "", 3, 3}, Case{"ring8:closed", "", 4, 3},
                        Case{"sheet:5x5", "cylinder:r=0.06", 5, 3}}) {
    for (const GapShare& gap : {kFitGap, kArcGap, kPivotGap}) {
      const GlobalCase example =
          simulatedCase(test::skinOptions(c.patch, c.surface, c.seed), c.poses, gap, independentChips());
      expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.05, 0.001, c.seed),
                        std::string(c.patch) + ", " + nameOf(gap) + ", " + std::to_string(c.poses) + " poses, seed " +
                            std::to_string(c.seed));
    }
  }
}

TEST(GlobalSolverAgainstCeres, SameOptimumWherePortsHaveHeight) {
  CellModel model = modelOfStepsAndFolds();
  model.accelerometer = {};
  for (const GapShare& gap : {kFitGap, kArcGap, kPivotGap}) {
    GlobalCase example = exactX17(model, gap.mean, 0.5, 0.2, 0.03, 1);
    example.problem.gap = gap;
    addExactReadings(example, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()});
    expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.05, 0.001, 1), nameOf(gap));
  }
}

TEST(GlobalSolverAgainstCeres, SameOptimumWithAngularAccelerations) {
  GlobalCase example =
      simulatedCase(test::skinOptions("sheet:10x10", "cylinder:r=0.1", 6), 3, kFitGap, independentChips());
  example.problem.accelerations = true;
  expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.03, 0.001, 6), "10x10");
}

TEST(GlobalSolverAgainstCeres, SameOptimumWithOutliersAndCellsWithoutReadings) {
  GlobalCase example =
      simulatedCase(test::skinOptions("sheet:5x5", "cylinder:r=0.06", 7), 4, kFitGap, independentChips());
  example.problem.readings[7].clear();
  example.problem.readings[3][1].y_g = Eigen::Vector3d(0.9, 0.1, 0.2);
  example.problem.readings[18][2].y_g.y() += 0.5;
  expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.02, 0.0005, 7), "outliers");
}

}  // namespace
}  // namespace hexoderm
