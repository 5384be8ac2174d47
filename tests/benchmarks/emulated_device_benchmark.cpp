// Time it takes to emulate 10,000 cells at 1 kHz: to read them, to put the readings into messages and to frame these.
// "core" is the share of one core at that rate; above 1 samples are dropped.

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/sim/emulated_device.h"
#include "hexoderm/sim/simulated_skin.h"

#include <benchmark/benchmark.h>

namespace hexoderm {
namespace {

/// `means_of` samples a mean; 0: every sample.
void emulate(benchmark::State& state) {
  SimulatedSkinOptions skin;
  skin.patch = "sheet:100x100";
  EmulatedDeviceOptions options;
  options.means_of = static_cast<std::uint32_t>(state.range(0));
  EmulatedDevice device(std::make_unique<SimulatedSkin>(builtInCellModel("hex-bma150"), skin), options);
  EmulatedDevice::Messages messages;
  device.greet(messages);
  while (device.isExploring()) device.tick(messages);
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    messages.clear();
    device.tick(messages);
    for (const skinwire::Message& message : messages) {
      bytes += skinwire::encodeFrame(skinwire::Framing::Length, message).size();
    }
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  // Seconds of work per second of samples.
  state.counters["core"] = benchmark::Counter(static_cast<double>(state.iterations()) * device.tick_s(),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(emulate)->Arg(0)->Arg(20)->Unit(benchmark::kMillisecond);

void explore(benchmark::State& state) {
  SimulatedSkinOptions skin_options;
  skin_options.patch = "sheet:100x100";
  const SimulatedSkin skin(builtInCellModel("hex-bma150"), skin_options);
  const std::vector<LinkEnd> at = firstFreePorts(skin.neighbors(), skin.model());
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(exploreNetwork(skin.neighbors(), skin.model(), at));
  }
}
BENCHMARK(explore)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexoderm
