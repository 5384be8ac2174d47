// Time it takes to emulate 10,000 cells at 1 kHz, and to receive them: to read them, to put the readings into messages
// and to frame these; and frames cut out of a stream, checked, decoded, and averaged by a listener. "core" is the share
// of one core at that rate; above 1 samples are dropped.

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/sources/skin_stream.h"
#include "hexoderm/sim/emulated_device.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/support/options.h"
#include "tests/support/simulated_skins.h"

#include <benchmark/benchmark.h>

namespace hexoderm {
namespace {

/// A device that has explored its cells.
struct Device {
  explicit Device(const EmulatedDeviceOptions& options)
      : device(std::make_unique<SimulatedSkin>(test::simulatedSkin(test::skinOptions("sheet:100x100"))), options) {
    device.greet(messages);
    while (device.isExploring()) device.tick(messages);
  }

  EmulatedDevice device;
  EmulatedDevice::Messages messages;  ///< that were not sent yet
};

/// Appends what there is to send, and forgets it.
void send(EmulatedDevice::Messages& messages, skinwire::Bytes& wire) {
  for (const skinwire::Message& message : messages) {
    const skinwire::Bytes frame = skinwire::encodeFrame(skinwire::Framing::Length, message);
    wire.insert(wire.end(), frame.begin(), frame.end());
  }
  messages.clear();
}

/// Seconds of work per second of samples.
void countTicks(benchmark::State& state, double ticks_s, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  state.counters["core"] = benchmark::Counter(static_cast<double>(state.iterations()) * ticks_s,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// `means_of` samples a mean; 0: every sample.
void emulate(benchmark::State& state) {
  Device emulated(test::with(&EmulatedDeviceOptions::means_of, static_cast<std::uint32_t>(state.range(0))));
  emulated.messages.clear();
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    emulated.device.tick(emulated.messages);
    skinwire::Bytes wire;
    send(emulated.messages, wire);
    bytes += wire.size();
  }
  countTicks(state, emulated.device.tick_s(), bytes);
}
BENCHMARK(emulate)->Arg(0)->Arg(20)->Unit(benchmark::kMillisecond);

class Averager final : public SkinListener {
 public:
  void onSkin(const SkinDescription& skin) override { sums_g_.assign(skin.neighbors.size(), Eigen::Vector3d::Zero()); }
  void onFrame(const SampleFrame& frame) override {
    for (std::size_t k = 0; k < frame.samples.size(); ++k) sums_g_[k] += frame.samples[k].acceleration_g;
  }
  void onStatus(const SourceStatus& /*status*/) override {}
  void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}
  [[nodiscard]] double sum() const { return sums_g_.empty() ? 0 : sums_g_.front().sum(); }

 private:
  std::vector<Eigen::Vector3d> sums_g_;
};

/// So many ticks a message.
void receive(benchmark::State& state) {
  constexpr int kTicks = 100;
  Device emulated(test::with(&EmulatedDeviceOptions::message_every_s, 0.001 * static_cast<double>(state.range(0))));
  Averager averager;
  SkinStream stream(averager);
  skinwire::FrameDecoder decoder(skinwire::Framing::Length);
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    for (int k = 0; k < kTicks; ++k) emulated.device.tick(emulated.messages);
    skinwire::Bytes wire;
    send(emulated.messages, wire);
    bytes += wire.size();
    state.ResumeTiming();
    constexpr std::size_t kPiece = 65'536;  // a typical read from a socket
    for (std::size_t at = 0; at < wire.size(); at += kPiece) {
      decoder.feed(skinwire::ByteView(wire).subspan(at, std::min(kPiece, wire.size() - at)));
      while (auto decoded = decoder.next()) {
        benchmark::DoNotOptimize(stream.take(std::move(*decoded), {}));
      }
    }
    benchmark::DoNotOptimize(averager.sum());
  }
  if (averager.sum() == 0) state.SkipWithError("samples were not delivered");
  countTicks(state, kTicks * emulated.device.tick_s(), bytes);
}
BENCHMARK(receive)->Arg(1)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

void explore(benchmark::State& state) {
  const SimulatedSkin skin = test::simulatedSkin(test::skinOptions("sheet:100x100"));
  const std::vector<LinkEnd> at = firstFreePorts(skin.neighbors(), skin.model());
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(exploreNetwork(skin.neighbors(), skin.model(), at));
  }
}
BENCHMARK(explore)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexoderm
