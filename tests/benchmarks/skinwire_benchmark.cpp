// Time it takes to receive 10,000 cells at 1 kHz: frames cut out of a stream, checked, decoded, and averaged by a
// listener. "core" is the share of one core at that rate.

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/device/skinwire/sample_messages.h"
#include "hexoderm/device/sources/skin_stream.h"

#include <benchmark/benchmark.h>
#include <random>

namespace hexoderm {
namespace {

constexpr std::uint32_t kCells = 10'000;
constexpr double kRate_hz = 1000;

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

/// `ticks` a message.
void receive(benchmark::State& state) {
  const auto ticks = static_cast<std::size_t>(state.range(0));
  SkinDescription skin{hexoderm::Message::verbatim("benchmark"),
                       std::make_shared<const CellModel>(builtInCellModel("hex-bma150")),
                       {},
                       false,
                       false};
  for (std::uint32_t id = 1; id <= kCells; ++id) skin.neighbors.push_back({CellId(id), "", {}});

  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> noise(-20, 20);
  skinwire::Samples samples;
  samples.period_us = 1000;
  for (std::uint32_t id = 1; id <= kCells; ++id) samples.cells.push_back(id);
  for (std::size_t k = 0; k < 3 * kCells * ticks; ++k)
    samples.raw_lsb.push_back((k % 3 == 2 ? 256 : 0) + noise(random));

  // Times go on from pass to pass: the frames of every pass are made before.
  constexpr std::size_t kFrames = 20;
  Averager averager;
  SkinStream stream(averager);
  stream.take(skinwire::decodeBody(skinwire::encodeBody(skinwire::helloOf(skin))), {});
  for (const skinwire::Topology& part : skinwire::topologyParts(skin.neighbors, 1)) {
    stream.take(skinwire::decodeBody(skinwire::encodeBody(part)), {});
  }
  std::size_t bytes = 0;
  std::size_t broken = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    skinwire::Bytes wire;
    for (std::size_t k = 0; k < kFrames; ++k) {
      samples.time_us += 1000 * ticks;
      const skinwire::Bytes frame = skinwire::encodeFrame(skinwire::Framing::Length, samples);
      wire.insert(wire.end(), frame.begin(), frame.end());
    }
    bytes += wire.size();
    state.ResumeTiming();

    skinwire::FrameDecoder decoder(skinwire::Framing::Length);
    constexpr std::size_t kPiece = 65'536;  // a typical read from a socket
    for (std::size_t at = 0; at < wire.size(); at += kPiece) {
      decoder.feed(skinwire::ByteView(wire).subspan(at, std::min(kPiece, wire.size() - at)));
      while (auto decoded = decoder.next()) {
        if (stream.take(std::move(*decoded), {}) != SkinStream::Effect::Alive) ++broken;
      }
    }
    benchmark::DoNotOptimize(averager.sum());
  }
  if (broken > 0) state.SkipWithError("samples were not delivered");
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  // Seconds of work per second of samples.
  state.counters["core"] = benchmark::Counter(static_cast<double>(state.iterations() * kFrames * ticks) / kRate_hz,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(receive)->Arg(1)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexoderm
