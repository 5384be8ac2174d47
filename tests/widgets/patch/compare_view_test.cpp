#include "widgets/patch/compare_view.h"

#include "hexoderm/base/se3.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/kept_picture.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/patch_view.h"
#include "widgets/patch/scene_widget.h"

#include <vtkCamera.h>

namespace hexoderm {
namespace {

class CompareViewTest : public testing::Test {
 protected:
  CompareViewTest() {
    Reconstruction other = demoReconstruction();
    double off_m = 0;
    for (CellPlacement& cell : other.patches[0].cells) cell.T_o_u.t.z() += off_m += 0.0001;
    content.before = shared(std::move(other));
    content.now = shared(demoReconstruction());
    content.comparison =
        std::make_shared<const std::vector<Comparison>>(compareToReconstruction(*content.now, *content.before));
  }
  void show() {
    view.setSources({"the last change", "arm.calibration.json"}, 0, {});
    view.setContent(content);
    view.resize(1000, 560);
    view.show();
    ASSERT_TRUE(test::waitUntilExposed(view));
  }
  void keep(const QString& name) {
    view.before().drawNow();
    view.now().drawNow();
    keepPicture(view.grab().toImage(), name);
  }
  /// Where the camera looks from, in the patch's frame.
  static Eigen::Vector3d from(const PatchView& patch) {
    return -Eigen::Vector3d(patch.camera()->GetDirectionOfProjection());
  }
  template <class T>
  T* find(const char* name) {
    return view.findChild<T*>(QLatin1String(name));
  }

  Selection selection;
  CompareView view{&selection};
  CompareView::Content content;
};

TEST_F(CompareViewTest, BothSidesAreSeenFromTheSameSideWhicheverIsTurned) {
  show();
  ASSERT_NE(view.before().camera(), nullptr);
  view.before().camera()->Azimuth(40);
  EXPECT_LT(angleBetween(from(view.before()), from(view.now())), 1e-9);
  view.now().camera()->Elevation(-25);
  EXPECT_LT(angleBetween(from(view.before()), from(view.now())), 1e-9);
  EXPECT_EQ(view.before().camera()->GetDistance(), view.now().camera()->GetDistance());
  auto* canvas = view.now().findChild<SceneWidget*>();
  const Eigen::Vector3d before = from(view.before());
  test::dragMouse(canvas, canvas->rect().center(), canvas->rect().center() + QPoint(60, 20));
  EXPECT_GT(angleBetween(from(view.before()), before), 0.05) << "the mouse on one turns the other";
  EXPECT_LT(angleBetween(from(view.before()), from(view.now())), 1e-9);
  keep("compare-side-by-side");
}

TEST_F(CompareViewTest, ColoursAreTheSameOnBoth) {
  show();
  view.before().setColoring(Coloring::PathDistance);
  EXPECT_EQ(view.now().coloring(), Coloring::PathDistance);
  view.now().setColoring(Coloring::LinkQuality);
  EXPECT_EQ(view.before().coloring(), Coloring::LinkQuality);
}

TEST_F(CompareViewTest, SaysHowFarTheTwoAreApartAndNamesTheCellThatMovedMost) {
  show();
  const QString text = find<QLabel>("compareSummary")->text();
  EXPECT_THAT(text, BeginsWith("17 cells in common."));
  const Comparison& comparison = content.comparison->front();
  const auto farthest =
      std::ranges::max_element(comparison.cells, {}, [](const CellDifference& cell) { return cell.position_m.norm(); });
  EXPECT_THAT(text, HasText(QStringLiteral("cell %1 ").arg(farthest->cell.value())));
}

TEST_F(CompareViewTest, ArrowsAreEnlargedAsFarAsTheSliderSays) {
  show();
  EXPECT_FALSE(find<QSlider>("compareFactor")->isVisible());
  EXPECT_EQ(view.factor(), std::nullopt);
  QTest::mouseClick(find<QToolButton>("compareArrows"), Qt::LeftButton);
  ASSERT_EQ(view.mode(), CompareView::Mode::Arrows);
  ASSERT_TRUE(view.factor().has_value());
  EXPECT_FALSE(view.before().isVisible());
  auto* slider = find<QSlider>("compareFactor");
  ASSERT_TRUE(slider->isVisible());
  const QImage by_itself = view.now().screenshot();
  slider->setValue(slider->minimum());
  EXPECT_EQ(view.factor(), 1.0);
  EXPECT_EQ(find<QLabel>("compareFactorLabel")->text(), "1 times");
  EXPECT_NE(view.now().screenshot(), by_itself);
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(view.factor(), 2.0);
  keep("compare-arrows");
  QTest::mouseClick(find<QToolButton>("compareSideBySide"), Qt::LeftButton);
  EXPECT_TRUE(view.before().isVisible());
  EXPECT_EQ(view.factor(), std::nullopt);
}

TEST_F(CompareViewTest, WhatIsPickedOnOneSideIsPickedOnBoth) {
  show();
  const QImage before = view.before().screenshot();
  const QImage now = view.now().screenshot();
  selection.selectCell(CellId(5));
  EXPECT_NE(view.before().screenshot(), before);
  EXPECT_NE(view.now().screenshot(), now);
}

}  // namespace
}  // namespace hexoderm
