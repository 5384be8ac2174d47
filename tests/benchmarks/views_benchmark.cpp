// Time that the views of live readings and of residuals take. The live views are given new data twenty times a second,
// so a picture must take less than 50 ms. Needs a display: xvfb-run -a build/release/tests/benchmarks/views_benchmark

#include "hexoderm/solve/metrics/pose_coverage.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/qt_wait.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/selection.h"
#include "widgets/verify/residual_view.h"

#include <benchmark/benchmark.h>

#include <QApplication>
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

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
