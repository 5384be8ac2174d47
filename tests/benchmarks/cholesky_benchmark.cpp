// How long the factor of a large skin's matrix takes: Hexoderm's BlockCholesky, Eigen's SimplicialLLT with approximate
// minimum degree and, where it is installed, CHOLMOD's supernodal factor, all of the same matrix. It is the one that
// the joint estimate of a simulated sheet begins with. Run as
//
//   build/release/tests/benchmarks/cholesky_benchmark
//
// The statistic to read is the least CPU time of many repetitions: other programs only ever make it longer. Figures and
// what follows from them are in core/hexoderm/reconstruction/sparse/README.md.

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/reconstruction/patch/patch_solver.h"
#include "hexoderm/reconstruction/sparse/block_cholesky.h"
#include "hexoderm/session/simulated_session.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#ifdef HEXODERM_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <map>
#include <stdexcept>

namespace hexoderm {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

struct Matrix {
  std::vector<Matrix6d> diagonal;
  std::vector<BlockCouple> couples;
  std::vector<Matrix6d> blocks;  ///< per couple
  Sparse lower;                  ///< the lower triangle of the same
};

Sparse lowerTriangle(const Matrix& matrix) {
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
  for (std::size_t k = 0; k < matrix.diagonal.size(); ++k) put(k, k, matrix.diagonal[k]);
  for (std::size_t k = 0; k < matrix.couples.size(); ++k) {
    const BlockCouple& couple = matrix.couples[k];
    if (couple.row > couple.column) {
      put(couple.row, couple.column, matrix.blocks[k]);
    } else {
      put(couple.column, couple.row, matrix.blocks[k].transpose());
    }
  }
  const auto size = static_cast<Eigen::Index>(6 * matrix.diagonal.size());
  Sparse lower(size, size);
  lower.setFromTriplets(elements.begin(), elements.end());
  return lower;
}

/// The matrix of a sheet of `rows` rows and one column more, in three poses, at the tree's placements.
const Matrix& matrixOfSheet(std::int64_t rows, std::int64_t columns) {
  static std::map<std::int64_t, Matrix> known;
  Matrix& matrix = known[rows];
  if (!matrix.diagonal.empty()) return matrix;
  SimulatedSkinOptions simulated;
  simulated.patch = "sheet:" + std::to_string(rows) + "x" + std::to_string(columns);
  simulated.surface = "cylinder:r=" + std::to_string(0.25 * static_cast<double>(columns) / 36);
  SimulatedSkin skin(builtInCellModel("hex-bma150"), simulated);
  const auto snapshot = simulateSession(skin, 3).snapshot();
  std::vector<Finding> findings;
  const SolverOptions options;
  SkinLinks links(*snapshot, options, findings);
  links.estimateEdges();
  const PatchSolver tree(links, linkWeights(links), 0);
  std::vector<SE3> placements;
  for (const TreePlacement& placed : tree.treePlacements()) placements.push_back(placed.T_o_u);
  const JointRefinement joint(links.model(), links.graph(), links.table(), options, tree.cells(), tree.origin(),
                              placements);
  NormalEquations equations;
  linearize(joint.problem(), joint.solution().state, equations);
  matrix.diagonal = equations.cells;
  matrix.blocks = equations.links;
  for (const JointLink& link : joint.problem().links) matrix.couples.push_back({link.c, link.n});
  matrix.lower = lowerTriangle(matrix);
  return matrix;
}

void require(bool is_factorized) {
  if (!is_factorized) throw std::runtime_error("the matrix is not positive definite");
}

struct Ours {
  explicit Ours(const Matrix& matrix) : cholesky(matrix.diagonal.size(), matrix.couples) {}
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
