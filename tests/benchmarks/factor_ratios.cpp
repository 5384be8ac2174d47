#include "tests/benchmarks/factor_ratios.h"

#include "hexoderm/solve/global/elimination_plan.h"
#include "hexoderm/solve/sparse/block_cholesky.h"
#include "tests/benchmarks/cpu_time.h"

#include <Eigen/SparseCholesky>
#ifdef HEXODERM_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {
namespace {

/// Eigen's factor takes minutes beyond that.
constexpr std::size_t kMaxCellsForEigen = 30'000;

using Sparse = Eigen::SparseMatrix<double>;

/// The lower triangle of the cells' matrix.
Sparse lowerTriangle(const GlobalProblem& problem, const NormalEquations& equations) {
  std::vector<Eigen::Triplet<double>> elements;
  const auto put = [&](std::size_t row_block, std::size_t column_block, const Matrix6d& block) {
    for (int column = 0; column < 6; ++column) {
      for (int row = 0; row < 6; ++row) {
        const int i = static_cast<int>(6 * row_block) + row;
        const int j = static_cast<int>(6 * column_block) + column;
        if (i >= j) elements.emplace_back(i, j, block(row, column));
      }
    }
  };
  for (std::size_t cell = 0; cell < equations.cells.size(); ++cell) put(cell, cell, equations.cells[cell]);
  for (std::size_t k = 0; k < problem.links.size(); ++k) {
    put(problem.links[k].c, problem.links[k].n, equations.links[k]);
    put(problem.links[k].n, problem.links[k].c, equations.links[k].transpose());
  }
  const auto size = static_cast<Eigen::Index>(6 * equations.cells.size());
  Sparse triangle(size, size);
  triangle.setFromTriplets(elements.begin(), elements.end());
  return triangle;
}

/// Times of a library for the same; nothing where it has no counterpart or is not there.
struct Library {
  std::optional<double> analyse;
  std::optional<double> factor;
  std::optional<double> solve;
};

template <class Solver>
Library timesOf(const Sparse& matrix, const Eigen::MatrixXd& right) {
  Solver solver;
  Library times;
  times.analyse = least_ms([&] { solver.analyzePattern(matrix); });
  times.factor = least_ms([&] { solver.factorize(matrix); });
  Eigen::MatrixXd x;
  times.solve = least_ms([&] { x = solver.solve(right); });
  return times;
}

void print(const char* what, double ours_ms, std::optional<double> portable_ms = {},
           std::optional<double> eigen_ms = {}, std::optional<double> cholmod_ms = {}) {
  std::printf("  %-26s %10.2f ms", what, ours_ms);
  const auto times = [&](const char* who, const std::optional<double>& ms) {
    if (ms) std::printf("   %s x %.2f", who, *ms / ours_ms);
  };
  times("without vectors", portable_ms);
  times("Eigen", eigen_ms);
  times("CHOLMOD", cholmod_ms);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

void compareFactors(const GlobalProblem& problem, const GlobalState& state) {
  NormalEquations equations;
  linearize(problem, state, equations);
  const Sparse matrix = lowerTriangle(problem, equations);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(matrix.rows(), 6);
  Library eigen;
  if (problem.cellCount() <= kMaxCellsForEigen) {
    eigen = timesOf<Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>>>(matrix, right);
  }
  Library cholmod;
#ifdef HEXODERM_HAS_CHOLMOD
  cholmod = timesOf<Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower>>(matrix, right);
#endif
  std::shared_ptr<const EliminationPlan> plan;
  print("analyse", least_ms([&] { plan = planElimination(problem); }), {}, eigen.analyse, cholmod.analyse);
  BlockCholesky fast(plan->pattern);
  BlockCholesky portable(plan->pattern, portableFrontKernels());
  const auto factorize = [&](BlockCholesky& cholesky) {
    return least_ms([&] { static_cast<void>(cholesky.factorize(equations.cells, equations.links)); });
  };
  print("factor", factorize(fast), factorize(portable), eigen.factor, cholmod.factor);
  const auto solve = [&](const BlockCholesky& cholesky) {
    return least_ms([&] {
      Eigen::MatrixXd x = right;
      cholesky.solve(x);
    });
  };
  print("solve, 6 columns", solve(fast), solve(portable), eigen.solve, cholmod.solve);
  const auto solveBorder = [&](const BlockCholesky& cholesky, const FrontKernels& kernels) {
    RightHandSides solved;
    Eigen::MatrixXd gram;
    return least_ms(
        [&] {
          cholesky.solveLower(solved);
          gram = solved.gram(kernels);
        },
        [&] { solved = cholesky.ordered(equations.border_cells); });
  };
  print("border of three poses", solveBorder(fast, frontKernels()), solveBorder(portable, portableFrontKernels()));
  const auto invert = [](const BlockCholesky& cholesky) {
    return least_ms([&] { static_cast<void>(cholesky.selectedInverse()); });
  };
  print("selected inverse", invert(fast), invert(portable));
  const auto linearized = [&](const LinearizeKernels& kernels) {
    return least_ms([&] { linearize(problem, state, equations, kernels); });
  };
  print("linearize", linearized(linearizeKernels()), linearized(portableLinearizeKernels()));
}

}  // namespace hexoderm
