#include "tests/benchmarks/factor_ratios.h"

#include "hexoderm/solve/sparse/block_cholesky.h"
#include "tests/benchmarks/cpu_time.h"
#include "tests/benchmarks/sheet_matrix.h"

#include <Eigen/SparseCholesky>
#ifdef HEXODERM_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cstdio>
#include <memory>
#include <optional>

namespace hexoderm {
namespace {

/// Eigen's factor takes minutes beyond that.
constexpr std::size_t kMaxCellsForEigen = 30'000;

/// Times of a library for the same; nothing where it has no counterpart or is not there.
struct Library {
  std::optional<double> analyse;
  std::optional<double> factor;
  std::optional<double> solve;
};

template <class Solver>
Library timesOf(const SheetMatrix& matrix, const Eigen::MatrixXd& right) {
  Solver solver;
  Library times;
  times.analyse = least_ms([&] { solver.analyzePattern(matrix.lower); });
  times.factor = least_ms([&] { solver.factorize(matrix.lower); });
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

void compareFactors(std::size_t rows, std::size_t columns) {
  const SheetProblem sheet(rows, columns);
  const SheetMatrix matrix = SheetMatrix::of(sheet);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(matrix.lower.rows(), 6);
  Library eigen;
  if (matrix.diagonal.size() <= kMaxCellsForEigen) {
    eigen = timesOf<Eigen::SimplicialLLT<SheetMatrix::Sparse, Eigen::Lower, Eigen::AMDOrdering<int>>>(matrix, right);
  }
  Library cholmod;
#ifdef HEXODERM_HAS_CHOLMOD
  cholmod = timesOf<Eigen::CholmodSupernodalLLT<SheetMatrix::Sparse, Eigen::Lower>>(matrix, right);
#endif
  std::shared_ptr<const SupernodalPattern> pattern;
  print("analyse", least_ms([&] { pattern = matrix.pattern(); }), {}, eigen.analyse, cholmod.analyse);
  BlockCholesky fast(pattern);
  BlockCholesky portable(pattern, portableFrontKernels());
  const auto factorize = [&](BlockCholesky& cholesky) {
    return least_ms([&] { static_cast<void>(cholesky.factorize(matrix.diagonal, matrix.blocks)); });
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
        [&] { solved = cholesky.ordered(matrix.border); });
  };
  print("border of three poses", solveBorder(fast, frontKernels()), solveBorder(portable, portableFrontKernels()));
  const auto invert = [](const BlockCholesky& cholesky) {
    return least_ms([&] { static_cast<void>(cholesky.selectedInverse()); });
  };
  print("selected inverse", invert(fast), invert(portable));
  NormalEquations equations;
  const auto linearized = [&](const LinearizeKernels& kernels) {
    return least_ms([&] { linearize(sheet.problem, sheet.state, equations, kernels); });
  };
  print("linearize", linearized(linearizeKernels()), linearized(portableLinearizeKernels()));
}

}  // namespace hexoderm
