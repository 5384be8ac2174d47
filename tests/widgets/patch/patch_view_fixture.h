#pragma once

#include "tests/support/hand_made_skins.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/patch_controls.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"

namespace hexoderm {

/// A 3D view in a window of its own, which is shown.
class PatchViewFixture : public testing::Test {
 protected:
  explicit PatchViewFixture(const QSize& size = {640, 480}) { view.resize(size); }
  void SetUp() override {
    view.show();
    ASSERT_TRUE(test::waitUntilExposed(view));
    canvas = test::part<SceneWidget>(view);
  }

  PatchControls& controls() { return *view.findChild<PatchControls*>(); }
  void click(const QPoint& at) { QTest::mouseClick(canvas, Qt::LeftButton, {}, at); }
  void read(std::shared_ptr<const CellReadings> readings) {
    moment.readings = std::move(readings);
    view.setMoment(moment);
  }
  void look(PatchView::StandardView from) {
    view.showStandardView(from);
    view.drawNow();
  }
  void activate() {
    view.activateWindow();
    ASSERT_TRUE(test::waitUntilActive(view));
  }

  Selection selection;
  ScaleRanges ranges;  // for a view that shall not have ranges of its own
  PatchView view{&selection};
  SceneWidget* canvas = nullptr;
  PatchMoment moment;
};

}  // namespace hexoderm
