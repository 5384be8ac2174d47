// Time that the graph takes with 10,000 cells: a whole picture at several sizes and zooms, a new result, and a mouse
// that moves over it. Needs a display: xvfb-run -a build/release/tests/benchmarks/graph_benchmark

#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/reconstructor.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <QPainter>

namespace hexoderm {
namespace {

/// A simulated sheet of 100 x 100 cells in three poses, solved along the tree.
const std::shared_ptr<const Reconstruction>& sheet() {
  static const std::shared_ptr<const Reconstruction> result = [] {
    SimulatedSkinOptions options;
    options.patch = "sheet:100x100";
    options.surface = "plane";
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    SolverOptions solver;
    solver.solver = Solver::Tree;
    return reconstruct(*simulateSession(skin, 3).snapshot(), solver);
  }();
  return result;
}

/// A picture of the fitted sheet, enlarged by `zoom`, into an image of width x height pixels.
void paint(benchmark::State& state, Coloring coloring) {
  const QSizeF size(static_cast<double>(state.range(0)), static_cast<double>(state.range(1)));
  const auto scene = std::make_shared<const GraphScene>(sheet());
  const auto colors = std::make_shared<const GraphPaint>(paintOf(*scene, coloring, Theme::Light));
  GraphCamera camera;
  camera.size = size;
  camera.center = scene->bounds().center();
  camera.scale = static_cast<double>(state.range(2)) *
                 std::min(size.width() / scene->bounds().width(), size.height() / scene->bounds().height());
  GraphStyle style;
  style.font = QApplication::font();
  const GraphPicture picture(scene, colors, camera, style, {true, false}, QRectF());
  QImage image(size.toSize(), QImage::Format_RGB32);
  for ([[maybe_unused]] auto _ : state) {
    QPainter painter(&image);
    picture.draw(painter);
  }
  state.counters["radius_px"] = scene->radius_m() * camera.scale;
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"width", "height", "zoom"});
  for (const int zoom : {1, 2, 4, 8, 16}) benchmark->Args({436, 400, zoom});
  for (const int zoom : {1, 2, 4, 8, 16}) benchmark->Args({1000, 650, zoom});
  benchmark->Args({1880, 1000, 1})->Args({1880, 1000, 2})->Args({1880, 1000, 4});
}
BENCHMARK_CAPTURE(paint, quality, Coloring::LinkQuality)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(paint, deviation, Coloring::Deviation)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(paint, patch, Coloring::Patch)->Args({1000, 650, 1})->Unit(benchmark::kMillisecond);

/// A view on the screen that shows the sheet.
struct ShownView {
  ShownView() : view(&selection) {
    view.resize(1000, 650);
    view.setReconstruction(sheet());
    view.show();
    QApplication::processEvents();
  }
  Selection selection;
  GraphView view;
};

void newResult(benchmark::State& state, Coloring coloring) {
  ShownView shown;
  shown.view.setColoring(coloring);
  for ([[maybe_unused]] auto _ : state) shown.view.setReconstruction(sheet());
}
BENCHMARK_CAPTURE(newResult, quality, Coloring::LinkQuality)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(newResult, position, Coloring::PositionUncertainty)->Unit(benchmark::kMillisecond);

/// Cost of one move of the mouse, with the painting that it leads to.
void hover(benchmark::State& state) {
  ShownView shown;
  for (int zoom = 0; zoom < state.range(0); ++zoom) {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Plus, Qt::NoModifier);
    QApplication::sendEvent(&shown.view, &key);
  }
  QApplication::processEvents();
  int step = 0;
  for ([[maybe_unused]] auto _ : state) {
    const QPointF at(200 + (7 * step) % 600, 200 + (3 * step) % 300);
    ++step;
    QMouseEvent event(QEvent::MouseMove, at, shown.view.mapToGlobal(at.toPoint()), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&shown.view, &event);
    QApplication::processEvents();
  }
}
BENCHMARK(hover)->ArgName("zoomed_in")->Arg(0)->Arg(6)->Arg(12)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
