#include "widgets/graph/graph_fit.h"

#include "tests/support/hand_made_skins.h"
#include "widgets/graph/graph_legend.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

constexpr QSize kView(500, 360);
constexpr QSize kButton(120, 24);

bool coversACell(const QRect& area, const GraphScene& scene, const GraphCamera& camera) {
  return std::ranges::any_of(scene.cells(), [&](const GraphScene::Cell& cell) {
    return area.contains(camera.toScreen(cell.center).toPoint());
  });
}

TEST(GraphFit, ShowsAllCellsAndCoversNoneWithTheButton) {
  for (const auto& skin : {sampleX17(), sampleTwoPatches()}) {
    const GraphScene scene(skin);
    const GraphFit fit(scene, kView, {kButton, nullptr, 0});
    for (const GraphScene::Cell& cell : scene.cells()) {
      EXPECT_TRUE(QRect(QPoint(0, 0), kView).contains(fit.camera().toScreen(cell.center).toPoint())) << cell.id.value();
    }
    EXPECT_FALSE(coversACell(QRect(fit.buttonPlace(), kButton), scene, fit.camera()));
  }
}

TEST(GraphFit, CoversNoCaptionOfAPatchWithTheButton) {
  const GraphScene scene(sampleTwoPatches());
  constexpr double kCaption_px = 16;
  for (int width = 300; width <= 900; width += 50) {
    for (int height = 200; height <= 600; height += 50) {
      const GraphFit fit(scene, QSize(width, height), {kButton, nullptr, kCaption_px});
      for (const GraphScene::Patch& patch : scene.patches()) {
        const QRectF box = fit.camera().toScreen(patch.bounds);
        const QRectF caption(box.left(), box.top() - kCaption_px, box.width(), kCaption_px);
        EXPECT_FALSE(caption.intersects(QRectF(fit.buttonPlace(), kButton))) << width << " x " << height;
      }
    }
  }
}

TEST(GraphFit, TheButtonTakesNoHeightFromASkinThatLeavesAPlaceAtTheTop) {
  // The arms of the cross leave one between them.
  const GraphScene scene(sampleX17());
  const GraphFit alone(scene, kView, {});
  const GraphFit beside(scene, kView, {kButton, nullptr, 0});
  EXPECT_EQ(beside.camera().scale, alone.camera().scale);
  EXPECT_EQ(beside.camera().center, alone.camera().center);
}

TEST(GraphFit, WhereTheButtonFitsNowhereTheSkinGoesBelowIt) {
  const GraphScene scene(sampleX17());
  constexpr QSize kSmallView(220, 150);
  const QSize as_wide_as_the_view(kSmallView.width() - 16, 24);
  const GraphFit beside(scene, kSmallView, {});
  const GraphFit below(scene, kSmallView, {as_wide_as_the_view, nullptr, 0});
  EXPECT_TRUE(coversACell(QRect(QPoint(8, 8), as_wide_as_the_view), scene, beside.camera()));
  EXPECT_FALSE(coversACell(QRect(below.buttonPlace(), as_wide_as_the_view), scene, below.camera()));
  EXPECT_LT(below.camera().scale, beside.camera().scale);
}

TEST(GraphFit, TheLegendHasRoomOnlyInAHighView) {
  const GraphScene scene(sampleX17());
  const GraphPaint paint = paintOf(scene, Coloring::LinkQuality, Theme::Light);
  const GraphLegend legend(paint, {}, Theme::Light, QFont());
  const GraphFit high(scene, QSize(900, 600), {std::nullopt, &legend, 0});
  ASSERT_FALSE(high.legendArea().isEmpty());
  for (const GraphScene::Cell& cell : scene.cells()) {
    EXPECT_LT(high.camera().toScreen(cell.center).y(), high.legendArea().top());
  }
  EXPECT_TRUE(GraphFit(scene, QSize(900, 180), {std::nullopt, &legend, 0}).legendArea().isEmpty());
}

TEST(GraphCamera, ZoomsAboutAPointAndPansNoFurtherThanNeeded) {
  GraphCamera camera{{0.1, 0.2}, 1000, QSizeF(kView)};
  const QPointF fixed = camera.toSheet({100, 50});
  camera.zoomTo(2500, {100, 50});
  EXPECT_NEAR(camera.toScreen(fixed).x(), 100, 1e-9);
  EXPECT_NEAR(camera.toScreen(fixed).y(), 50, 1e-9);
  const QPointF center = camera.center;
  camera.bringIntoView(camera.toSheet({3, 3}), 40);
  EXPECT_EQ(camera.center, center) << "it is in view, although near the edge";
  const QPointF outside = camera.toSheet({-200, 100});
  camera.bringIntoView(outside, 40);
  EXPECT_NEAR(camera.toScreen(outside).x(), 40, 1e-9);
  EXPECT_NEAR(camera.toScreen(outside).y(), 100, 1e-9);
}

}  // namespace
}  // namespace hexoderm
