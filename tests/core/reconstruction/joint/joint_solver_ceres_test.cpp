// Both solvers must find one optimum.

#include "hexoderm/reconstruction/joint/joint_solver.h"
#include "tests/core/reconstruction/joint/ceres_oracle.h"
#include "tests/core/reconstruction/joint/joint_case.h"

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
void expectSameOptimum(const JointProblem& problem, const JointState& start, const std::string& what) {
  const JointSolution ours = solveJointly(problem, start);
  EXPECT_EQ(ours.termination, JointTermination::Converged) << what;
  CeresOracle oracle(problem, start);
  const double ceres_cost = costByCeres(oracle);
  EXPECT_NEAR(ours.cost / ceres_cost, 1, 1e-6) << what << ", " << ours.iterations << " iterations";
  EXPECT_NEAR(jointCost(problem, oracle.state()) / ceres_cost, 1, 1e-8) << what << ": it is the same cost";

  CeresOracle onwards(problem, ours.state);
  EXPECT_LT(1 - costByCeres(onwards) / ours.cost, 1e-6) << what << ": Ceres improves our optimum";
  EXPECT_LT(1 - solveJointly(problem, oracle.state()).cost / ceres_cost, 1e-6) << what << ": we improve Ceres' optimum";
  ::testing::Test::RecordProperty(what, std::to_string(1e9 * (ours.cost / ceres_cost - 1)) + "e-9");
}

SimulatedSkinOptions skin(const std::string& patch, const std::string& surface, std::uint64_t seed) {
  SimulatedSkinOptions options;
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  return options;
}

TEST(JointSolverAgainstCeres, SameOptimumOnX17) {
  for (const GapShare& gap : {kFitGap, kArcGap, kPivotGap}) {
    for (const std::size_t poses : {2U, 3U}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const JointCase example = simulatedCase(skin("x17", "", seed), poses, gap);
        const JointState start = perturbed(example.problem, example.truth, 0.05, 0.001, seed);
        expectSameOptimum(
            example.problem, start,
            std::string(nameOf(gap)) + ", " + std::to_string(poses) + " poses, seed " + std::to_string(seed));
      }
    }
  }
}

TEST(JointSolverAgainstCeres, SameOptimumOnAClosedRing) {
  for (const GapShare& gap : {kFitGap, kArcGap, kPivotGap}) {
    const JointCase example = simulatedCase(skin("ring8:closed", "", 4), 3, gap);
    expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.05, 0.001, 4), nameOf(gap));
  }
}

TEST(JointSolverAgainstCeres, SameOptimumOnASheet) {
  for (const GapShare& gap : {kFitGap, kArcGap, kPivotGap}) {
    const JointCase example = simulatedCase(skin("sheet:5x5", "cylinder:r=0.06", 5), 3, gap);
    expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.05, 0.001, 5), nameOf(gap));
  }
}

TEST(JointSolverAgainstCeres, SameOptimumWithAngularAccelerations) {
  JointCase example = simulatedCase(skin("sheet:10x10", "cylinder:r=0.1", 6), 3, kFitGap);
  example.problem.accelerations = true;
  expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.03, 0.001, 6), "10x10");
}

TEST(JointSolverAgainstCeres, SameOptimumWithOutliersAndCellsWithoutReadings) {
  JointCase example = simulatedCase(skin("sheet:5x5", "cylinder:r=0.06", 7), 4, kFitGap);
  example.problem.readings[7].clear();
  example.problem.readings[3][1].y_g = Eigen::Vector3d(0.9, 0.1, 0.2);
  example.problem.readings[18][2].y_g.y() += 0.5;
  expectSameOptimum(example.problem, perturbed(example.problem, example.truth, 0.02, 0.0005, 7), "outliers");
}

}  // namespace
}  // namespace hexoderm
