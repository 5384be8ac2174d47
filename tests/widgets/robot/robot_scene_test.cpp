#include "widgets/robot/robot_scene.h"

#include "hexoderm/util/units.h"
#include "tests/widgets/scene/patch_scene_test.h"

#include <vtkRendererCollection.h>

namespace hexoderm {
namespace {

constexpr double kBox_m = 0.2;

/// Two boxes side by side: link 0 about the base's origin, link 1 to its right.
class RobotSceneTest : public testing::Test {
 protected:
  RobotSceneTest() {
    window->SetOffScreenRendering(1);
    window->SetSize(kWidth, kHeight);
    window->SetDPI(72);
    scene.setColors(testColors(false));
    scene.attachTo(window);
    const TriangleMesh box = meshOfBox({kBox_m, kBox_m, kBox_m});
    picture.bodies = std::make_shared<const LinkBodies>(LinkBodies{box, box});
    picture.T_w_l = {SE3{}, SE3{rotationFromRpy({0, 0, kPi / 2}), {2 * kBox_m, 0, 0}}};
    picture.skin = shared(demoReconstruction());
  }

  vtkSmartPointer<vtkImageData> draw() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->Update();
    return filter->GetOutput();
  }
  vtkRenderer* renderer() { return window->GetRenderers()->GetFirstRenderer(); }
  /// The pixel at which a point of the base's frame is drawn.
  std::array<double, 2> pixelOf(const Eigen::Vector3d& x_w) {
    renderer()->SetWorldPoint(x_w.x(), x_w.y(), x_w.z(), 1);
    renderer()->WorldToDisplay();
    const double* display = renderer()->GetDisplayPoint();
    return {display[0], display[1]};
  }

  vtkNew<vtkRenderWindow> window;
  RobotScene scene;
  RobotPicture picture;
};

TEST_F(RobotSceneTest, APickedPointIsInTheFrameOfItsLink) {
  scene.setPicture(picture);
  draw();
  for (std::size_t link = 0; link < 2; ++link) {
    SCOPED_TRACE(link);
    // The middle of the top, which the camera looks down on.
    const Eigen::Vector3d top_w = picture.T_w_l[link].t + Eigen::Vector3d(0, 0, kBox_m / 2);
    const auto [x, y] = pixelOf(top_w);
    const auto picked = scene.pick(x, y);
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->link, link);
    const Eigen::Vector3d expected = picture.T_w_l[link].inverse() * top_w;
    EXPECT_LT((picked->x_l - expected).norm(), 0.005) << "within a pixel";
  }
  EXPECT_FALSE(scene.pick(1, 1)) << "beside the robot";
}

TEST_F(RobotSceneTest, CellsAreDrawnOnTheLinkThatTheirPatchIsOn) {
  scene.setPicture(picture);
  EXPECT_EQ(scene.cellsDrawn(), 0U) << "nothing is placed yet";
  const auto bare = draw();
  RobotPicture placed = picture;
  placed.patches = {{0, 0, SE3{Eigen::Matrix3d::Identity(), {0, 0, kBox_m / 2}}, false}};
  scene.setPicture(placed);
  EXPECT_EQ(scene.cellsDrawn(), 17U);
  const auto with_skin = draw();
  EXPECT_GT(differingShare(bare, with_skin), 0.01);
  placed.patches[0].is_proposal = true;
  scene.setPicture(placed);
  EXPECT_GT(differingShare(with_skin, draw()), 0.005) << "what nobody has chosen looks otherwise";
  placed.patches[0].link = 7;
  scene.setPicture(placed);
  EXPECT_EQ(scene.cellsDrawn(), 0U) << "a link that is not there";
}

TEST_F(RobotSceneTest, WaysInWhichAPatchCanBeMovedAreArrows) {
  RobotPicture placed = picture;
  placed.patches = {{0, 0, SE3{Eigen::Matrix3d::Identity(), {0, 0, kBox_m / 2}}, false}};
  scene.setPicture(placed);
  const auto without = draw();
  FreeDirection free;
  free.shift_m = Eigen::Vector3d::UnitX();
  for (int k = -5; k <= 5; ++k) {
    SE3 T = placed.patches[0].T_l_o;
    T.t.x() += 0.015 * k;
    free.way.push_back(T);
  }
  placed.free = {{placed.patches[0], free}};
  scene.setPicture(placed);
  const auto with_arrow = draw();
  EXPECT_GT(differingShare(without, with_arrow), 0.001);
  // Where no way was followed, a short arrow gives the direction.
  placed.free[0].direction.way.clear();
  scene.setPicture(placed);
  EXPECT_GT(differingShare(without, draw()), 0.0005);
}

TEST_F(RobotSceneTest, KnownPointsAreSeenAndTheLinkThatIsSpokenOfStandsOut) {
  scene.setPicture(picture);
  const auto plain = draw();
  RobotPicture other = picture;
  other.link = 1;
  scene.setPicture(other);
  const auto link = draw();
  EXPECT_GT(differingShare(plain, link), 0.02);
  other.points = {{1, Eigen::Vector3d(0, 0, kBox_m / 2)}};
  scene.setPicture(other);
  EXPECT_GT(differingShare(link, draw()), 0.0002);
}

TEST_F(RobotSceneTest, TheCameraStaysWhereItIsUntilThereIsAnotherRobot) {
  scene.setPicture(picture);
  draw();
  scene.turn(30, 10);
  scene.zoom(1.2);
  std::array<double, 3> before{};
  renderer()->GetActiveCamera()->GetPosition(before.data());
  RobotPicture moved = picture;
  moved.T_w_l[1].t.z() = 0.1;
  scene.setPicture(moved);
  draw();
  std::array<double, 3> after{};
  renderer()->GetActiveCamera()->GetPosition(after.data());
  EXPECT_EQ(after, before);
  moved.bodies = std::make_shared<const LinkBodies>(*picture.bodies);
  scene.setPicture(moved);
  draw();
  renderer()->GetActiveCamera()->GetPosition(after.data());
  EXPECT_NE(after, before);
}

}  // namespace
}  // namespace hexoderm
