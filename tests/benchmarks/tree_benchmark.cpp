// CPU time that the tree takes in memory, stage by stage, for 1,260, 10,000 and 99,856 simulated cells in three poses;
// beside it, as a measure of the computer, 100,000 of Eigen's JacobiSVD<Matrix3d>, and what the Boost Graph Library
// takes to find the origin from all pairs. Each figure is the least of several runs.
//
//   build/core/tests/benchmarks/tree_benchmark [MOST_CELLS]

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/geometry/lanes.h"
#include "hexoderm/graph/origin_search.h"
#include "hexoderm/reconstruction/faults/cell_health.h"
#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/reconstruction/links/edge_batches.h"
#include "hexoderm/reconstruction/links/skin_links.h"
#include "hexoderm/reconstruction/patch/attitude_faults.h"
#include "hexoderm/reconstruction/patch/patch_description.h"
#include "hexoderm/reconstruction/patch/patch_solver.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"

#include <Eigen/SVD>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <string>

namespace hexoderm {
namespace {

double cpuTime_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The least of at least three runs, and of as many as 400 ms allow up to 40. `prepare` is not timed.
double least_ms(
    const std::function<void()>& work, const std::function<void()>& prepare = [] {}) {
  constexpr double kLongEnough_ms = 400;
  double least = std::numeric_limits<double>::infinity();
  double all = 0;
  for (int run = 0; run < 3 || (run < 40 && all < kLongEnough_ms); ++run) {
    prepare();
    const double before = cpuTime_ms();
    work();
    const double took = cpuTime_ms() - before;
    least = std::min(least, took);
    all += took;
  }
  return least;
}

/// What all other figures are compared with.
double jacobiSvd_ms() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Matrix3d> matrices(100'000);
  for (Eigen::Matrix3d& matrix : matrices) matrix = Eigen::Matrix3d::NullaryExpr([&] { return normal(random); });
  double sum = 0;
  const double took = least_ms([&] {
    for (const Eigen::Matrix3d& matrix : matrices) {
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
      sum += svd.matrixU()(0, 0) + svd.matrixV()(0, 0);
    }
  });
  if (sum == 0) std::puts("");  // so that nothing is left out as unused
  return took;
}

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
  if (sum == 0) std::puts("");
  return took * static_cast<double>(cells) / static_cast<double>(sources);
}

class Table {
 public:
  Table(std::size_t cells, double svd_ms) : svd_ms_(svd_ms) {
    std::printf("\n%zu cells                              ms    100,000 SVDs = 1\n", cells);
  }
  void row(const std::string& what, double ms) const {
    std::printf("%-36s %9.3f %9.4f\n", what.c_str(), ms, ms / svd_ms_);
  }

 private:
  double svd_ms_;
};

void measure(int rows, int columns, double svd_ms) {
  SimulatedSkinOptions skin_options;
  skin_options.patch = "sheet:" + std::to_string(rows) + "x" + std::to_string(columns);
  const double cells = rows * columns;
  skin_options.surface = "cylinder:r=" + std::to_string(0.25 * std::sqrt(cells / 1260));
  skin_options.seed = 3;
  SimulatedSkin simulated(builtInCellModel("hex-bma150"), skin_options);
  const auto snapshot = simulateSession(simulated, 3).snapshot();
  SolverOptions options;
  options.solver = Solver::Tree;
  const Table table(static_cast<std::size_t>(cells), svd_ms);

  table.row("whole, reconstruct()", least_ms([&] { static_cast<void>(reconstruct(*snapshot, options)); }));

  table.row("graph from reports", least_ms([&] { SkinGraph(*snapshot->model, *snapshot->neighbors); }));
  std::vector<Finding> findings;
  SkinLinks skin(*snapshot, options, findings);
  table.row("readings", least_ms([&] { GravityTable(*snapshot, skin.graph(), findings); }));
  table.row("cells judged", least_ms([&] { judgeCells(*snapshot, skin.graph(), skin.table(), findings); }));
  table.row("edges", least_ms([&] { skin.estimateEdges(); }));
  {
    std::vector<std::size_t> all(skin.graph().links().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<EdgeRotation> edges(all.size());
    std::vector<std::optional<double>> residuals(all.size() * skin.table().poseCount());
    table.row("  of these one by one, no vectors", least_ms([&] {
                EdgeBatches(skin.model(), skin.graph(), skin.table(), skin.readings(), options, estimateEdgesByOne)
                    .estimate(all, edges, residuals);
              }));
    if (hasFourLanes()) {
      table.row("  of these four at a time", least_ms([&] {
                  EdgeBatches(skin.model(), skin.graph(), skin.table(), skin.readings(), options, estimateEdgesByFour)
                      .estimate(all, edges, residuals);
                }));
    }
  }
  table.row("pair tests", least_ms([&] {
              SuspectSearch(skin.model(), skin.graph(), skin.table(), skin.readings(), skin.edges(), options);
            }));
  const std::vector<double> weights = linkWeights(skin);
  OriginFound found;
  const double origin_ms = least_ms([&] { found = searchOrigin(skin.graph(), weights, 0); });
  table.row("origin, " + std::to_string(found.runs) + " runs", origin_ms);
  ShortestPaths paths;
  table.row("paths", least_ms([&] { paths = findShortestPaths(skin.graph(), weights, found.origin); }));
  std::vector<Eigen::Matrix3d> attitudes;
  table.row("attitudes",
            least_ms([&] { attitudes = skin.attitudeCovariances(skin.graph().patches().front(), paths.link); }));
  table.row("placements", least_ms([&] {
              static_cast<void>(placeAlongTree(skin.graph(), skin.model(), paths, skin.edges(), attitudes));
            }));
  std::vector<PatchSolver> patches;
  patches.emplace_back(skin, weights, 0);
  std::vector<PatchReconstruction> described;
  table.row("description", least_ms([&] { described = describePatches(skin, patches, weights); }));
  table.row("flat layout", least_ms([&] { static_cast<void>(computeFlatLayout(skin.model(), described)); }));
  options.weights = LinkWeights::Residual;
  const std::vector<double> real = linkWeights(skin);
  table.row("origin by residuals", least_ms([&] { found = searchOrigin(skin.graph(), real, 0); }));
  const auto compareWithBoost = [&] {
    const double boost_ms = boostAllPairs_ms(skin.graph(), weights);
    table.row("Boost, all pairs", boost_ms);
    std::printf("%-36s %9.0f\n", "  times the origin's", boost_ms / origin_ms);
  };
  if (cells < 20'000) compareWithBoost();
  // Last, for it takes out of the skin what it finds.
  table.row("attitudes searched for faults", least_ms([&] {
              std::vector<Finding> found_faults;
              static_cast<void>(AttitudeIsolation(skin).isolate(patches, found_faults));
            }));
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 1e6;
  const double svd_ms = hexoderm::jacobiSvd_ms();
  std::printf("100,000 JacobiSVD<Matrix3d>: %.1f ms of CPU time; %d numbers at a time\n", svd_ms,
              hexoderm::hasFourLanes() ? 4 : 1);
  if (most >= 1260) hexoderm::measure(35, 36, svd_ms);
  if (most >= 10'000) hexoderm::measure(100, 100, svd_ms);
  if (most >= 99'856) hexoderm::measure(316, 316, svd_ms);
  return 0;
}
