#include "widgets/patch/patch_view.h"

#include "hexoderm/solve/checks/evaluation.h"
#include "tests/support/kept_picture.h"
#include "tests/support/picture_counter.h"
#include "tests/widgets/patch/patch_view_fixture.h"
#include "widgets/patch/opengl_info.h"
#include "widgets/patch/patch_captions.h"
#include "widgets/style/palette.h"

#include <vtkRenderWindow.h>
#include <vtkWeakPointer.h>

namespace hexoderm {
namespace {

std::shared_ptr<const Reconstruction> demo(std::uint32_t arm_cells = 4) {
  DemoOptions options;
  options.arm_cells = arm_cells;
  return shared(demoReconstruction(options));
}

class PatchViewTest : public PatchViewFixture {
 protected:
  QToolButton* button(const QString& text) {
    for (QToolButton* candidate : view.findChildren<QToolButton*>()) {
      if (candidate->text() == text) return candidate;
    }
    throw std::runtime_error("there is no button " + text.toStdString());
  }

  void showAtRest() {
    view.setReconstruction(demo());
    ASSERT_TRUE(test::waitUntil([this] {
      const test::PictureCounter still_drawn(*canvas);
      test::letTurnsPass();
      return canvas->isPictureSmoothed() && still_drawn.count() == 0;
    }));
  }

  QString words() { return view.findChild<PatchCaptions*>()->accessibleDescription(); }

  PatchOverlays overlays;
};

TEST_F(PatchViewTest, SeveralSizesAndColoursOneAfterTheOtherMakeOnePictureAndASmoothOne) {
  ASSERT_NO_FATAL_FAILURE(showAtRest());
  const test::PictureCounter drawn(*canvas);
  for (const int width : {700, 660, 720, 680}) view.setFixedSize(width, 500);
  view.setPalette(qtPalette(Theme::Dark));
  EXPECT_EQ(canvas->width(), 680);
  EXPECT_EQ(drawn.count(), 0);
  EXPECT_TRUE(test::waitUntil([&] { return drawn.count() > 0; }));
  EXPECT_EQ(canvas->renderWindow()->GetSize()[0], qRound(680 * canvas->devicePixelRatioF()));
  EXPECT_TRUE(test::waitUntil([this] { return canvas->picture().width() > 640 && canvas->isPictureSmoothed(); }));
  test::letTurnsPass();
  EXPECT_LE(drawn.count(), 2);
}

TEST_F(PatchViewTest, AnotherSizeShowsThePictureThereIsUntilItIsDrawn) {
  view.setReconstruction(demo());
  const QSize small = canvas->picture().size();
  view.resize(700, 540);
  ASSERT_TRUE(test::waitUntil([&] { return canvas->width() == 700; }));
  const QColor background(1, 2, 3);
  canvas->setBackground(background);
  // Painted before it is drawn: the picture in the middle, the background around it.
  const QImage before = canvas->grab().toImage();
  ASSERT_EQ(before.size(), QSize(700, 540) * canvas->devicePixelRatioF());
  EXPECT_EQ(before.pixelColor(2, 2), background);
  EXPECT_NE(before.pixelColor(before.rect().center()), background);
  EXPECT_GT(canvas->picture().width(), small.width());
  EXPECT_NE(canvas->grab().toImage().pixelColor(2, 2), background);
}

TEST(PatchViewInAWindow, ChangesMadeWhileHiddenAreDrawnWhenShownAgain) {
  Selection selection;
  QWidget window;
  auto* view = new PatchView(&selection, &window);  // hidden as in a tab: its window stays
  view->resize(640, 480);
  window.resize(640, 480);
  window.show();
  ASSERT_TRUE(test::waitUntilExposed(window));
  auto* canvas = view->findChild<SceneWidget*>();
  ASSERT_TRUE(test::waitUntil([canvas] { return qGray(canvas->picture().pixel(3, 3)) > 180; }));
  view->hide();
  view->setPalette(qtPalette(Theme::Dark));
  view->show();
  EXPECT_TRUE(test::waitUntil([canvas] { return qGray(canvas->picture().pixel(3, 3)) < 60; }));
}

TEST(PatchViewInAWindow, LeavesNothingOfVtkBehind) {
  Selection selection;
  vtkWeakPointer<vtkRenderWindow> window;
  {
    PatchView view(&selection);
    view.setReconstruction(demo());
    EXPECT_GT(coloursIn(view.screenshot()), 60U) << "although it was never shown";
    window = view.findChild<SceneWidget*>()->renderWindow();
    ASSERT_NE(window, nullptr);
  }
  EXPECT_EQ(window, nullptr);
}

TEST_F(PatchViewTest, ClickPicksTheCellAndClickBesideClears) {
  view.setReconstruction(demo(0));
  QSignalSpy changed(&selection, &Selection::changed);
  click(canvas->rect().center());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(selection.cell(), CellId(1));
  click(QPoint(5, canvas->height() - 5));
  EXPECT_EQ(changed.count(), 2);
  EXPECT_EQ(selection.cell(), std::nullopt);
}

TEST_F(PatchViewTest, TheWheelZoomsAndTheButtonFitsAgain) {
  view.setReconstruction(demo());
  view.showStandardView(PatchView::StandardView::Front);
  const QImage fitted = view.screenshot();
  test::turnWheel(canvas, canvas->rect().center(), 120);
  EXPECT_NE(view.screenshot(), fitted);
  QTest::mouseClick(button("Fit"), Qt::LeftButton);
  EXPECT_EQ(view.screenshot(), fitted);
}

TEST_F(PatchViewTest, ColourModesChangeThePictureAndTheLegend) {
  Reconstruction skin = demoReconstruction();
  for (CellPlacement& cell : skin.patches[0].cells) {
    cell.body_part = cell.cell.value() < 9 ? "forearm" : "upper arm";
    cell.cov_t_r = Matrix6d::Identity() * 1e-6 * static_cast<double>(skin.patches[0].pathTo(cell.cell).size() - 1);
    cell.shape_cov_t_r = Matrix6d::Identity() * 1e-7 * static_cast<double>(skin.patches[0].pathTo(cell.cell).size());
  }
  view.setReconstruction(shared(skin));
  read(readingsOf({{CellId(1), {0.1, 0.2, 0.9}}, {CellId(2), {0.5, -0.6, 0.7}}}, {{CellId(2), 31.5}}));
  overlays.surface = shared(evaluateSurface(skin.patches[0], SurfaceKind::Sphere));
  view.setOverlays(overlays);
  auto* modes = test::part<QMenu>(view, "coloringMenu");
  std::vector<QImage> pictures;
  std::set<QString> legends;
  for (QAction* mode : modes->actions()) {
    if (mode->isSeparator()) continue;
    EXPECT_TRUE(mode->isEnabled()) << mode->toolTip().toStdString();
    mode->trigger();
    legends.insert(words());
    const QImage picture = view.screenshot();
    for (const QImage& other : pictures) EXPECT_NE(picture, other) << mode->text().toStdString();
    pictures.push_back(picture);
  }
  EXPECT_EQ(pictures.size(), 19U);
  EXPECT_EQ(legends.size(), 19U);
}

TEST_F(PatchViewTest, WhatCantBeShownSaysWhy) {
  view.setReconstruction(demo());
  const auto expectReason = [](const QAction* action) {
    EXPECT_FALSE(action->isEnabled()) << action->text().toStdString();
    EXPECT_FALSE(action->toolTip().isEmpty());
    EXPECT_NE(action->toolTip(), action->text());
  };
  for (const Coloring coloring : {Coloring::PositionUncertainty, Coloring::BodyPart, Coloring::ReadingX,
                                  Coloring::Temperature, Coloring::SurfaceDistance}) {
    expectReason(controls().action(coloring));
  }
  for (const SceneItem item :
       {SceneItem::Ellipsoids, SceneItem::Truth, SceneItem::Surface, SceneItem::Loop, SceneItem::Comparison}) {
    expectReason(controls().action(item));
  }
  EXPECT_TRUE(controls().action(SceneItem::Links)->isEnabled());
  read(readingsOf({{CellId(1), {0, 0, 1}}}));
  EXPECT_TRUE(controls().action(Coloring::ReadingX)->isEnabled());
  EXPECT_FALSE(controls().action(Coloring::Temperature)->isEnabled());
  read(readingsOf({}));
  EXPECT_FALSE(controls().action(Coloring::ReadingX)->isEnabled());
}

TEST_F(PatchViewTest, ReadingsRecolourTheCellsAtOnce) {
  view.setReconstruction(demo());
  read(readingsOf({{CellId(1), {0, 0, 1}}}));
  controls().action(Coloring::ReadingZ)->setChecked(true);
  const QImage up = view.screenshot();
  EXPECT_THAT(words(), HasText("z, g"));
  read(readingsOf({{CellId(1), {0, 0, -1}}}));
  EXPECT_NE(view.screenshot(), up);
  read(readingsOf({{CellId(1), {0, 0, 1}}}));
  EXPECT_EQ(view.screenshot(), up);
}

TEST_F(PatchViewTest, OverlaysAreNamedWithTheirEnlargement) {
  const auto skin = demo();
  view.setReconstruction(skin);
  GroundTruth truth;
  for (const CellPlacement& cell : skin->patches[0].cells) truth.cells.push_back({cell.cell, cell.T_o_u});
  overlays.truth = std::make_shared<const GroundTruth>(truth);
  view.setOverlays(overlays);
  EXPECT_FALSE(words().contains("truth")) << "only where it was asked for";
  controls().action(SceneItem::Truth)->trigger();
  EXPECT_TRUE(words().contains("truth"));
  overlays.loop = shared(evaluateLoop(*skin, {CellId(14), PortNumber(1)}, {CellId(17), PortNumber(4)}));
  view.setOverlays(overlays);
  EXPECT_THAT(words(), HasText("loop gap: "));
  Reconstruction before = *skin;
  before.patches[0].cells[3].T_o_u.t.z() += 0.001;
  overlays.comparison = shared(compareToReconstruction(*skin, before));
  view.setOverlays(overlays);
  EXPECT_THAT(words(), HasText("arrows: from before to now, drawn 10 times as large"));
  controls().action(SceneItem::Comparison)->trigger();
  EXPECT_FALSE(words().contains("arrows"));
}

TEST_F(PatchViewTest, PatchesThatAreNotPlacedAreSaidText) {
  view.setReconstruction(demo());
  EXPECT_FALSE(words().contains("not placed"));
  DemoOptions lonely;
  lonely.first_id = 101;
  lonely.arm_cells = 0;
  view.setReconstruction(shared(demoPatches({DemoOptions(), lonely})));
  EXPECT_THAT(words(), HasText("dashed frame: patch of cell 101, not placed against the others"));
  controls().measureAction()->trigger();
  selection.selectCell(CellId(1));
  selection.selectCell(CellId(101));
  EXPECT_THAT(words(), HasText("Cells 1 and 101 are in different patches"));
  EXPECT_FALSE(words().contains("mm apart"));
  controls().measureAction()->trigger();
  std::vector<DemoOptions> many = {DemoOptions()};
  for (std::uint32_t k = 0; k < 9; ++k) {
    many.push_back(lonely);
    many.back().first_id += k;
  }
  view.setReconstruction(shared(demoPatches(many)));
  EXPECT_THAT(words(), HasText("9 patches beside the largest"));
}

TEST_F(PatchViewTest, MeasuresBetweenTwoClickedCellsUntilEsc) {
  view.setReconstruction(demo());
  view.showStandardView(PatchView::StandardView::Front);
  static_cast<void>(view.screenshot());
  QTest::mouseClick(button(controls().measureAction()->iconText()), Qt::LeftButton);
  EXPECT_TRUE(words().contains("first cell"));
  click(canvas->rect().center());
  EXPECT_EQ(selection.cell(), CellId(1));
  EXPECT_TRUE(words().contains("second cell"));
  const QImage one = view.screenshot();
  selection.selectCell(CellId(6));  // picked in another view: the same
  EXPECT_TRUE(words().contains(QRegularExpression("[0-9.]+ mm apart.*[0-9.]+°"))) << words().toStdString();
  EXPECT_NE(view.screenshot(), one);
  ASSERT_NO_FATAL_FAILURE(activate());
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_FALSE(controls().measureAction()->isChecked());
  EXPECT_FALSE(words().contains("mm apart"));
  EXPECT_TRUE(view.isVisible()) << "Esc never closes";
  selection.selectCell(CellId(3));
  EXPECT_FALSE(words().contains("second cell")) << "it is off";
}

TEST_F(PatchViewTest, LargeSkinIsPreparedBesideTheWindowAndTheNewestWins) {
  view.setReconstruction(shared(cylinderSheet(100, 80)));
  EXPECT_FALSE(view.isUpToDate());
  EXPECT_TRUE(view.findChild<PatchCaptions*>()->accessibleName().contains("Preparing"));
  view.setReconstruction(shared(cylinderSheet(60, 50)));
  ASSERT_TRUE(test::waitUntil([this] { return view.isUpToDate(); }));
  EXPECT_TRUE(view.findChild<PatchCaptions*>()->accessibleName().isEmpty());
  const QImage newest = view.screenshot();
  view.setReconstruction(demo());
  EXPECT_TRUE(view.isUpToDate());
  view.setReconstruction(shared(cylinderSheet(60, 50)));
  QImage later;
  view.whenUpToDate([&] { later = view.screenshot(); });
  EXPECT_TRUE(later.isNull()) << "nobody waits for it";
  ASSERT_TRUE(test::waitUntil([&] { return !later.isNull(); }));
  EXPECT_EQ(later, newest);
  bool at_once = false;
  view.whenUpToDate([&] { at_once = true; });
  EXPECT_TRUE(at_once);
  view.setReconstruction(demo());
  view.setReconstruction(shared(cylinderSheet(60, 50)));
  view.waitUntilUpToDate();
  EXPECT_EQ(view.screenshot(), newest);
  // A result in preparation does not overwrite a later one.
  view.setReconstruction(demo(0));
  const QImage single = view.screenshot();
  const auto large = shared(cylinderSheet(100, 80));
  view.setReconstruction(large);
  view.setReconstruction(demo(0));
  PatchView other(&selection);  // by the time that it has prepared the same, the other has too
  other.setReconstruction(large);
  ASSERT_TRUE(test::waitUntil([&] { return other.isUpToDate(); }));
  EXPECT_EQ(view.screenshot(), single);
}

TEST(PatchViewInAWindow, IsClosedWhileALargeSkinIsPreparedAndLeavesNothingBehind) {
  Selection selection;
  const auto widgets = QApplication::allWidgets().size();
  const auto large = shared(cylinderSheet(100, 80));
  auto other = std::make_unique<PatchView>(&selection);
  other->setReconstruction(large);
  EXPECT_FALSE(other->isUpToDate());
  other.reset();
  QCoreApplication::processEvents();
  EXPECT_EQ(QApplication::allWidgets().size(), widgets);
  EXPECT_EQ(large.use_count(), 1);
}

TEST_F(PatchViewTest, TheMenuOffersToSaveAPictureAndSaysWhatDraws) {
  view.setReconstruction(demo());
  const QString renderer = openGlText(queryOpenGl());
  ASSERT_FALSE(renderer.isEmpty());
  QSignalSpy requested(&view, &PatchView::pictureRequested);
  bool said = false;
  for (QAction* action : view.findChild<QMenu*>("showMenu")->actions()) {
    if (action->objectName() == "actionScenePicture") action->trigger();
    said = said || action->text().contains(renderer);
  }
  EXPECT_EQ(requested.count(), 1);
  EXPECT_TRUE(said);
}

TEST_F(PatchViewTest, KeysGoOnToTheWindow) {
  view.setReconstruction(demo());
  const QImage before = view.screenshot();
  for (const char key : {'w', 'e', 'q', 's', 'r'}) {
    QKeyEvent press(QEvent::KeyPress, key - 'a' + Qt::Key_A, Qt::NoModifier, QString(QChar::fromLatin1(key)));
    QCoreApplication::sendEvent(canvas, &press);
    EXPECT_FALSE(press.isAccepted()) << key;
  }
  EXPECT_EQ(view.screenshot(), before);
}

TEST_F(PatchViewTest, NothingToShowIsSaidAndDoesNotCrash) {
  const QImage hint = view.screenshot();
  EXPECT_GT(coloursIn(hint.copy(100, 200, 440, 80)), 20U);  // its letters over the plain ground
  view.setReconstruction(nullptr);
  view.fit();
  view.showStandardView(PatchView::StandardView::Side);
  moment.pose = PoseId(3);
  view.setMoment(moment);
  selection.selectCell(CellId(4));
  click(canvas->rect().center());
  EXPECT_EQ(selection.cell(), std::nullopt);
  EXPECT_EQ(view.screenshot(), hint);

  view.setReconstruction(demo());
  EXPECT_NE(view.screenshot(), hint);
  view.setReconstruction(nullptr);
  EXPECT_EQ(view.screenshot(), hint);
}

}  // namespace
}  // namespace hexoderm
