// The 3D view's menu, its directions to look from, and the cut.
#include "tests/widgets/patch/patch_view_fixture.h"
#include "widgets/patch/cut_bar.h"
#include "widgets/scene/scene_corners.h"

namespace hexoderm {
namespace {

class PatchFormTest : public PatchViewFixture {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(PatchViewFixture::SetUp());
    view.setReconstruction(shared(demoReconstruction()));
    view.showStandardView(PatchView::StandardView::Front);
    static_cast<void>(view.screenshot());
  }
  void TearDown() override {
    if (QMenu* menu = openMenu()) menu->close();
  }

  QMenu* openMenu() { return view.findChild<QMenu*>("patchMenu"); }
  void clickRight(const QPoint& at, const QPoint& to) {
    test::dragMouse(canvas, at, to, {}, Qt::RightButton, to == at ? 0 : 1);
  }
  /// Of the open menu; none where the menu does not have it.
  QAction* entry(const char* name) {
    for (QAction* action : test::part<QMenu>(view, "patchMenu")->actions()) {
      if (action->objectName() == name) return action;
    }
    return nullptr;
  }
  QAction* theEntry(const char* name) {
    QAction* found = entry(name);
    if (found == nullptr) throw std::runtime_error(std::string("the menu has no ") + name);
    return found;
  }
};

TEST_F(PatchFormTest, TheRightButtonOpensAMenuForTheCellUnderItAndThePicture) {
  clickRight(canvas->rect().center(), canvas->rect().center());
  EXPECT_THAT(theEntry("actionPickCell")->text(), HasText("1"));
  theEntry("actionPickCell")->trigger();
  EXPECT_EQ(selection.cell(), CellId(1));
  EXPECT_NE(entry("actionCenterCell"), nullptr);
  for (QAction* action :
       {controls().fitAction(), controls().parallelAction(), controls().cutAction(), controls().measureAction(),
        controls().pictureAction(), controls().coloringMenu()->menuAction(), controls().showMenu()->menuAction()}) {
    EXPECT_TRUE(openMenu()->actions().contains(action)) << action->text().toStdString();
  }
  QApplication::clipboard()->clear();
  theEntry("actionCopyPicture")->trigger();
  EXPECT_EQ(QApplication::clipboard()->image().size(), canvas->size() * canvas->devicePixelRatioF());
}

TEST_F(PatchFormTest, BesideTheSkinTheMenuIsAboutThePictureAloneAndByItsKeyAboutWhatIsInTheMiddle) {
  const QPoint beside(canvas->width() / 2, canvas->height() - 4);
  clickRight(beside, beside);
  EXPECT_EQ(entry("actionPickCell"), nullptr);
  EXPECT_TRUE(openMenu()->actions().contains(controls().fitAction()));
  openMenu()->close();
  ASSERT_TRUE(test::waitUntil([this] { return openMenu() == nullptr; }));
  QContextMenuEvent key(QContextMenuEvent::Keyboard, QPoint(3, 3));
  QApplication::sendEvent(&view, &key);
  EXPECT_NE(entry("actionPickCell"), nullptr);
}

TEST_F(PatchFormTest, DraggingWithTheRightButtonZoomsAndOpensNothing) {
  const QImage before = view.screenshot();
  const QPoint from = canvas->rect().center();
  clickRight(from, from + QPoint(0, 60));
  EXPECT_EQ(openMenu(), nullptr);
  EXPECT_NE(view.screenshot(), before);
}

TEST_F(PatchFormTest, ACellIsBroughtIntoTheMiddleByTheMenu) {
  const QImage before = view.screenshot();
  // Some cell that is not in the middle.
  QPoint beside;
  for (int x = 40; x < 200 && beside.isNull(); x += 5) {
    const QPoint at = canvas->rect().center() + QPoint(x, -x / 2);
    click(at);
    if (selection.cell() && selection.cell() != CellId(1)) beside = at;
  }
  ASSERT_FALSE(beside.isNull());
  selection.clear();
  clickRight(beside, beside);
  theEntry("actionCenterCell")->trigger();
  EXPECT_NE(view.screenshot(), before);
  EXPECT_EQ(selection.cell(), std::nullopt);
}

TEST_F(PatchFormTest, EveryDirectionOfTheMenuIsAnotherPicture) {
  std::vector<QImage> pictures;
  ASSERT_EQ(controls().viewActions().size(), 5U);
  for (QAction* look : controls().viewActions()) {
    EXPECT_FALSE(look->toolTip().isEmpty());
    look->trigger();
    const QImage picture = view.screenshot();
    for (const QImage& other : pictures) EXPECT_NE(picture, other) << look->text().toStdString();
    pictures.push_back(picture);
  }
  view.showStandardView(PatchView::StandardView::Back);
  EXPECT_EQ(view.screenshot(), pictures[1]);
  view.showStandardView(PatchView::StandardView::Isometric);
  EXPECT_EQ(view.screenshot(), pictures[4]);
}

TEST_F(PatchFormTest, AClickOnAKnobOfTheAxesTurnsThePictureAndPicksNothing) {
  const QImage front = view.screenshot();
  // From in front the x axis points to the right of its corner.
  const QPoint corner(SceneCorners::kLeft + SceneCorners::kSize / 2,
                      canvas->height() - SceneCorners::kBottom - SceneCorners::kSize / 2);
  const QPoint knob = corner + QPoint(qRound(0.8 / 1.15 * SceneCorners::kSize / 2), 0);
  selection.selectCell(CellId(3));
  click(knob);
  EXPECT_EQ(selection.cell(), CellId(3));
  const QImage side = view.screenshot();
  EXPECT_NE(side, front);
  view.showStandardView(PatchView::StandardView::Side);
  EXPECT_EQ(view.screenshot(), side);
}

TEST_F(PatchFormTest, TheCutHasASliderThatTheKeysMoveAndThatIsThereOnlyForIt) {
  auto* bar = test::part<CutBar>(view);
  EXPECT_FALSE(bar->isVisible());
  const QImage whole = view.screenshot();
  controls().cutAction()->trigger();
  EXPECT_TRUE(bar->isVisible());
  const QImage half = view.screenshot();
  EXPECT_NE(half, whole);
  auto* slider = bar->findChild<QSlider*>();
  EXPECT_FALSE(slider->accessibleName().isEmpty());
  for (int k = 0; k < 30; ++k) QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_NEAR(bar->share(), 0.8, 1e-9);
  EXPECT_NE(view.screenshot(), half);
  view.showStandardView(PatchView::StandardView::Side);
  const QImage from_the_side = view.screenshot();
  bar->findChild<QToolButton*>()->click();
  EXPECT_NE(view.screenshot(), from_the_side);
  controls().cutAction()->trigger();
  EXPECT_FALSE(bar->isVisible());
  view.showStandardView(PatchView::StandardView::Front);
  EXPECT_TRUE(test::waitUntil([&] { return view.screenshot() == whole; })) << "as soon as the buttons stand as before";
}

}  // namespace
}  // namespace hexoderm
