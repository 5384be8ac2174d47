// Time it takes to keep the raw samples of 10,000 cells at 1 kHz: a pose with all its samples, from the frames to the
// disk of the temporary folder (TMPDIR). "head_room" is seconds of samples stored per second of the clock; below 1 the
// store would fall behind a device whose every sample is kept.

#include "hexoderm/device/pose_capture.h"
#include "hexoderm/session/session_store.h"
#include "tests/support/temporary_folder.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <random>

namespace hexoderm {
namespace {

constexpr std::uint32_t kCells = 10'000;
constexpr double kRate_hz = 1000;

enum Readings { kLsb, kFloats, kDoubles };

/// Readings in the form in which a device sends them: whole LSB of 4 mg, or numbers of its own.
std::vector<SampleFrame> record(std::size_t frame_count, Readings readings) {
  const double lsb_g = readings == kLsb ? 0.004 : 0.001 + 1e-9;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> noise(-20, 20);
  std::vector<SampleFrame> frames(frame_count);
  for (std::size_t k = 0; k < frame_count; ++k) {
    frames[k].time_s = static_cast<double>(k) / kRate_hz;
    for (std::uint32_t id = 1; id <= kCells; ++id) {
      const Eigen::Vector3d lsb(noise(random), noise(random), 256 + noise(random));
      Eigen::Vector3d reading_g = lsb_g * lsb;
      if (readings == kFloats) {
        for (double& value_g : reading_g) value_g = static_cast<double>(static_cast<float>(value_g));
      }
      frames[k].samples.push_back({CellId(id), reading_g});
    }
  }
  return frames;
}

void storeRawSamples(benchmark::State& state) {
  constexpr std::size_t kFrames = 100;  // frames of a pose
  const test::TemporaryFolder folder;
  NeighborList cells;
  for (std::uint32_t id = 1; id <= kCells; ++id) cells.push_back({CellId(id), "", {}});
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.lsb_g = 0.004;
  const Session session(model, cells);
  const auto frames =
      std::make_shared<const std::vector<SampleFrame>>(record(kFrames, static_cast<Readings>(state.range(0))));
  const auto pose = std::make_shared<const PoseCapture>(averageFrames(*frames, PoseId(1), {}));
  const std::filesystem::path path = folder.path() / "arm.hexo";
  std::optional<SessionStore> store = SessionStore::create(path, session);
  constexpr std::size_t kPosesPerFile = 20;
  std::size_t poses = 0;
  double stored_s = 0;
  const auto now = [] { return std::chrono::steady_clock::now(); };
  std::chrono::duration<double> took_s{};
  for ([[maybe_unused]] auto _ : state) {
    const auto began = now();
    AddPose add{{pose}};
    add.raw = frames;
    const std::vector<StoreOperation> operations = {add};
    store->append(operations);
    store->tidy();
    took_s += now() - began;
    stored_s += kFrames / kRate_hz;
    if (++poses % kPosesPerFile != 0) continue;
    state.PauseTiming();
    state.counters["bytes_per_sample"] =
        static_cast<double>(std::filesystem::file_size(path)) / static_cast<double>(kPosesPerFile * kFrames * kCells);
    store.reset();
    std::filesystem::remove(path);
    store = SessionStore::create(path, session);
    state.ResumeTiming();
  }
  state.counters["head_room"] = stored_s / took_s.count();
}

BENCHMARK(storeRawSamples)
    ->Arg(kLsb)
    ->Arg(kFloats)
    ->Arg(kDoubles)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(5);

}  // namespace
}  // namespace hexoderm
