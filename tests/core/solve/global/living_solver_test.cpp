// One GlobalSolver for many solutions, and covariances that outlive its factors.

#include "hexoderm/solve/global/global_solver.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/solve/global/joint_case.h"
#include "tests/support/options.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

GlobalCase sheetInPoses(std::size_t poses) {
  return simulatedCase(test::skinOptions("sheet:5x6", "cylinder:r=0.06"), poses, kFitGap);
}

void expectSame(const GlobalSolution& a, const GlobalSolution& b, const GlobalProblem& problem) {
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.iterations, b.iterations);
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    EXPECT_EQ(a.state.cells[cell].t, b.state.cells[cell].t);
    EXPECT_EQ(a.state.cells[cell].R, b.state.cells[cell].R);
    EXPECT_EQ(a.covariance->cell(cell), b.covariance->cell(cell));
  }
}

TEST(LivingJointSolver, SolvesOneProblemAfterAnotherAsNewSolversDo) {
  GlobalSolver solver;
  std::vector<GlobalSolution> kept;  // their covariances must not be overwritten by later solutions
  std::vector<GlobalCase> cases;
  for (const std::size_t poses : {2U, 3U, 5U, 3U}) cases.push_back(sheetInPoses(poses));
  for (const GlobalCase& example : cases) kept.push_back(solver.solve(example.problem, example.truth));
  for (std::size_t k = 0; k < cases.size(); ++k) {
    expectSame(kept[k], GlobalSolver().solve(cases[k].problem, cases[k].truth), cases[k].problem);
  }
  kept.clear();  // from here on the factor's memory is used again
  for (const GlobalCase& example : cases) {
    expectSame(solver.solve(example.problem, example.truth), GlobalSolver().solve(example.problem, example.truth),
               example.problem);
    solver.releaseWorkspace();
  }
}

TEST(LivingJointSolver, CovariancesAtAStateAreTheSameInMemoryOfOthers) {
  const GlobalCase example = sheetInPoses(3);
  GlobalSolver solver;
  const auto fresh = GlobalSolver().covarianceAt(example.problem, example.truth);
  const GlobalCovariance& expected = *fresh;
  for (int k = 0; k < 2; ++k) {
    const auto found = solver.covarianceAt(example.problem, example.truth);
    for (std::size_t cell = 0; cell < example.problem.cellCount(); ++cell) {
      EXPECT_EQ(found->cell(cell), expected.cell(cell));
    }
  }
  const std::vector<Matrix6d> cells = cellCovariancesAt(example.problem, example.truth);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) EXPECT_EQ(cells[cell], expected.cell(cell));
}

/// A solution whose factor is given back, and one that keeps its own.
struct GivenBack {
  GlobalCase example = sheetInPoses(3);
  std::shared_ptr<const GlobalProblem> problem = std::make_shared<const GlobalProblem>(example.problem);
  GlobalSolver solver;
  GlobalSolution solution = solver.solve(*problem, example.truth);
  GlobalSolution whole = GlobalSolver().solve(*problem, example.truth);
};

TEST(LivingJointSolver, AFactorMadeOnceMoreIsTheSame) {
  GivenBack given;
  auto& problem = given.problem;
  auto& solution = given.solution;
  auto& whole = given.whole;
  solution.covariance->keepProblemInstead(problem);
  // Other solutions take the factor's memory.
  const GlobalCase other = sheetInPoses(2);
  given.solver.solve(other.problem, other.truth);
  expectSame(solution, whole, *problem);
  const auto size = static_cast<Eigen::Index>(6 * problem->cellCount());
  const Eigen::MatrixXd B = Eigen::MatrixXd::Identity(size, 7);
  EXPECT_EQ(solution.covariance->timesCells(B), whole.covariance->timesCells(B));
  EXPECT_EQ(solution.covariance->forces(1, 2), whole.covariance->forces(1, 2));
  EXPECT_EQ(solution.covariance->gapShareSigma(), whole.covariance->gapShareSigma());
  std::vector<std::thread> readers;
  for (std::size_t reader = 0; reader < 3; ++reader) {
    readers.emplace_back([&, reader] {
      solution.covariance->keepProblemInstead(problem);  // again, and while others ask
      for (std::size_t a = reader; a < problem->cellCount(); a += 3) {
        EXPECT_EQ(solution.covariance->between(a, 9), whole.covariance->between(a, 9));
      }
    });
  }
  for (std::thread& reader : readers) reader.join();
}

TEST(LivingJointSolver, WhatIsMadeInTheFactorsOwnMemoryIsTheSame) {
  GivenBack given;
  auto& [example, problem, solver, solution, whole] = given;
  solver.releaseWorkspace();
  solution.covariance->keepProblemInstead(problem);
  expectSame(solution, whole, *problem);
  for (std::size_t link = 0; link < problem->links.size(); ++link) {
    EXPECT_EQ(solution.covariance->link(link), whole.covariance->link(link));
  }
}

TEST(LivingJointSolver, WhatAResultIsAskedLaterOutlivesTheResultAndItsSkin) {
  const auto solve = [] { return reconstruct(*test::simulatedSession(test::skinOptions("sheet:3x4"), 3).snapshot()); };
  const auto whole = solve();
  const PatchReconstruction& patch = whole->patches.front();
  const auto covariance = solve()->patches.front().covariance;
  const auto gravity = solve()->patches.front().gravity_covariance->withoutTremor();
  for (const CellPlacement& cell : patch.cells) {
    EXPECT_EQ(covariance->relative(patch.cells.front().cell, cell.cell),
              patch.covariance->relative(patch.cells.front().cell, cell.cell));
  }
  EXPECT_EQ(gravity->forces(0, 1), patch.gravity_covariance->withoutTremor()->forces(0, 1));
}

}  // namespace
}  // namespace hexoderm
