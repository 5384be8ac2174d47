#include "widgets/robot/robot_view.h"

#include "tests/support/qt_wait.h"
#include "tests/widgets/scene/patch_scene_test.h"
#include "widgets/patch/scene_widget.h"

namespace hexoderm {
namespace {

constexpr double kViewedBox_m = 0.2;

/// A box with a patch on its top, seen closely: the middle of the patch is in the middle of the view.
class RobotViewTest : public testing::Test {
 protected:
  void SetUp() override {
    picture.bodies =
        std::make_shared<const LinkBodies>(LinkBodies{meshOfBox({kViewedBox_m, kViewedBox_m, kViewedBox_m})});
    picture.T_w_l = {SE3{}};
    picture.skin = shared(demoReconstruction());
    picture.patches = {{0, 0, SE3{Eigen::Matrix3d::Identity(), {0, 0, kViewedBox_m / 2 + 0.003}}, false}};
    picture.movable = 0;
    view.resize(500, 400);
    view.show();
    view.activateWindow();
    ASSERT_TRUE(test::waitUntilExposed(view));
    view.setPicture(picture);
    ASSERT_TRUE(view.canDraw()) << "no OpenGL";
    QCoreApplication::processEvents();  // until then the canvas has no size
    canvas = test::part<SceneWidget>(view);
    view.lookAtSkin(0);
    view.drawNow();
    const auto note = [this](const char* what, Eigen::Vector3d& where) {
      return [this, what, &where](const Eigen::Vector3d& x_l) {
        said << what;
        where = x_l;
      };
    };
    QObject::connect(&view, &RobotView::gripped, note("gripped", gripped_at));
    QObject::connect(&view, &RobotView::pulledTo, note("pulled", pulled_to));
    QObject::connect(&view, &RobotView::released, [this] { said << "released"; });
    QObject::connect(&view, &RobotView::laid, [this] { said << "laid"; });
    QObject::connect(&view, &RobotView::leftAlone, [this] { said << "left"; });
    QObject::connect(&view, &RobotView::slid, [this](const Eigen::Vector3d& way_l) { way = way_l; });
    QObject::connect(&view, &RobotView::turned, [this](double angle_rad) { turn = angle_rad; });
  }
  void move(const QPoint& to) { test::moveMouse(canvas, to, Qt::LeftButton); }
  void press(const QPoint& at) { QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, at); }
  void release(const QPoint& at) { QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, at); }
  /// On a cell of the patch: its middle may lie between cells.
  QPoint onPatch() {
    const QPoint middle = canvas->rect().center();
    for (const QPoint& aside : {QPoint(0, 0), QPoint(25, 0), QPoint(-25, 0), QPoint(0, 25), QPoint(0, -25)}) {
      QTest::mouseClick(canvas, Qt::LeftButton, {}, middle + aside);
      const bool hit = said.contains("gripped");
      said.clear();
      if (hit) return middle + aside;
    }
    ADD_FAILURE() << "no cell is found where the patch is";
    return middle;
  }

  RobotView view;
  RobotPicture picture;
  SceneWidget* canvas = nullptr;
  QStringList said;
  Eigen::Vector3d gripped_at = Eigen::Vector3d::Zero();
  Eigen::Vector3d pulled_to = Eigen::Vector3d::Zero();
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  double turn = 0;
};

TEST_F(RobotViewTest, TheMouseGripsThePatchPullsItAndLetsItGo) {
  const QPoint at = onPatch();
  const QImage before = view.screenshot();
  press(at);
  EXPECT_EQ(said, QStringList({"gripped"}));
  EXPECT_NEAR(gripped_at.z(), kViewedBox_m / 2, 0.005);
  move(at + QPoint(1, 1));
  EXPECT_EQ(said.size(), 1) << "a hand trembles";
  move(at + QPoint(20, 10));
  EXPECT_EQ(said, QStringList({"gripped", "pulled"}));
  EXPECT_GT((pulled_to - gripped_at).norm(), 0.002);
  release(at + QPoint(20, 10));
  EXPECT_EQ(said, QStringList({"gripped", "pulled", "released"}));
  EXPECT_EQ(view.screenshot(), before) << "the camera stays where it is, and what moves is the next picture's business";
  move(at + QPoint(40, 10));
  EXPECT_EQ(said.size(), 3);
}

TEST_F(RobotViewTest, OtherPatchesAndOtherTimesAreNotGripped) {
  const QPoint at = onPatch();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(2, 2));
  view.setPicking(true);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
  view.setPicking(false);
  picture.movable.reset();
  view.setPicture(picture);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
  EXPECT_TRUE(said.isEmpty());
}

TEST_F(RobotViewTest, EscapeLetsGoOfThePatchThatIsPulled) {
  const QPoint at = onPatch();
  press(at);
  move(at + QPoint(20, 0));
  said.clear();
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(said, QStringList({"left"}));
  release(at + QPoint(20, 0));
  EXPECT_EQ(said, QStringList({"left"}));
}

TEST_F(RobotViewTest, KeysSlideAndTurnThePatchInAModeOfTheirOwn) {
  const QImage still = view.screenshot();
  view.setMoving(true);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_NEAR(way.norm(), 0.001, 1e-9);
  const Eigen::Vector3d right = way;
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_LT((way + right).norm(), 1e-9);
  QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(way.norm(), 0.010, 1e-9);
  EXPECT_NEAR(way.dot(right), 0, 1e-9);
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_NEAR(turn, 1 * kDegree, 1e-12);
  QTest::keyClick(&view, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_NEAR(turn, -10 * kDegree, 1e-12);
  EXPECT_EQ(view.screenshot(), still);
  QTest::keyClick(&view, Qt::Key_Return);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(said, QStringList({"laid", "left"}));

  view.setMoving(false);
  way.setZero();
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_TRUE(way.isZero()) << "the robot is turned";
  EXPECT_NE(view.screenshot(), still);
}

}  // namespace
}  // namespace hexoderm
