// What the global solver spends its time on, as ratios within one run: the kernels with vector instructions, the same
// on any machine, and CHOLMOD's supernodal factor where it is installed, of the same matrices; and whole solutions in
// units of 100,000 singular value decompositions of 3 x 3 matrices by Eigen. CPU time, the least of several
// repetitions. Run as
//
//   build/release/tests/benchmarks/global_ratios [largest number of cells] [--factor | --solve]

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/reconstruction/sparse/block_cholesky.h"
#include "tests/benchmarks/sheet_matrix.h"

#include <Eigen/SVD>
#ifdef HEXODERM_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>

namespace hexoderm {
namespace {

/// CPU time in ms: the least of at least `repetitions`, and of as many as go into `least_ms`.
template <class Work>
double timeOf(Work&& work, int repetitions = 5, double least_ms = 300) {
  double least = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int k = 0; k < repetitions || sum < least_ms; ++k) {
    const std::clock_t begin = std::clock();
    work();
    const double time_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    least = std::min(least, time_ms);
    sum += time_ms;
    if (k > 0 && sum > 20'000) break;
  }
  return least;
}

double unit_ms() {
  std::vector<Eigen::Matrix3d> matrices(1000);
  for (Eigen::Matrix3d& M : matrices) M.setRandom();
  double sum = 0;
  const double time_ms = timeOf([&] {
    for (int k = 0; k < 100'000; ++k) {
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrices[static_cast<std::size_t>(k % 1000)],
                                                  Eigen::ComputeFullU | Eigen::ComputeFullV);
      sum += svd.matrixU()(0, 0);
    }
  });
  if (sum == 0.5) std::printf("\n");  // so that nothing is optimised away
  return time_ms;
}

void print(const char* what, double ours_ms, double portable_ms, double other_ms) {
  std::printf("  %-34s %10.2f ms   any machine: x %5.2f", what, ours_ms, portable_ms / ours_ms);
  if (other_ms > 0) std::printf("   CHOLMOD: x %5.2f", other_ms / ours_ms);
  std::printf("\n");
  std::fflush(stdout);
}

void compareFactors(std::int64_t rows, std::int64_t columns) {
  const SheetProblem sheet(rows, columns);
  const SheetMatrix matrix = SheetMatrix::of(sheet);
  std::printf("%zu cells\n", matrix.diagonal.size());
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(matrix.lower.rows(), 6);
  double analyse_ms = 0;
  double factor_ms = 0;
  double solve_ms = 0;
#ifdef HEXODERM_HAS_CHOLMOD
  {
    Eigen::CholmodSupernodalLLT<SheetMatrix::Sparse, Eigen::Lower> cholmod;
    analyse_ms = timeOf([&] { cholmod.analyzePattern(matrix.lower); }, 3, 100);
    factor_ms = timeOf([&] { cholmod.factorize(matrix.lower); });
    Eigen::MatrixXd x;
    solve_ms = timeOf([&] { x = cholmod.solve(right); });
  }
#endif
  std::shared_ptr<const SupernodalPattern> pattern;
  const double ours_ms = timeOf([&] { pattern = matrix.pattern(); }, 3, 100);
  print("analyse", ours_ms, ours_ms, analyse_ms);
  BlockCholesky fast(pattern);
  BlockCholesky portable(pattern, portableFrontKernels());
  print("factor", timeOf([&] { fast.factorize(matrix.diagonal, matrix.blocks); }),
        timeOf([&] { portable.factorize(matrix.diagonal, matrix.blocks); }), factor_ms);
  const auto solve = [&](const BlockCholesky& cholesky) {
    Eigen::MatrixXd x = right;
    cholesky.solve(x);
  };
  print("solve, 6 columns", timeOf([&] { solve(fast); }), timeOf([&] { solve(portable); }), solve_ms);
  const RightSides border = fast.ordered(matrix.border);
  RightSides solved;
  Eigen::MatrixXd gram;
  const auto solveBorder = [&](const BlockCholesky& cholesky, const FrontKernels& kernels) {
    solved = border;
    cholesky.solveLower(solved);
    gram = solved.gram(kernels);
  };
  print("border", timeOf([&] { solveBorder(fast, frontKernels()); }),
        timeOf([&] { solveBorder(portable, portableFrontKernels()); }), 0);
  BlockCholesky::SelectedInverse inverse;
  print("selected inverse", timeOf([&] { inverse = fast.selectedInverse(); }),
        timeOf([&] { inverse = portable.selectedInverse(); }), 0);
  NormalEquations equations;
  const auto linearized_ms = [&](const LinearizeKernels* kernels) {
    return timeOf([&] { linearize(sheet.problem, sheet.state, equations, kernels); });
  };
  const double lanes_ms = linearized_ms(&linearizeKernels());
  print("linearize", lanes_ms, linearized_ms(&portableLinearizeKernels()), 0);
  print("linearize, one by one", lanes_ms, linearized_ms(nullptr), 0);
}

void solveWhole(std::int64_t rows, std::int64_t columns, double unit) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), sheetOptions(rows, columns));
  const Session session = simulateSession(skin, 3);
  const auto snapshot = session.snapshot();
  std::shared_ptr<const Reconstruction> result;
  const double cold_ms = timeOf([&] { result = reconstruct(*snapshot); }, 3);
  std::printf("%zu cells, 3 poses: from scratch %.2f", skin.truth().size(), cold_ms / unit);
  std::fflush(stdout);
  Session fewer = session;
  fewer.removePose(2);
  const auto before = reconstruct(*fewer.snapshot());
  const double warm_ms = timeOf([&] { result = reconstruct(*snapshot, {}, before.get()); }, 3);
  std::printf(", from the result of two poses %.2f", warm_ms / unit);
  const double again_ms = timeOf([&] { result = reconstruct(*snapshot, {}, result.get()); }, 3);
  std::printf(", from its own result %.2f units (%.1f, %.1f, %.1f ms)\n", again_ms / unit, cold_ms, warm_ms, again_ms);
  std::fflush(stdout);
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  std::int64_t most = 100'000;
  bool factor = true;
  bool solve = true;
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--factor") {
      solve = false;
    } else if (argument == "--solve") {
      factor = false;
    } else {
      most = std::atol(argv[k]);
    }
  }
  const std::int64_t sheets[][2] = {{35, 36}, {100, 100}, {316, 316}};
  if (factor) {
    for (const auto& [rows, columns] : sheets) {
      if (rows * columns <= most) hexoderm::compareFactors(rows, columns);
    }
  }
  if (!solve) return 0;
  const double unit = hexoderm::unit_ms();
  std::printf("unit: 100,000 decompositions, %.1f ms\n", unit);
  for (const auto& [rows, columns] : sheets) {
    if (rows * columns <= most) hexoderm::solveWhole(rows, columns, unit);
  }
  return 0;
}
