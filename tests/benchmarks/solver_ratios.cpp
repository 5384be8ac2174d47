// Times of the solvers as ratios that hold on any computer: the CPU time of the tree and of the global solver in units
// of 100,000 Eigen::JacobiSVD<Matrix3d>, and how many times as long Ceres takes for the same cost from the same start.
//
//   build/core/tests/benchmarks/solver_ratios [CELLS...]     (1260 10000; 99856 takes minutes)

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/reconstruction/solved_skin.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/freed_memory.h"
#include "hexoderm/util/text.h"

#ifdef HEXODERM_HAS_CERES
#include "tests/core/reconstruction/joint/ceres_oracle.h"
#endif

#include <time.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

constexpr std::size_t kPoses = 3;
/// Ceres takes minutes beyond that.
constexpr std::size_t kMostCellsForCeres = 10'000;

/// CPU time of all threads of this process.
double cpuSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least CPU time of several runs, until half a second is spent; ms.
template <class Run>
double leastMs(Run run) {
  double least = INFINITY;
  double sum = 0;
  for (int k = 0; k < 20 && (k < 3 || sum < 0.5) && !(k > 0 && sum > 10); ++k) {
    const double begin = cpuSeconds();
    run();
    const double spent = cpuSeconds() - begin;
    least = std::min(least, spent);
    sum += spent;
  }
  return 1000 * least;
}

double yardstickMs() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Matrix3d> matrices(1000);
  for (Eigen::Matrix3d& matrix : matrices) matrix = matrix.unaryExpr([&](double) { return normal(random); });
  double sum = 0;
  const double ms = leastMs([&] {
    for (int k = 0; k < 100; ++k) {
      for (const Eigen::Matrix3d& matrix : matrices) {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
        sum += svd.singularValues()(0);
      }
    }
  });
  if (!(sum > 0)) std::abort();
  return ms;
}

Session sheet(std::size_t cells) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(cells)));
  SimulatedSkinOptions options;
  options.patch = "sheet:" + std::to_string(rows) + "x" + std::to_string(cells / rows);
  options.surface = "cylinder:r=" + formatExact(0.25 * std::sqrt(static_cast<double>(cells) / 1260));
  options.seed = 3;
  SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  return simulateSession(skin, kPoses);
}

void print(const std::string& what, double ms, double yardstick_ms) {
  std::cout << "  " << what << std::string(what.size() < 44 ? 44 - what.size() : 1, ' ') << formatFixed(ms, 2)
            << " ms, " << formatFixed(ms / yardstick_ms, 3) << '\n';
}

#ifdef HEXODERM_HAS_CERES
/// The tree's placements, and the forces that the readings mean there.
JointState stateOfTree(const PatchSolver& patch, const JointProblem& problem) {
  JointState state;
  for (const TreePlacement& placement : patch.treePlacements()) state.cells.push_back(placement.T_o_u);
  state.force_o.assign(problem.poses, Eigen::Vector3d::Zero());
  state.acceleration_o.assign(problem.poses, Eigen::Vector3d::Zero());
  const Eigen::Matrix3d& R_u_a = problem.model->accelerometer.T_u_a.R;
  for (std::size_t cell = 0; cell < state.cells.size(); ++cell) {
    state.middle_o += state.cells[cell].t / static_cast<double>(state.cells.size());
    for (const CellReading& reading : problem.readings[cell]) {
      state.force_o[reading.pose] += state.cells[cell].R * R_u_a * reading.y_g;
    }
  }
  for (Eigen::Vector3d& force : state.force_o) force.normalize();
  state.gap_share = problem.gap.mean;
  return state;
}

/// One cost, one start, one thread, without covariances.
void compareWithCeres(const SessionSnapshot& snapshot, double yardstick_ms) {
  const SolverOptions options;
  const std::unique_ptr<const SolvedSkin> solved = solveSkin(snapshot, options);
  const PatchSolver& patch = solved->patches().front();
  const JointProblem& problem = patch.joint()->problem();
  const JointState start = stateOfTree(patch, problem);
  JointSolverOptions without_covariance;
  without_covariance.covariance = false;
  double cost = 0;
  const double ms = leastMs([&] { cost = solveJointly(problem, start, without_covariance).cost; });
  print("joint cost from the tree, without covariances", ms, yardstick_ms);
  // Ceres' other direct solver, SPARSE_SCHUR, takes minutes here.
  ceres::Solver::Options ceres_options = oracle::CeresOracle::exactOptions();
  ceres_options.num_threads = 1;
  ceres_options.function_tolerance = without_covariance.cost_tolerance;
  oracle::CeresOracle ceres(problem, start);
  const double begin = cpuSeconds();
  const ceres::Solver::Summary summary = ceres.solve(ceres_options);
  const double ceres_ms = 1000 * (cpuSeconds() - begin);
  print("the same by Ceres", ceres_ms, yardstick_ms);
  std::cout << "    " << summary.iterations.size()
            << " steps, its cost less ours, relative: " << summary.final_cost / cost - 1 << '\n';
  std::cout << "  Ceres takes " << formatFixed(ceres_ms / ms, 1) << " times as long\n";
}
#endif

void compare(std::size_t cells, double yardstick_ms) {
  const Session session = sheet(cells);
  const auto snapshot = session.snapshot();
  std::cout << session.neighbors().size() << " cells, " << kPoses << " poses:\n";
  SolverOptions tree;
  tree.solver = Solver::Tree;
  print("tree, in memory", leastMs([&] { reconstruct(*snapshot, tree); }), yardstick_ms);
  print("global from scratch", leastMs([&] { reconstruct(*snapshot); }), yardstick_ms);
  Session without_last = session;
  without_last.removePose(kPoses - 1);
  const auto before = reconstruct(*without_last.snapshot());
  print("global from the result of a pose less", leastMs([&] { reconstruct(*snapshot, {}, before.get()); }),
        yardstick_ms);
#ifdef HEXODERM_HAS_CERES
  if (cells <= kMostCellsForCeres) compareWithCeres(*snapshot, yardstick_ms);
#endif
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  using namespace hexoderm;
  keepFreedMemory();  // as the programs do
  std::vector<std::size_t> sizes;
  for (int k = 1; k < argc; ++k) sizes.push_back(parseUnsigned(argv[k], "cells"));
  if (sizes.empty()) sizes = {1260, 10'000};
  const double yardstick_ms = yardstickMs();
  std::cout << "CPU time, and in units of 100,000 JacobiSVD<Matrix3d> (" << formatFixed(yardstick_ms, 1) << " ms)\n";
  for (const std::size_t cells : sizes) compare(cells, yardstick_ms);
}
