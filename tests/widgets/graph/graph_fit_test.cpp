#include "widgets/graph/graph_fit.h"

#include "tests/support/hand_made_skins.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

constexpr QSize kButton(120, 24);

TEST(GraphFit, CoversNoCaptionOfAPatchWithTheButton) {
  const GraphScene scene(sampleTwoPatches());
  constexpr double kCaption_px = 16;
  for (int width = 300; width <= 900; width += 50) {
    for (int height = 200; height <= 600; height += 50) {
      const GraphFit fit(scene, QSize(width, height), {kButton, nullptr, kCaption_px});
      for (const GraphScene::Patch& patch : scene.patches()) {
        const QRectF box = fit.camera.toScreen(patch.bounds);
        const QRectF caption(box.left(), box.top() - kCaption_px, box.width(), kCaption_px);
        EXPECT_FALSE(caption.intersects(QRectF(fit.button_place, kButton))) << width << " x " << height;
      }
    }
  }
}

}  // namespace
}  // namespace hexoderm
