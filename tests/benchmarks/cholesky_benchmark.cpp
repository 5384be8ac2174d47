// How long the factor of a large skin's matrix takes: Hexoderm's BlockCholesky, Eigen's SimplicialLLT with approximate
// minimum degree and, where it is installed, CHOLMOD's supernodal factor, all of the same matrix. It is the one that
// the joint estimate of a simulated sheet begins with. Run as
//
//   build/release/tests/benchmarks/cholesky_benchmark
//
// The statistic to read is the least CPU time of many repetitions: other programs only ever make it longer. Figures and
// what follows from them are in core/hexoderm/reconstruction/sparse/README.md.

#include "hexoderm/reconstruction/sparse/block_cholesky.h"
#include "tests/benchmarks/sheet_matrix.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#ifdef HEXODERM_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace hexoderm {
namespace {

using Matrix = SheetMatrix;
using Sparse = SheetMatrix::Sparse;

const Matrix& matrixOfSheet(std::int64_t rows, std::int64_t columns) {
  static std::map<std::int64_t, Matrix> known;
  const auto [place, is_new] = known.try_emplace(rows);
  if (is_new) place->second = SheetMatrix::of(SheetProblem(rows, columns));
  return place->second;
}

void require(bool is_factorized) {
  if (!is_factorized) throw std::runtime_error("the matrix is not positive definite");
}

struct Ours {
  explicit Ours(const Matrix& matrix) : cholesky(matrix.pattern()) {}
  void factorize(const Matrix& matrix) { require(cholesky.factorize(matrix.diagonal, matrix.blocks)); }
  Eigen::MatrixXd solve(Eigen::MatrixXd right) const {
    cholesky.solve(right);
    return right;
  }
  BlockCholesky cholesky;
};

/// A solver of Eigen's, or one that Eigen wraps.
template <class Solver>
struct Wrapped {
  explicit Wrapped(const Matrix& matrix) { solver.analyzePattern(matrix.lower); }
  void factorize(const Matrix& matrix) {
    solver.factorize(matrix.lower);
    require(solver.info() == Eigen::Success);
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const { return solver.solve(right); }
  Solver solver;
};
using EigenSimplicial = Wrapped<Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>>>;
#ifdef HEXODERM_HAS_CHOLMOD
using Cholmod = Wrapped<Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower>>;
#endif

template <class Solver>
void analyse(benchmark::State& state) {
  const Matrix& matrix = matrixOfSheet(state.range(0), state.range(1));
  for ([[maybe_unused]] auto _ : state) {
    Solver solver(matrix);
    benchmark::DoNotOptimize(&solver);
  }
}

template <class Solver>
void factorise(benchmark::State& state) {
  const Matrix& matrix = matrixOfSheet(state.range(0), state.range(1));
  Solver solver(matrix);
  for ([[maybe_unused]] auto _ : state) solver.factorize(matrix);
  // All solvers are to have solved the same equations.
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(matrix.lower.rows(), 1);
  const Eigen::MatrixXd x = solver.solve(right);
  const Eigen::MatrixXd residual = matrix.lower.selfadjointView<Eigen::Lower>() * x - right;
  state.counters["residual"] = residual.cwiseAbs().maxCoeff();
  state.counters["cells"] = static_cast<double>(matrix.diagonal.size());
}

template <class Solver>
void solveOne(benchmark::State& state) {
  const Matrix& matrix = matrixOfSheet(state.range(0), state.range(1));
  Solver solver(matrix);
  solver.factorize(matrix);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(matrix.lower.rows(), 6);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(solver.solve(right));
}

void invertSelected(benchmark::State& state) {
  const Matrix& matrix = matrixOfSheet(state.range(0), state.range(1));
  Ours ours(matrix);
  ours.factorize(matrix);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(ours.cholesky.selectedInverse());
}

double least(const std::vector<double>& times) { return *std::ranges::min_element(times); }

// 1,260 and 10,100 cells.
void onSheets(benchmark::internal::Benchmark* run) {
  run->Args({35, 36})->Args({100, 101})->Unit(benchmark::kMillisecond)->Repetitions(15)->MinTime(0.05);
  run->ReportAggregatesOnly()->MeasureProcessCPUTime()->ComputeStatistics("least", least);
}

BENCHMARK(analyse<Ours>)->Apply(onSheets);
BENCHMARK(analyse<EigenSimplicial>)->Apply(onSheets);
BENCHMARK(factorise<Ours>)->Apply(onSheets);
BENCHMARK(factorise<EigenSimplicial>)->Apply(onSheets);
BENCHMARK(solveOne<Ours>)->Apply(onSheets);
BENCHMARK(solveOne<EigenSimplicial>)->Apply(onSheets);
#ifdef HEXODERM_HAS_CHOLMOD
BENCHMARK(analyse<Cholmod>)->Apply(onSheets);
BENCHMARK(factorise<Cholmod>)->Apply(onSheets);
BENCHMARK(solveOne<Cholmod>)->Apply(onSheets);
#endif
BENCHMARK(invertSelected)->Apply(onSheets);

}  // namespace
}  // namespace hexoderm
