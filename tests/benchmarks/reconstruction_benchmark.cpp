// How the time that a reconstruction takes grows with poses and patches. The skins are simulated. What the tree and the
// joint estimate take of a sheet is solver_ratios' to say.

#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/unlinked_cells.h"

#include <benchmark/benchmark.h>

namespace hexoderm {
namespace {

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
