#include "tests/support/hand_made_skins.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/patch_captions.h"
#include "widgets/patch/patch_view.h"
#include "widgets/style/palette.h"

#include <gtest/gtest.h>
#include <QtWidgets>

namespace hexoderm {
namespace {

TEST(PatchViewWithoutOpenGl, SaysSoAndStaysUsable) {
  ASSERT_EQ(QGuiApplication::platformName(), "minimal") << "run by CTest, which sets QT_QPA_PLATFORM";
  ASSERT_FALSE(QOpenGLContext().create());
  Selection selection;
  PatchView view(&selection);
  view.resize(500, 300);
  view.show();
  auto* overlay = view.findChild<PatchCaptions*>();
  ASSERT_NE(overlay, nullptr);
  EXPECT_TRUE(overlay->accessibleName().contains("OpenGL"));
  EXPECT_TRUE(overlay->accessibleName().contains("Preferences, \"Draw without the graphics card\""))
      << overlay->accessibleName().toStdString();

  view.setReconstruction(shared(demoReconstruction()));
  view.setPalette(qtPalette(Theme::Dark));
  PatchMoment moment;
  moment.pose = PoseId(1);
  moment.readings = readingsOf({{CellId(1), {0, 0, 1}}}, {});
  view.setMoment(moment);
  PatchOverlays overlays;
  overlays.truth = std::make_shared<const GroundTruth>();
  view.setOverlays(overlays);
  view.setOverlays({});
  EXPECT_TRUE(view.isUpToDate());
  view.fit();
  view.showStandardView(PatchView::StandardView::Front);
  selection.selectCell(CellId(2));
  EXPECT_TRUE(overlay->accessibleName().contains("OpenGL"));
  EXPECT_EQ(view.screenshot().size(), view.size());
  EXPECT_EQ(selection.cell(), CellId(2));
}

}  // namespace
}  // namespace hexoderm
