#include "widgets/patch_view.h"

#include "support/demo_reconstruction.h"
#include "widgets/selection.h"

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <set>

namespace hexoderm {
namespace {

std::shared_ptr<const Reconstruction> demo(std::uint32_t arm_cells = 4) {
  DemoOptions options;
  options.arm_cells = arm_cells;
  return std::make_shared<const Reconstruction>(demoReconstruction(options));
}

class PatchViewTest : public testing::Test {
 protected:
  void show() {
    view.resize(640, 480);
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    gl = view.findChild<QVTKOpenGLNativeWidget*>();
    ASSERT_NE(gl, nullptr);
  }

  void click(const QPoint& at) {
    QTest::mousePress(gl, Qt::LeftButton, {}, at);
    QTest::mouseRelease(gl, Qt::LeftButton, {}, at);
  }

  QToolButton* button(const QString& text) {
    for (QToolButton* candidate : view.findChildren<QToolButton*>()) {
      if (candidate->text() == text) return candidate;
    }
    return nullptr;
  }

  Selection selection;
  PatchView view{&selection};
  QVTKOpenGLNativeWidget* gl = nullptr;
};

std::size_t coloursIn(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 2) {
    for (int x = 0; x < image.width(); x += 2) colours.insert(image.pixel(x, y));
  }
  return colours.size();
}

TEST_F(PatchViewTest, ScreenshotShowsTheSkinInBothThemes) {
  show();
  view.setReconstruction(demo());
  const QImage light = view.screenshot();
  view.setTheme(Theme::Dark);
  const QImage dark = view.screenshot();
  EXPECT_EQ(light.size(), gl->size() * gl->devicePixelRatioF());
  EXPECT_GT(coloursIn(light), 60U);
  EXPECT_GT(coloursIn(dark), 60U);
  EXPECT_GT(qGray(light.pixel(3, 3)), 180);
  EXPECT_LT(qGray(dark.pixel(3, 3)), 60);
}

TEST_F(PatchViewTest, ScreenshotWorksBeforeTheViewWasShown) {
  view.resize(400, 300);
  view.setReconstruction(demo());
  EXPECT_GT(coloursIn(view.screenshot()), 60U);
}

TEST_F(PatchViewTest, ClickPicksTheCellAndClickBesideClears) {
  show();
  view.setReconstruction(demo(0));
  QSignalSpy changed(&selection, &Selection::changed);
  click(gl->rect().center());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(selection.cell(), CellId(1));
  click(QPoint(5, gl->height() - 5));
  EXPECT_EQ(changed.count(), 2);
  EXPECT_EQ(selection.cell(), std::nullopt);
}

TEST_F(PatchViewTest, DragTurnsTheSceneAndPicksNothing) {
  show();
  view.setReconstruction(demo());
  const QImage before = view.screenshot();
  const QPoint from = gl->rect().center();
  QTest::mousePress(gl, Qt::LeftButton, {}, from);
  QTest::mouseMove(gl, from + QPoint(40, 10));
  QTest::mouseMove(gl, from + QPoint(80, 20));
  QTest::mouseRelease(gl, Qt::LeftButton, {}, from + QPoint(80, 20));
  EXPECT_EQ(selection.cell(), std::nullopt);
  EXPECT_NE(view.screenshot(), before);
}

TEST_F(PatchViewTest, SelectionMadeElsewhereIsOutlined) {
  show();
  view.setReconstruction(demo());
  const QImage before = view.screenshot();
  selection.selectCell(CellId(2));
  const QImage cell = view.screenshot();
  EXPECT_NE(cell, before);
  selection.selectLink({CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)});
  EXPECT_NE(view.screenshot(), cell);
  selection.clear();
  EXPECT_EQ(view.screenshot(), before);
}

TEST_F(PatchViewTest, ButtonsMoveTheCamera) {
  show();
  view.setReconstruction(demo());
  QImage last = view.screenshot();
  for (const char* name : {"Front", "Side", "Top"}) {
    QToolButton* standard = button(QString::fromLatin1(name));
    ASSERT_NE(standard, nullptr) << name;
    QTest::mouseClick(standard, Qt::LeftButton);
    const QImage now = view.screenshot();
    EXPECT_NE(now, last) << name;
    last = now;
  }
  QWheelEvent zoom(QPointF(gl->rect().center()), gl->mapToGlobal(gl->rect().center()), {}, QPoint(0, 120), Qt::NoButton,
                   Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(gl, &zoom);
  EXPECT_NE(view.screenshot(), last);
  ASSERT_NE(button("Fit"), nullptr);
  QTest::mouseClick(button("Fit"), Qt::LeftButton);
  EXPECT_EQ(view.screenshot(), last);
}

TEST_F(PatchViewTest, ColourModesChangeThePicture) {
  show();
  view.setReconstruction(demo());
  auto* modes = view.findChild<QMenu*>();
  ASSERT_NE(modes, nullptr);
  std::vector<QImage> pictures;
  for (QAction* mode : modes->actions()) {
    mode->trigger();
    pictures.push_back(view.screenshot());
  }
  ASSERT_EQ(pictures.size(), 3U);
  EXPECT_NE(pictures[0], pictures[1]);
  EXPECT_NE(pictures[1], pictures[2]);
  EXPECT_NE(pictures[0], pictures[2]);
}

TEST_F(PatchViewTest, PoseDecidesWhereGravityPoints) {
  show();
  view.setReconstruction(demo());
  const QImage last = view.screenshot();
  view.setPose(PoseId(1));
  EXPECT_NE(view.screenshot(), last);
  view.setPose(std::nullopt);
  EXPECT_EQ(view.screenshot(), last);
}

TEST_F(PatchViewTest, KeysGoOnToTheWindow) {
  show();
  view.setReconstruction(demo());
  const QImage before = view.screenshot();
  for (const char key : {'w', 'e', 'q', 's', 'r'}) {
    QKeyEvent press(QEvent::KeyPress, key - 'a' + Qt::Key_A, Qt::NoModifier, QString(QChar::fromLatin1(key)));
    QCoreApplication::sendEvent(gl, &press);
    EXPECT_FALSE(press.isAccepted()) << key;
  }
  EXPECT_EQ(view.screenshot(), before);
}

TEST_F(PatchViewTest, NothingToShowIsSaidAndDoesNotCrash) {
  show();
  const QImage hint = view.screenshot();
  EXPECT_GT(coloursIn(hint.copy(100, 200, 440, 80)), 20U);  // its letters over the plain ground
  view.setReconstruction(nullptr);
  view.fit();
  view.showStandardView(PatchView::StandardView::Side);
  view.setPose(PoseId(3));
  selection.selectCell(CellId(4));
  click(gl->rect().center());
  EXPECT_EQ(selection.cell(), std::nullopt);
  EXPECT_EQ(view.screenshot(), hint);

  view.setReconstruction(demo());
  EXPECT_NE(view.screenshot(), hint);
  view.setReconstruction(nullptr);
  EXPECT_EQ(view.screenshot(), hint);
}

}  // namespace
}  // namespace hexoderm
