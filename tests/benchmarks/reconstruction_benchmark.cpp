// Time that a reconstruction takes: the tree, the joint estimate from scratch, and from the result before the last pose
// came in, as in the window; and how it grows with poses and patches. The skins are simulated.

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/support/unlinked_cells.h"

#include <benchmark/benchmark.h>

namespace hexoderm {
namespace {

enum class Start { Tree, Cold, Warm };

SimulatedSkin sheet(std::int64_t rows) {
  SimulatedSkinOptions options;
  options.patch = "sheet:" + std::to_string(rows) + "x" + std::to_string(rows + 1);
  options.surface = "cylinder:r=0.25";
  return {builtInCellModel("hex-bma150"), options};
}

void reconstructSheet(benchmark::State& state, Start start) {
  SimulatedSkin skin = sheet(state.range(0));
  const Session session = simulateSession(skin, static_cast<std::size_t>(state.range(1)));
  const auto snapshot = session.snapshot();
  Session without_last = session;
  without_last.removePose(session.poses().size() - 1);
  const auto before = reconstruct(*without_last.snapshot());
  SolverOptions options;
  options.solver = start == Start::Tree ? Solver::Tree : Solver::Global;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(reconstruct(*snapshot, options, start == Start::Warm ? before.get() : nullptr));
  }
  state.counters["cells"] = static_cast<double>(skin.truth().size());
  state.counters["poses"] = static_cast<double>(state.range(1));
}

// 1,260 cells; 3 and 6 poses.
BENCHMARK_CAPTURE(reconstructSheet, tree, Start::Tree)->Args({35, 3})->Args({35, 6})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reconstructSheet, cold, Start::Cold)->Args({35, 3})->Args({35, 6})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reconstructSheet, warm, Start::Warm)->Args({35, 3})->Args({35, 6})->Unit(benchmark::kMillisecond);

void manyPoses(benchmark::State& state, const char* patch) {
  SimulatedSkinOptions options;
  options.patch = patch;
  SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  const auto snapshot = simulateSession(skin, static_cast<std::size_t>(state.range(0)), 2).snapshot();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(reconstruct(*snapshot));
}
BENCHMARK_CAPTURE(manyPoses, x17, "x17")->RangeMultiplier(2)->Range(375, 3000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(manyPoses, sheet100, "sheet:10x10")
    ->RangeMultiplier(2)
    ->Range(125, 1000)
    ->Unit(benchmark::kMillisecond);

void manyPatches(benchmark::State& state) {
  const auto snapshot = unlinkedCells(static_cast<std::uint32_t>(state.range(0)), 3).snapshot();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(reconstruct(*snapshot));
}
BENCHMARK(manyPatches)->RangeMultiplier(2)->Range(2500, 20'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexoderm
