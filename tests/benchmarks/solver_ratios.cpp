// Times as ratios that hold on any computer, in one run: the CPU time of the tree and of the global solver in units of
// 100,000 Eigen::JacobiSVD<Matrix3d>, the tree stage by stage; how many times as long the Boost Graph Library takes to
// find the origin from all pairs, Eigen and CHOLMOD for the factor of the same matrix, and Ceres for the same cost from
// the same start. All that on one core; then by how much the tree and the global solver are faster with all that there
// are. A hand holds the poses, or, with --still, a table.
//
//   build/release/tests/benchmarks/solver_ratios [CELLS...] [--factor | --solve | --global] [--still]
//
// CELLS are 1260 10000; 99856 takes minutes. --global is the global solver from scratch alone, for a profiler.

#include "hexoderm/base/freed_memory.h"
#include "hexoderm/base/parallel.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/vector_instructions.h"
#include "hexoderm/skin/origin_search.h"
#include "hexoderm/solve/estimate/patch_description.h"
#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/cell_health.h"
#include "hexoderm/solve/faults/suspects.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/solve.h"
#include "hexoderm/solve/tree/edge_batches.h"
#include "tests/benchmarks/cpu_time.h"
#include "tests/benchmarks/factor_ratios.h"
#include "tests/support/independent_chips.h"
#include "tests/support/options.h"
#include "tests/support/simulated_skins.h"
#ifdef HEXODERM_HAS_CERES
#include "tests/core/solve/global/ceres_oracle.h"
#endif

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numeric>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

constexpr std::size_t kPoses = 3;
/// Ceres takes minutes beyond that.
constexpr std::size_t kMaxCellsForCeres = 10'000;

/// About square, of chips that have nothing in common, as Ceres' cost has them.
Session sheet(std::size_t cells, bool hand_held) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(cells)));
  SimulatedSkin skin(independentChips(),
                     test::with(test::bentSheet(rows, cells / rows, 3), &SimulatedSkinOptions::hand_held, hand_held));
  return simulateSession(skin, kPoses);
}

void print(const std::string& what, double ms, double unit_ms) {
  std::cout << "  " << what << std::string(what.size() < 44 ? 44 - what.size() : 1, ' ') << formatFixed(ms, 2)
            << " ms, " << formatFixed(ms / unit_ms, 3) << '\n';
}

/// The cells as they are first placed `by` the tree or the joint estimate, and nothing after that.
std::shared_ptr<const Reconstruction> placeOnly(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                SolveStage by, const Reconstruction* earlier = nullptr) {
  std::shared_ptr<const Reconstruction> placed;
  std::stop_source enough;
  SolveProgress progress;
  progress.setPlacementsReport([&](auto placements) {
    if (progress.stage() != by) return;
    placed = std::move(placements);
    enough.request_stop();
  });
  reconstruct(snapshot, options, earlier, enough.get_token(), &progress);
  return placed;
}

#ifdef HEXODERM_HAS_CERES
/// Where the global solver starts: the tree's placements, and the forces that the readings mean there.
GlobalState stateOfTree(const SessionSnapshot& snapshot, const GlobalProblem& problem) {
  GlobalState state;
  const auto tree = placeOnly(snapshot, {}, SolveStage::Links);
  for (const CellPlacement& cell : tree->patches.front().cells) state.cells.push_back(cell.T_o_u);
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
void compareWithCeres(const SessionSnapshot& snapshot, double unit_ms) {
  const SolverOptions options;
  const std::unique_ptr<const Estimate> solved = solveSkin(snapshot, options);
  const PatchSolver& patch = solved->patches().front();
  const GlobalProblem& problem = patch.joint()->problem();
  const GlobalState start = stateOfTree(snapshot, problem);
  const auto without_covariance = test::with(&GlobalSolverOptions::covariance, false);
  double cost = 0;
  const double ms = least_ms([&] { cost = GlobalSolver().solve(problem, start, without_covariance).cost; });
  print("joint cost from the tree, without covariances", ms, unit_ms);
  // Ceres' other direct solver, SPARSE_SCHUR, takes minutes here.
  ceres::Solver::Options ceres_options = oracle::CeresOracle::exactOptions();
  ceres_options.num_threads = 1;
  ceres_options.function_tolerance = without_covariance.cost_tolerance;
  oracle::CeresOracle ceres(problem, start);
  const double begin = cpuTime_ms();
  const ceres::Solver::Summary summary = ceres.solve(ceres_options);
  const double ceres_ms = cpuTime_ms() - begin;
  print("the same by Ceres", ceres_ms, unit_ms);
  std::cout << "    " << summary.iterations.size()
            << " steps, its cost less ours, relative: " << summary.final_cost / cost - 1 << '\n';
  std::cout << "  Ceres takes " << formatFixed(ceres_ms / ms, 1) << " times as long\n";
}
#endif

/// All pairs by the Boost Graph Library: from every vertex of a small skin, and from some of a large one, times how
/// many there are.
double boostAllPairs_ms(const SkinGraph& skin, const std::vector<double>& weights) {
  using Property = boost::property<boost::edge_weight_t, double>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Property>;
  Graph graph(skin.cells().size());
  for (std::size_t k = 0; k < skin.links().size(); ++k) {
    const GraphLink& link = skin.links()[k];
    if (link.muted()) continue;
    boost::add_edge(link.source, link.target, Property(weights[k]), graph);
    boost::add_edge(link.target, link.source, Property(weights[k]), graph);
  }
  const std::size_t cells = skin.cells().size();
  const std::size_t step = std::max<std::size_t>(1, cells / 1000);
  std::vector<double> distance(cells);
  double sum = 0;
  std::size_t sources = 0;
  const double before = cpuTime_ms();
  for (std::size_t source = 0; source < cells; source += step, ++sources) {
    boost::dijkstra_shortest_paths_no_color_map(graph, source,
                                                boost::distance_map(boost::make_iterator_property_map(
                                                    distance.begin(), boost::get(boost::vertex_index, graph))));
    sum += distance.back();
  }
  const double took = cpuTime_ms() - before;
  if (sum == 0) std::abort();  // so that nothing is left out as unused
  return took * static_cast<double>(cells) / static_cast<double>(sources);
}

void compareWithBoost(const SessionSnapshot& snapshot, const SolverOptions& tree, double unit_ms) {
  const std::unique_ptr<const Estimate> solved = solveSkin(snapshot, tree);
  const SkinGraph& graph = solved->skin().graph();
  const std::vector<double> weights(solved->weights().begin(), solved->weights().end());
  const double ms = least_ms([&] { static_cast<void>(searchOrigin(graph, weights, 0)); });
  print("origin", ms, unit_ms);
  std::cout << "  Boost's all pairs take " << formatFixed(boostAllPairs_ms(graph, weights) / ms, 0)
            << " times as long\n";
}

/// The tree, stage by stage.
void printStages(const SessionSnapshot& snapshot, SolverOptions options, double unit_ms) {
  const auto row = [unit_ms](const std::string& what, double ms) { print("- " + what, ms, unit_ms); };
  row("graph from reports", least_ms([&] { SkinGraph(*snapshot.model, *snapshot.neighbors); }));
  std::vector<Finding> findings;
  SkinLinks skin(snapshot, options, findings);
  row("readings", least_ms([&] { GravityTable(snapshot, skin.graph(), findings); }));
  row("cells judged", least_ms([&] { judgeCells(snapshot, skin.graph(), skin.table(), findings); }));
  row("edges", least_ms([&] { skin.estimateEdges(); }));
  {
    std::vector<std::size_t> all(skin.graph().links().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<EdgeRotation> edges(all.size());
    std::vector<std::optional<double>> residuals(all.size() * skin.table().poseCount());
    const auto in_batches = [&](const char* what, EdgeKernel kernel) {
      row(what, least_ms([&] { estimateUsualEdges(skin, all, edges, residuals, kernel); }));
    };
    in_batches("  of these two at a time", estimateEdgesByTwo);
    if (hasVectorInstructions()) in_batches("  of these four at a time", estimateEdgesByFour);
  }
  row("pair tests", least_ms([&] { static_cast<void>(SuspectSearch(skin)); }));
  const std::vector<double> weights = linkWeights(skin);
  OriginFound found;
  const double origin_ms = least_ms([&] { found = searchOrigin(skin.graph(), weights, 0); });
  row("origin, " + std::to_string(found.runs) + " runs", origin_ms);
  ShortestPaths paths;
  row("paths", least_ms([&] { paths = findShortestPaths(skin.graph(), weights, found.origin); }));
  std::vector<Eigen::Matrix3d> attitudes;
  row("attitudes", least_ms([&] {
        attitudes.clear();
        for (const std::size_t cell : skin.graph().patches().front()) {
          attitudes.push_back(skin.attitudeCovariance(cell, paths.link[skin.graph().cells()[cell].place]));
        }
      }));
  row("placements", least_ms([&] {
        static_cast<void>(
            placeAlongTree(skin.graph(), skin.model(), paths, skin.edges(), attitudes, gapShareOf(options.gap_model)));
      }));
  std::vector<PatchSolver> patches;
  patches.emplace_back(skin, weights, 0);
  std::vector<PatchReconstruction> described;
  row("description", least_ms([&] { described = describePatches(skin, patches, weights); }));
  row("flat layout", least_ms([&] { static_cast<void>(computeFlatLayout(skin.model(), described)); }));
  options.weights = LinkWeights::Residual;
  const std::vector<double> real = linkWeights(skin);
  row("origin by residuals", least_ms([&] { found = searchOrigin(skin.graph(), real, 0); }));
  options.weights = SolverOptions().weights;
  Estimate estimate(snapshot, options);
  static_cast<void>(estimate.bringTo(Estimate::Stage::Patches, {}));
  row("attitudes searched for faults", least_ms([&] { static_cast<void>(makeAttitudeExplainer().explain(estimate)); }));
}

/// By the clock on the wall.
template <class Run>
void compareCores(const std::string& what, std::size_t count, const Run& run) {
  const auto wall_ms = [&] {
    return least_ms(
        run, [] {}, [] { return cpuTime_ms(CLOCK_MONOTONIC); });
  };
  const double alone_ms = wall_ms();
  setCores(count);
  const double together_ms = wall_ms();
  setCores(1);
  std::cout << "  " << what << " on " << count << " cores: " << formatFixed(alone_ms / together_ms, 2)
            << " times as fast as on one, " << formatFixed(together_ms, 1) << " ms\n";
}

void compare(std::size_t cells, bool hand_held, std::size_t count_of_cores, double unit_ms) {
  const Session session = sheet(cells, hand_held);
  const auto snapshot = session.snapshot();
  std::cout << session.neighbors().size() << " cells, " << kPoses
            << (hand_held ? " poses in a hand:\n" : " still poses:\n");
  const SolverOptions tree = test::with(&SolverOptions::solver, Solver::Tree);
  print("tree, in memory", least_ms([&] { reconstruct(*snapshot, tree); }), unit_ms);
  printStages(*snapshot, tree, unit_ms);
  print("- until its cells are placed", least_ms([&] { placeOnly(*snapshot, tree, SolveStage::Links); }), unit_ms);
  print("global from scratch", least_ms([&] { reconstruct(*snapshot); }), unit_ms);
  print("- until its cells are placed", least_ms([&] { placeOnly(*snapshot, {}, SolveStage::Patches); }), unit_ms);
  Session without_last = session;
  without_last.removePose(kPoses - 1);
  const auto before = reconstruct(*without_last.snapshot());
  print("global from the result of a pose less", least_ms([&] { reconstruct(*snapshot, {}, before.get()); }), unit_ms);
  print("- until its cells are placed", least_ms([&] { placeOnly(*snapshot, {}, SolveStage::Patches, before.get()); }),
        unit_ms);
  if (count_of_cores > 1) {
    compareCores("tree", count_of_cores, [&] { reconstruct(*snapshot, tree); });
    compareCores("global", count_of_cores, [&] { reconstruct(*snapshot); });
  }
  compareWithBoost(*snapshot, tree, unit_ms);
#ifdef HEXODERM_HAS_CERES
  if (cells <= kMaxCellsForCeres) compareWithCeres(*snapshot, unit_ms);
#endif
}

void compareFactors(const SessionSnapshot& snapshot) {
  const SolverOptions options;
  const std::unique_ptr<const Estimate> solved = solveSkin(snapshot, options);
  const GlobalRefinement& joint = *solved->patches().front().joint();
  compareFactors(joint.problem(), joint.solution().state);
}

/// For some seconds, from scratch.
void solveAgainAndAgain(const SessionSnapshot& snapshot) {
  constexpr double kSeconds = 10;
  const double begin = cpuTime_ms();
  while (cpuTime_ms() - begin < 1000 * kSeconds) reconstruct(snapshot);
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  using namespace hexoderm;
  keepFreedMemory();  // as the programs do
  std::vector<std::size_t> sizes;
  bool factor = true;
  bool solve = true;
  bool only_global = false;
  bool hand_held = true;
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    factor = factor && argument != "--solve";
    solve = solve && argument != "--factor";
    only_global = only_global || argument == "--global";
    hand_held = hand_held && argument != "--still";
    if (!argument.starts_with("--")) sizes.push_back(parseUnsigned(argument, "cells"));
  }
  if (sizes.empty()) sizes = {1260, 10'000};
  const std::size_t count_of_cores = cores();
  setCores(1);
  if (only_global) {
    for (const std::size_t cells : sizes) solveAgainAndAgain(*sheet(cells, hand_held).snapshot());
    return 0;
  }
  const double unit_ms = yardstick_ms();
  std::cout << "CPU time, and in units of 100,000 JacobiSVD<Matrix3d> (" << formatFixed(unit_ms, 1) << " ms)\n";
  for (const std::size_t cells : sizes) {
    if (solve) compare(cells, hand_held, count_of_cores, unit_ms);
    std::cout << std::flush;
    if (factor) compareFactors(*sheet(cells, hand_held).snapshot());
  }
}
