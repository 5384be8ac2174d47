#include "hexoderm/base/se3.h"
#include "tests/support/picture_difference.h"
#include "tests/support/random_vector.h"
#include "tests/widgets/patch/patch_view_fixture.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/scene/scene_ghost.h"

#include <vtkCamera.h>
#include <random>

namespace hexoderm {
namespace {

/// A unit vector of the patch frame in the picture: right, up, towards the viewer.
Eigen::Vector3d inPicture(vtkCamera* camera, const Eigen::Vector3d& v) {
  const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
  camera->OrthogonalizeViewUp();
  const Eigen::Vector3d up = toEigen(camera->GetViewUp());
  return {up.cross(back).dot(v), up.dot(v), back.dot(v)};
}

TEST(PartCamera, UpStaysUpwardsFromAsFarAboveAndSpinningTurnsTheFrontToTheRight) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 1);
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  standCameraUpright(camera, up);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector3d next = test::randomVector([&] { return normal(random); }).normalized();
    turnCameraWithPart(camera, std::exchange(up, next), next);
    const Eigen::Vector3d seen = inPicture(camera, up);
    EXPECT_NEAR(seen.x(), 0, 1e-6);
    EXPECT_NEAR(toDegrees(std::asin(seen.z())), 20, 1e-4) << "elevation";
    EXPECT_GT(seen.y(), 0);
  }
  const Eigen::Vector3d right = rightInPicture(camera, up);
  const Eigen::Vector3d front = right.cross(up);
  EXPECT_NEAR(inPicture(camera, front).x(), 0, 1e-9);
  spinPartInPicture(camera, up, 30 * kDegree);
  EXPECT_NEAR(inPicture(camera, front).x(), 0.5, 1e-9);
  EXPECT_NEAR(inPicture(camera, up).x(), 0, 1e-9);
}

class PartMotionTest : public PatchViewFixture {
 protected:
  PartMotionTest() : PatchViewFixture({720, 560}) {}
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(PatchViewFixture::SetUp());
    view.setReconstruction(shared(demoReconstruction()));
    view.setAnimated(false);
  }
  void drag(const QPoint& by, Qt::KeyboardModifiers keys = {}, int steps = 10) {
    const QPoint from = canvas->rect().center();
    test::dragMouse(canvas, from, from + by, keys, Qt::LeftButton, steps);
  }
  /// Waits for a request, also for one that is still held back, that turns the part so far away from `up`.
  bool isAskedFor(double angle_deg, const Eigen::Vector3d& up, double tolerance_deg = 1.5) {
    return test::waitUntil([&] {
      return !asked.empty() && std::abs(toDegrees(angleBetween(asked.back(), up)) - angle_deg) < tolerance_deg;
    });
  }
  void turnTo(const Eigen::Vector3d& up_o) {
    moment.up_o = up_o;
    view.setMoment(moment);
  }
  void showNext(const std::optional<Eigen::Vector3d>& up_o) {
    moment.next_up_o = up_o;
    view.setMoment(moment);
  }
  QToolButton* turnButton() { return view.findChild<QToolButton*>("turnThePart"); }

  std::vector<Eigen::Vector3d> asked;
  QMetaObject::Connection kept =
      QObject::connect(&view, &PatchView::turnRequested, [this](const Eigen::Vector3d& up) { asked.push_back(up); });
};

TEST_F(PartMotionTest, GoingRoundAndBackGivesTheSamePicture) {
  turnTo(Eigen::Vector3d::UnitY());
  const QImage before = view.screenshot();
  // There and back again along the same way, in steps that are followed at once.
  for (int k = 1; k <= 12; ++k) turnTo(expSO3(5 * k * kDegree * Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitY());
  EXPECT_NE(view.screenshot(), before);
  for (int k = 11; k >= 0; --k) turnTo(expSO3(5 * k * kDegree * Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitY());
  EXPECT_LT(differingShare(view.screenshot(), before, 24) * before.width() * before.height(), 200) << "pixels";
}

TEST_F(PartMotionTest, TheGhostComesAndGoes) {
  turnTo(Eigen::Vector3d::UnitY());
  const QImage before = view.screenshot();
  showNext(Eigen::Vector3d::UnitX());
  const QImage ghost = view.screenshot();
  EXPECT_NE(ghost, before);
  const auto place = SceneGhost::placeIn(ghost.width(), ghost.height());
  const QRect there(static_cast<int>(place[0]), ghost.height() - static_cast<int>(place[3]),
                    static_cast<int>(place[2] - place[0]), static_cast<int>(place[3] - place[1]));
  EXPECT_NE(ghost.copy(there), before.copy(there));
  showNext(std::nullopt);
  const QImage gone = view.screenshot();
  EXPECT_EQ(gone.copy(there), before.copy(there));
  // A letter at the axes may be drawn a pixel beside its place, as rounding has it.
  EXPECT_LT(differingShare(gone, before, 24) * before.width() * before.height(), 60) << "pixels";
}

TEST_F(PartMotionTest, TheGhostShowsTheAxisItTurnsAbout) {
  turnTo(Eigen::Vector3d::UnitY());
  view.showStandardView(PatchView::StandardView::Front);
  const QImage before = view.screenshot();
  // About the picture's horizontal, of which the patch itself leaves the left end free.
  const auto changedAtTheLeftEnd = [&](const Eigen::Vector3d& next) {
    showNext(next);
    const QImage ghost = view.screenshot();
    const auto place = SceneGhost::placeIn(ghost.width(), ghost.height());
    const int middle = ghost.height() - static_cast<int>((place[1] + place[3]) / 2);
    const int from = static_cast<int>(place[0] + 0.05 * (place[2] - place[0]));
    constexpr int kPixels = 10 * 9;
    return kPixels * differingShare(ghost, before, 24, QRect(from, middle - 4, 10, 9));
  };
  EXPECT_GT(changedAtTheLeftEnd(Eigen::Vector3d::UnitZ()), 5);
  const Eigen::Vector3d nearly_there = expSO3(5 * kDegree * Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitY();
  EXPECT_EQ(changedAtTheLeftEnd(nearly_there), 0) << "there is nothing to turn about";
}

TEST_F(PartMotionTest, TheGhostTurnsAndThenRests) {
  turnTo(Eigen::Vector3d::UnitY());
  showNext(Eigen::Vector3d::UnitX());
  const QImage target = view.screenshot();
  view.setAnimated(true);
  EXPECT_TRUE(view.isAnimating());
  EXPECT_NE(view.screenshot(), target) << "it begins with the present orientation";
  EXPECT_TRUE(test::waitUntil([&] { return !view.isAnimating(); }));
  EXPECT_EQ(view.screenshot(), target);
}

TEST_F(PartMotionTest, NothingMovesWhileTheViewIsHiddenOrMotionIsUnwanted) {
  showNext(Eigen::Vector3d::UnitX());
  EXPECT_FALSE(view.isAnimating()) << "switched off";
  view.setAnimated(true);
  EXPECT_TRUE(view.isAnimating());
  view.hide();
  EXPECT_FALSE(view.isAnimating());
  view.show();
  EXPECT_TRUE(test::waitUntil([&] { return view.isAnimating(); }));
}

TEST_F(PartMotionTest, ALargeSkinGetsAnArrowInstead) {
  view.setReconstruction(shared(sheetReconstruction(50, 41)));
  ASSERT_TRUE(test::waitUntil([&] { return view.isUpToDate(); }));
  const QImage before = view.screenshot();
  showNext(Eigen::Vector3d::UnitX());
  EXPECT_NE(view.screenshot(), before);
}

TEST_F(PartMotionTest, DraggingInTurnModeAsksForTheTurnAndLeavesTheCameraAlone) {
  turnTo(Eigen::Vector3d::UnitY());
  view.setTurnable(true);
  ASSERT_TRUE(turnButton()->isVisible());
  QTest::mouseClick(turnButton(), Qt::LeftButton);
  const QImage before = view.screenshot();
  drag({0, canvas->height() / 4});
  EXPECT_TRUE(isAskedFor(45, Eigen::Vector3d::UnitY()));
  EXPECT_EQ(view.screenshot(), before) << "the picture waits for the part";
  EXPECT_EQ(selection.cell(), std::nullopt);
}

TEST_F(PartMotionTest, DraggingDownBringsTheUpperEdgeNearer) {
  turnTo(Eigen::Vector3d::UnitY());
  view.showStandardView(PatchView::StandardView::Front);
  ASSERT_FALSE(view.screenshot().isNull());
  view.setTurnable(true);
  drag({0, canvas->height() / 2}, Qt::ShiftModifier);
  // Seen from the front (+z), the upper edge (+y) has come to the viewer: -z, the back, points up now.
  EXPECT_TRUE(isAskedFor(0, -Eigen::Vector3d::UnitZ(), 5));
}

TEST_F(PartMotionTest, ShiftTurnsThePartWithoutTheModeAndPlainDraggingTurnsTheCamera) {
  turnTo(Eigen::Vector3d::UnitY());
  view.setTurnable(true);
  const QImage before = view.screenshot();
  drag({0, 60});
  EXPECT_TRUE(asked.empty());
  EXPECT_EQ(selection.cell(), std::nullopt);
  EXPECT_NE(view.screenshot(), before);
  drag({0, 60}, Qt::ShiftModifier);
  EXPECT_TRUE(test::waitUntil([&] { return !asked.empty(); }));
}

TEST_F(PartMotionTest, RequestsComeAtMostTwentyTimesASecondAndTheLastIsNotLost) {
  turnTo(Eigen::Vector3d::UnitY());
  view.setTurnable(true);
  QElapsedTimer clock;
  clock.start();
  drag({0, canvas->height() / 4}, Qt::ShiftModifier, 200);
  EXPECT_TRUE(isAskedFor(45, Eigen::Vector3d::UnitY()));
  EXPECT_LE(static_cast<qint64>(asked.size()), 2 + clock.elapsed() / 50);
}

TEST_F(PartMotionTest, ArrowKeysTurnThePartInTurnMode) {
  view.activateWindow();
  ASSERT_TRUE(test::waitUntilActive(view));
  turnTo(Eigen::Vector3d::UnitY());
  view.setTurnable(true);
  QTest::keyClick(&view, Qt::Key_Down);
  EXPECT_TRUE(asked.empty()) << "the mode is off";
  QTest::mouseClick(turnButton(), Qt::LeftButton);
  EXPECT_TRUE(view.hasFocus());
  for (int k = 0; k < 4; ++k) QTest::keyClick(&view, Qt::Key_Down);
  EXPECT_TRUE(isAskedFor(20, Eigen::Vector3d::UnitY(), 0.1));
  const QImage before = view.screenshot();
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_NE(view.screenshot(), before) << "about gravity the picture alone turns";
}

TEST_F(PartMotionTest, WhereNobodyObeysNothingCanBeTurned) {
  EXPECT_FALSE(turnButton()->isVisible());
  drag({0, 80}, Qt::ShiftModifier);
  EXPECT_TRUE(asked.empty());
}

}  // namespace
}  // namespace hexoderm
