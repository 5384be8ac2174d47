#include "widgets/robot/robot_scene.h"

#include "tests/widgets/scene/patch_scene_test.h"

namespace hexoderm {
namespace {

constexpr double kBox_m = 0.2;
/// Of a bent patch, so that none of its cells is inside the box.
constexpr double kAbove_m = kBox_m / 2 + 0.06;
/// One colour against the next, in one and the same light.
constexpr int kShade = 8;
constexpr int kPixels = kWidth * kHeight;

/// Two boxes side by side: link 0 about the base's origin, link 1 to its right.
class RobotSceneTest : public OffScreenTest {
 protected:
  RobotSceneTest() {
    scene.setColors(testColors(false));
    scene.attachTo(window);
    const TriangleMesh box = meshOfBox({kBox_m, kBox_m, kBox_m});
    robot.bodies = std::make_shared<const LinkBodies>(LinkBodies{box, box});
    robot.T_w_l = {SE3{}, SE3{rotationFromRpy({0, 0, kPi / 2}), {2 * kBox_m, 0, 0}}};
    robot.skin = shared(demoReconstruction());
  }

  RobotScene scene;
  RobotPicture robot;
};

TEST_F(RobotSceneTest, APickedPointIsInTheFrameOfItsLink) {
  scene.setPicture(robot);
  window->Render();
  for (std::size_t link = 0; link < 2; ++link) {
    SCOPED_TRACE(link);
    // The middle of the top, which the camera looks down on.
    const Eigen::Vector3d top_w = robot.T_w_l[link].t + Eigen::Vector3d(0, 0, kBox_m / 2);
    const auto [x, y] = pixelOf(top_w);
    const auto picked = scene.pick(x, y);
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->link, link);
    const Eigen::Vector3d expected = robot.T_w_l[link].inverse() * top_w;
    EXPECT_LT((picked->x_l - expected).norm(), 0.005) << "within a pixel";
  }
  EXPECT_FALSE(scene.pick(1, 1)) << "beside the robot";
}

TEST_F(RobotSceneTest, CellsAreDrawnOnTheLinkThatTheirPatchIsOn) {
  scene.setPicture(robot);
  EXPECT_EQ(scene.cellsDrawn(), 0U) << "nothing is placed yet";
  const auto bare = picture();
  RobotPicture placed = robot;
  placed.patches = {{0, 0, SE3{Eigen::Matrix3d::Identity(), {0, 0, kAbove_m}}, false}};
  scene.setPicture(placed);
  EXPECT_EQ(scene.cellsDrawn(), 17U);
  const auto with_skin = picture();
  EXPECT_GT(differingShare(bare, with_skin, kShade), 0.005);
  placed.patches[0].is_proposal = true;
  scene.setPicture(placed);
  EXPECT_GT(differingShare(with_skin, picture(), kShade), 0.003) << "what nobody has chosen looks otherwise";
  placed.patches[0].link = 7;
  scene.setPicture(placed);
  EXPECT_EQ(scene.cellsDrawn(), 0U) << "a link that is not there";
}

TEST_F(RobotSceneTest, WaysInWhichAPatchCanBeMovedAreArrows) {
  RobotPicture placed = robot;
  placed.patches = {{0, 0, SE3{Eigen::Matrix3d::Identity(), {0, 0, kAbove_m}}, false}};
  scene.setPicture(placed);
  scene.lookAtSkin(0);
  const auto without = picture();
  FreeDirection free;
  free.shift_m = Eigen::Vector3d::UnitX();
  for (int k = -5; k <= 5; ++k) {
    SE3 T = placed.patches[0].T_l_o;
    T.t.x() += 0.015 * k;
    free.way.push_back(T);
  }
  placed.free = {{placed.patches[0], free}};
  scene.setPicture(placed);
  const auto with_arrow = picture();
  EXPECT_GT(differingShare(without, with_arrow), 0.001);
  // Where no way was followed, a short arrow gives the direction.
  placed.free[0].direction.way.clear();
  scene.setPicture(placed);
  EXPECT_GT(kPixels * differingShare(without, picture()), 20);
}

TEST_F(RobotSceneTest, KnownPointsAreSeenAndTheLinkThatIsSpokenOfStandsOut) {
  scene.setPicture(robot);
  const auto plain = picture();
  RobotPicture other = robot;
  other.link = 1;
  scene.setPicture(other);
  const auto link = picture();
  EXPECT_GT(differingShare(plain, link, kShade), 0.02);
  other.points = {{1, Eigen::Vector3d(0, 0, kBox_m / 2)}};
  scene.setPicture(other);
  EXPECT_GT(kPixels * differingShare(link, picture(), kShade), 10);
}

TEST_F(RobotSceneTest, TheCameraStaysWhereItIsUntilThereIsAnotherRobot) {
  scene.setPicture(robot);
  window->Render();
  scene.turn(30, 10);
  scene.zoom(1.2);
  const auto before = cameraPosition();
  RobotPicture moved = robot;
  moved.T_w_l[1].t.z() = 0.1;
  scene.setPicture(moved);
  window->Render();
  EXPECT_EQ(cameraPosition(), before);
  moved.bodies = std::make_shared<const LinkBodies>(*robot.bodies);
  scene.setPicture(moved);
  window->Render();
  EXPECT_NE(cameraPosition(), before);
}

TEST_F(RobotSceneTest, APatchIsGrippedAtThePointOfItsLinkThatLiesBelow) {
  RobotPicture placed = robot;
  placed.patches = {{0, 1, SE3{Eigen::Matrix3d::Identity(), {0, 0, kBox_m / 2 + 0.003}}, false}};
  scene.setPicture(placed);
  window->Render();
  const CellPlacement& cell = placed.skin->patches[0].cells[0];
  const Eigen::Vector3d front_w = placed.T_w_l[1] * placed.patches[0].T_l_o * cell.T_o_u.t;
  const auto [x, y] = pixelOf(front_w);
  const auto grip = scene.grip(x, y);
  ASSERT_TRUE(grip);
  EXPECT_EQ(grip->patch, 0U);
  EXPECT_LT((placed.T_w_l[1] * grip->x_l - front_w).norm(), 0.02) << "a line of sight that is oblique";
  EXPECT_FALSE(scene.grip(1, 1)) << "beside the robot";
  const auto [other_x, other_y] = pixelOf(Eigen::Vector3d(0, 0, kBox_m / 2));
  EXPECT_FALSE(scene.grip(other_x, other_y)) << "a link without skin";
  EXPECT_TRUE(scene.pick(x, y)) << "points of the link are picked through the skin as before";
}

TEST_F(RobotSceneTest, WaysOnTheScreenAreGivenInTheFrameOfTheLink) {
  scene.setPicture(robot);
  window->Render();
  for (std::size_t link = 0; link < 2; ++link) {
    SCOPED_TRACE(link);
    const Eigen::Vector3d from_w = robot.T_w_l[link].t;
    const auto [x, y] = pixelOf(from_w);
    const auto after = [&](double right_m, double up_m) {
      return pixelOf(from_w + robot.T_w_l[link].R * scene.wayOnScreen(right_m, up_m, link));
    };
    const auto right = after(0.01, 0);
    EXPECT_GT(right[0], x + 1);
    EXPECT_NEAR(right[1], y, 0.5);
    const auto up = after(0, 0.01);
    EXPECT_GT(up[1], y + 1);
    EXPECT_NEAR(up[0], x, 0.5);
    EXPECT_NEAR(scene.wayOnScreen(0.003, 0.004, link).norm(), 0.005, 1e-12);
  }
}

TEST_F(RobotSceneTest, TheSkinIsLookedAtSoCloselyThatItsNumbersCanBeRead) {
  RobotPicture placed = robot;
  placed.patches = {{0, 1, SE3{Eigen::Matrix3d::Identity(), {0, 0, kBox_m / 2 + 0.003}}, false}};
  scene.setPicture(placed);
  window->Render();
  const auto pixelsPerSide = [&] {
    const SE3 T_w_u = placed.T_w_l[1] * placed.patches[0].T_l_o * placed.skin->patches[0].cells[0].T_o_u;
    const auto a = pixelOf(T_w_u.t);
    const auto b = pixelOf(T_w_u * Eigen::Vector3d(placed.skin->model->side_m, 0, 0));
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  const double before = pixelsPerSide();
  scene.lookAtSkin(0);
  window->Render();
  EXPECT_GT(pixelsPerSide(), 1.5 * before);
  for (const CellPlacement& cell : placed.skin->patches[0].cells) {
    const auto [x, y] = pixelOf(placed.T_w_l[1] * placed.patches[0].T_l_o * cell.T_o_u.t);
    EXPECT_TRUE(x > 0 && x < kWidth && y > 0 && y < kHeight) << "cell " << cell.cell << " is not seen";
  }
  // Of a patch that is not drawn nothing can be looked at.
  const double near = pixelsPerSide();
  scene.lookAtSkin(5);
  window->Render();
  EXPECT_DOUBLE_EQ(pixelsPerSide(), near);
  scene.fit();
  window->Render();
  EXPECT_NEAR(pixelsPerSide(), before, 0.01 * before);
}

}  // namespace
}  // namespace hexoderm
