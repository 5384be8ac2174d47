// Speed of drawing the patch. The target is 30 frames/s at 10,000 cells and 15 at 100,000 with software OpenGL,
// multisampling off. Prints frames/s while the camera turns, and the time that a new result takes.
//
//   LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1440x900x24" build/release/tests/benchmarks/scene_benchmark
//
// README.md here holds the figures measured so far. The window has the size of the view in a window of 1440 x 900. The
// column CPU is the time of all threads together: on a busy computer it tells more than the frames/s do.

#include "tests/support/hand_made_skins.h"
#include "widgets/scene/edge_smoothing.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/style/color_maps.h"

#include <benchmark/benchmark.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <array>
#include <cmath>
#include <map>

namespace hexoderm {
namespace {

constexpr int kWidth = 720;
constexpr int kHeight = 600;

/// 17, 1,260, 10,000 or 100,000 cells.
std::shared_ptr<const Reconstruction> skinOf(std::int64_t cells) {
  static std::map<std::int64_t, std::shared_ptr<const Reconstruction>> made;
  auto& skin = made[cells];
  if (skin) return skin;
  const std::map<std::int64_t, std::pair<std::uint32_t, std::uint32_t>> sheets = {
      {1260, {42, 30}}, {10000, {125, 80}}, {100000, {400, 250}}};
  const auto sheet = sheets.find(cells);
  skin = std::make_shared<const Reconstruction>(
      sheet == sheets.end() ? demoReconstruction() : cylinderSheet(sheet->second.first, sheet->second.second));
  return skin;
}

struct Stage {
  Stage() {
    window->SetOffScreenRendering(1);
    window->SetSize(kWidth, kHeight);
    scene.setColors(sceneColors(Theme::Dark));
    scene.attachTo(window);
  }
  /// All benchmarks draw in one window: a display that nobody is connected to any more may end.
  static Stage& showing(const std::shared_ptr<const SceneContent>& content) {
    static Stage& stage = *new Stage;  // never destroyed: OpenGL may be gone by then
    stage.scene.setContent(content);
    stage.scene.setColoring(Coloring::LinkQuality);
    setSmoothed(*stage.window, false);  // as while the mouse turns the scene
    stage.scene.showStandardView(PatchScene::View::Oblique);
    stage.draw();
    return stage;
  }
  void draw() {
    window->Render();
    window->WaitForCompletion();
  }

  vtkNew<vtkRenderWindow> window;
  PatchScene scene;
};

void turn(benchmark::State& state, bool smoothed) {
  Stage& stage = Stage::showing(makeSceneContent(skinOf(state.range(0))));
  setSmoothed(*stage.window, smoothed);
  stage.draw();
  for ([[maybe_unused]] auto _ : state) {
    stage.scene.renderer()->GetActiveCamera()->Azimuth(3);
    stage.draw();
  }
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// While the mouse turns the scene.
void Turning(benchmark::State& state) { turn(state, false); }
/// At rest edges are smoothed.
void TurningSmoothed(benchmark::State& state) { turn(state, true); }

/// The same from so near that hundreds of cells have their IDs written on them, at every picture anew.
void TurningNear(benchmark::State& state) {
  Stage& stage = Stage::showing(makeSceneContent(skinOf(state.range(0))));
  vtkCamera* camera = stage.scene.renderer()->GetActiveCamera();
  // As large as a cell of 1,260 cells is when three times as near.
  camera->Zoom(3 * std::sqrt(static_cast<double>(state.range(0)) / 1260));
  stage.draw();
  double labels = 0;
  for ([[maybe_unused]] auto _ : state) {
    camera->Azimuth(1);
    stage.draw();
    labels += static_cast<double>(stage.scene.labelledCells().size());
  }
  camera->SetViewAngle(30);
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["IDs"] = labels / static_cast<double>(state.iterations());
}

/// A new result of the same skin, on the GUI's thread: what was prepared elsewhere is taken over and drawn.
void NewResultTakenOverAndDrawn(benchmark::State& state) {
  const std::array contents = {makeSceneContent(skinOf(state.range(0))), makeSceneContent(skinOf(state.range(0)))};
  Stage& stage = Stage::showing(contents[0]);
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    stage.scene.setContent(contents.at(++next % 2));
    stage.draw();
  }
}

/// The part of it that comes before drawing.
void NewResultTakenOver(benchmark::State& state) {
  const auto content = makeSceneContent(skinOf(state.range(0)));
  Stage& stage = Stage::showing(content);
  for ([[maybe_unused]] auto _ : state) stage.scene.setContent(content);
}

/// On the other thread for large skins, on the GUI's for small ones.
void NewResultPrepared(benchmark::State& state) {
  const auto skin = skinOf(state.range(0));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(makeSceneContent(skin));
}

void ReadingsRecolour(benchmark::State& state) {
  const auto skin = skinOf(state.range(0));
  Stage& stage = Stage::showing(makeSceneContent(skin));
  stage.scene.setColoring(Coloring::ReadingZ);
  stage.draw();
  CellReadings readings;
  double g = 0;
  for ([[maybe_unused]] auto _ : state) {
    g = g > 0.9 ? -0.9 : g + 0.1;
    for (const PatchReconstruction& patch : skin->patches) {
      for (const CellPlacement& cell : patch.cells) readings.acceleration_g[cell.cell] = {0, 0, g};
    }
    PatchMoment moment;
    moment.readings = std::make_shared<const CellReadings>(readings);
    stage.scene.setMoment(moment);
    stage.draw();
  }
}

/// The first pick of a result sorts its cells; the next ones are quicker.
void FirstPick(benchmark::State& state) {
  const auto content = makeSceneContent(skinOf(state.range(0)));
  Stage& stage = Stage::showing(content);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    stage.scene.setContent(content);
    state.ResumeTiming();
    benchmark::DoNotOptimize(stage.scene.pick(0.5 * kWidth, 0.5 * kHeight));
  }
}

void NextPick(benchmark::State& state) {
  Stage& stage = Stage::showing(makeSceneContent(skinOf(state.range(0))));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stage.scene.pick(0.5 * kWidth, 0.5 * kHeight));
}

void sizes(benchmark::internal::Benchmark* each) {
  each->ArgName("cells")
      ->Arg(17)
      ->Arg(1260)
      ->Arg(10000)
      ->Arg(100000)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

BENCHMARK(Turning)->Apply(sizes);
BENCHMARK(TurningSmoothed)->Apply(sizes);
BENCHMARK(TurningNear)->Apply(sizes);
BENCHMARK(NewResultPrepared)->Apply(sizes);
BENCHMARK(NewResultTakenOver)->Apply(sizes);
BENCHMARK(NewResultTakenOverAndDrawn)->Apply(sizes);
BENCHMARK(ReadingsRecolour)->Apply(sizes);
BENCHMARK(FirstPick)->Apply(sizes);
BENCHMARK(NextPick)->Apply(sizes);

}  // namespace
}  // namespace hexoderm

BENCHMARK_MAIN();
