// Time that the views of live readings and of residuals, and the graph, take. The live views are given new data twenty
// times a second, so a picture must take less than 50 ms. Needs a display: xvfb-run -a
// build/release/tests/benchmarks/views_benchmark

#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/qt_wait.h"
#include "tests/support/simulated_skins.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view.h"
#include "widgets/verify/residual_view.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <QPainter>
#include <QTableView>
#include <cmath>

namespace hexoderm {
namespace {

/// Shows a view of this size; nothing is painted before it is on the screen.
void show(benchmark::State& state, QWidget& view, const QSize& size) {
  view.resize(size);
  view.show();
  if (!test::waitUntilExposed(view)) state.SkipWithError("the view is not shown");
}

/// One picture of the stillness of 17 cells, with ten seconds of readings before it.
void stillness(benchmark::State& state) {
  StillnessView view;
  show(state, view, {700, 160});
  HoldStatus hold;
  hold.stillness.excess_cell = CellId(7);
  hold.stillness.excess_limit_g = 0.030;
  int step = 0;
  const auto add = [&] {
    SkinPreview preview;
    preview.time_s = 0.05 * step;
    for (std::uint32_t k = 0; k < 17; ++k) {
      const double wave = 0.05 * std::sin(0.9 * step + k);
      preview.means.push_back({CellId(k + 1), {wave, 0.7 * wave, 1 + 0.5 * wave}});
    }
    view.add(hold, preview);
    ++step;
  };
  while (step < 210) add();
  for ([[maybe_unused]] auto _ : state) {
    add();
    view.repaint();
  }
}
BENCHMARK(stillness)->Unit(benchmark::kMillisecond);

/// One picture of three poses and a present direction that moves.
void coverage(benchmark::State& state) {
  auto result = sampleX17();
  result->patches[0].gravity = {{PoseId(1), Eigen::Vector3d::UnitZ(), 0.01},
                                {PoseId(2), Eigen::Vector3d::UnitX(), 0.01},
                                {PoseId(4), Eigen::Vector3d::UnitY(), 0.01}};
  CoverageView view;
  show(state, view, {320, 360});
  view.setCoverage(coverageOf(*result));
  int step = 0;
  for ([[maybe_unused]] auto _ : state) {
    view.setCurrent(Eigen::Vector3d(std::cos(0.05 * step), std::sin(0.05 * step), 0.4).normalized());
    view.repaint();
    ++step;
  }
}
BENCHMARK(coverage)->Unit(benchmark::kMillisecond);

/// A new result in the matrix of residuals, painted, sorted and painted again.
void residuals(benchmark::State& state) {
  const auto rows = static_cast<std::uint32_t>(state.range(0));
  const auto columns = static_cast<std::uint32_t>(state.range(1));
  const auto one = sheetWithPoses(rows, columns, static_cast<std::uint32_t>(state.range(2)));
  const auto other = std::make_shared<const Reconstruction>(*one);
  Selection selection;
  ResidualView view(&selection);
  show(state, view, {700, 220});
  bool first = false;
  for ([[maybe_unused]] auto _ : state) {
    first = !first;
    view.setReconstruction(first ? one : other);
    view.matrix()->viewport()->repaint();
    view.matrix()->sortByColumn(0, Qt::DescendingOrder);
    view.matrix()->viewport()->repaint();
  }
}
BENCHMARK(residuals)
    ->ArgNames({"rows", "columns", "poses"})
    ->Args({36, 35, 6})
    ->Args({10, 10, 1000})
    ->Unit(benchmark::kMillisecond);

// --- the graph with 10,000 cells: a whole picture at several sizes and zooms, a new result, a mouse that moves over it

/// A simulated sheet of 100 x 100 cells in three poses, solved along the tree.
const std::shared_ptr<const Reconstruction>& sheet() {
  static const auto result =
      reconstruct(*test::simulatedSession(test::skinOptions("sheet:100x100", "plane"), 3).snapshot(),
                  test::with(&SolverOptions::solver, Solver::Tree));
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
