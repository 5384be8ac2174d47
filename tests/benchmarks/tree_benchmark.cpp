// CPU time that the tree takes in memory, stage by stage, for 1,260, 10,000 and 99,856 simulated cells in three poses;
// beside it, as a measure of the computer, 100,000 of Eigen's JacobiSVD<Matrix3d>. Each figure is the least of several
// runs.
//
//   build/core/tests/benchmarks/tree_benchmark [MOST_CELLS]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include "hexoderm/base/parallel.h"
#include "hexoderm/base/vector_instructions.h"
#include "hexoderm/skin/origin_search.h"
#include "hexoderm/solve/estimate/patch_description.h"
#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/cell_health.h"
#include "hexoderm/solve/faults/suspects.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/tree/edge_batches.h"
#include "hexoderm/solve/tree/skin_links.h"
#include "tests/benchmarks/cpu_time.h"
#include "tests/support/options.h"
#include "tests/support/simulated_skins.h"

namespace hexoderm {
namespace {

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

void measure(std::size_t rows, std::size_t columns, double svd_ms) {
  const auto snapshot = test::simulatedSession(test::bentSheet(rows, columns, 3), 3).snapshot();
  SolverOptions options = test::with(&SolverOptions::solver, Solver::Tree);
  const Table table(rows * columns, svd_ms);
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
    table.row("  of these two at a time", least_ms([&] {
                EdgeBatches(skin.model(), skin.graph(), skin.table(), skin.readings(), options, estimateEdgesByTwo)
                    .estimate(all, edges, residuals);
              }));
    if (hasVectorInstructions()) {
      table.row("  of these four at a time", least_ms([&] {
                  EdgeBatches(skin.model(), skin.graph(), skin.table(), skin.readings(), options, estimateEdgesByFour)
                      .estimate(all, edges, residuals);
                }));
    }
  }
  table.row("pair tests", least_ms([&] { SuspectSearch(skin); }));
  const std::vector<double> weights = linkWeights(skin);
  OriginFound found;
  const double origin_ms = least_ms([&] { found = searchOrigin(skin.graph(), weights, 0); });
  table.row("origin, " + std::to_string(found.runs) + " runs", origin_ms);
  ShortestPaths paths;
  table.row("paths", least_ms([&] { paths = findShortestPaths(skin.graph(), weights, found.origin); }));
  std::vector<Eigen::Matrix3d> attitudes;
  table.row("attitudes", least_ms([&] {
              attitudes.clear();
              for (const std::size_t cell : skin.graph().patches().front()) {
                attitudes.push_back(skin.attitudeCovariance(cell, paths.link[skin.graph().cells()[cell].place]));
              }
            }));
  table.row("placements", least_ms([&] {
              static_cast<void>(placeAlongTree(skin.graph(), skin.model(), paths, skin.edges(), attitudes,
                                               gapShareOf(options.gap_model)));
            }));
  std::vector<PatchSolver> patches;
  patches.emplace_back(skin, weights, 0);
  std::vector<PatchReconstruction> described;
  table.row("description", least_ms([&] { described = describePatches(skin, patches, weights); }));
  table.row("flat layout", least_ms([&] { static_cast<void>(computeFlatLayout(skin.model(), described)); }));
  options.weights = LinkWeights::Residual;
  const std::vector<double> real = linkWeights(skin);
  table.row("origin by residuals", least_ms([&] { found = searchOrigin(skin.graph(), real, 0); }));
  options.weights = SolverOptions().weights;
  Estimate estimate(*snapshot, options);
  static_cast<void>(estimate.bringTo(Estimate::Stage::Patches, {}));
  table.row("attitudes searched for faults",
            least_ms([&] { static_cast<void>(makeAttitudeExplainer().explain(estimate)); }));
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 1e6;
  hexoderm::setCores(1);
  const double svd_ms = hexoderm::yardstick_ms();
  std::printf("100,000 JacobiSVD<Matrix3d>: %.1f ms of CPU time; %d numbers at a time\n", svd_ms,
              hexoderm::hasVectorInstructions() ? 4 : 2);
  if (most >= 1260) hexoderm::measure(35, 36, svd_ms);
  if (most >= 10'000) hexoderm::measure(100, 100, svd_ms);
  if (most >= 99'856) hexoderm::measure(316, 316, svd_ms);
  return 0;
}
