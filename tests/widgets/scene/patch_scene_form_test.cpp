// What helps to see the form: IDs on the cells, backs, directions to look from, the cut, and fitting all that is drawn.
#include "tests/widgets/scene/patch_scene_test.h"

#include "widgets/scene/label_choice.h"
#include "widgets/scene/scene_corners.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>

namespace hexoderm {
namespace {

using View = PatchScene::View;

class PatchSceneFormTest : public PatchSceneTest {
 protected:
  void look(View from) {
    scene.showStandardView(from);
    window->Render();
  }
  [[nodiscard]] Eigen::Vector3d towardsViewer() const {
    return -Eigen::Vector3d(scene.renderer()->GetActiveCamera()->GetDirectionOfProjection());
  }
  /// A pixel of the axes' corner that stands for this view.
  std::optional<std::array<int, 2>> knobOf(View view) const {
    for (int y = 0; y < SceneCorners::kBottom + SceneCorners::kSize; ++y) {
      for (int x = 0; x < SceneCorners::kLeft + SceneCorners::kSize; ++x) {
        if (scene.viewAt(x, y) == view) return std::array{x, y};
      }
    }
    return std::nullopt;
  }
  /// Of all that is drawn in the scene itself.
  std::size_t pointsBesideTheWindow() {
    std::size_t outside = 0;
    vtkActorCollection* actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
      if (actor->GetVisibility() == 0 || !actor->GetUseBounds()) continue;
      vtkDataSet* data = actor->GetMapper()->GetInput();
      for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) {
        const auto [x, y] = pixelOf(Eigen::Vector3d(data->GetPoint(k)));
        outside += x < 0 || x > kWidth || y < 0 || y > kHeight;
      }
    }
    return outside;
  }
};

TEST_F(PatchSceneFormTest, CellsOfALargeSkinHaveIdsWhereTheyAreNear) {
  scene.setTextVisible(true);
  scene.setReconstruction(shared(cylinderSheet(125, 80)));
  look(View::Front);
  EXPECT_TRUE(scene.labelledCells().empty()) << "a cell is a few pixels large";
  scene.renderer()->GetActiveCamera()->Zoom(12);
  const auto with = picture();
  const auto cells = scene.labelledCells();
  EXPECT_GT(cells.size(), 10U);
  EXPECT_LE(cells.size(), LabelChoice::kMax);
  scene.setShown(SceneItem::Ids, false);
  EXPECT_GT(differingShare(with, picture()), 0.005) << "they are drawn";
  EXPECT_TRUE(scene.labelledCells().empty());
}

TEST_F(PatchSceneFormTest, TheBackOfACellDoesNotLookLikeItsFront) {
  constexpr QRect kMiddle(kWidth / 4, kHeight / 4, kWidth / 2, kHeight / 2);
  // From right in front and right behind, where the light is the same.
  scene.setReconstruction(shared(sheetReconstruction(5, 4)));
  scene.setShown(SceneItem::Ports, false);
  scene.setParallel(true);
  scene.showStandardView(View::Front);
  const auto front = picture();
  scene.renderer()->GetActiveCamera()->Azimuth(180);
  EXPECT_GT(differingShare(front, picture(), kChannelSlack, kMiddle), 0.6);
}

TEST_F(PatchSceneFormTest, IsLookedAtFromBehindAndFromBetweenTheAxes) {
  scene.setReconstruction(shared(demoReconstruction()));
  const std::vector<std::pair<View, Eigen::Vector3d>> expected = {
      {View::Front, Eigen::Vector3d::UnitZ()},     {View::Back, -Eigen::Vector3d::UnitZ()},
      {View::Side, Eigen::Vector3d::UnitX()},      {View::OtherSide, -Eigen::Vector3d::UnitX()},
      {View::Top, Eigen::Vector3d::UnitY()},       {View::Bottom, -Eigen::Vector3d::UnitY()},
      {View::Isometric, Eigen::Vector3d(1, 1, 1)},
  };
  look(View::Oblique);
  EXPECT_EQ(pointsBesideTheWindow(), 0U);
  for (const auto& [view, from] : expected) {
    look(view);
    EXPECT_NEAR(towardsViewer().dot(from.normalized()), 1, 1e-9) << static_cast<int>(view);
    EXPECT_EQ(pointsBesideTheWindow(), 0U) << static_cast<int>(view);
  }
}

TEST_F(PatchSceneFormTest, AKnobOfTheAxesStandsForItsViewAndForTheOppositeOneWhenThatIsShown) {
  scene.setReconstruction(shared(demoReconstruction()));
  look(View::Isometric);
  for (const View view : {View::Front, View::Back, View::Side, View::OtherSide, View::Top, View::Bottom}) {
    EXPECT_TRUE(knobOf(view).has_value()) << static_cast<int>(view);
  }
  EXPECT_EQ(scene.viewAt(0.5 * kWidth, 0.5 * kHeight), std::nullopt);
  const auto knob = knobOf(View::Front);
  ASSERT_TRUE(knob);
  const auto calm = picture();
  EXPECT_TRUE(scene.hoverAxes((*knob)[0], (*knob)[1]));
  EXPECT_FALSE(scene.hoverAxes((*knob)[0], (*knob)[1])) << "nothing new";
  EXPECT_GT(differingShare(calm, picture()), 0);
  EXPECT_TRUE(scene.hoverAxes(-1, -1));
  EXPECT_EQ(differingShare(calm, picture()), 0);

  look(View::Front);
  EXPECT_TRUE(knobOf(View::Back).has_value()) << "from in front, the knob towards the viewer leads behind";
  EXPECT_FALSE(knobOf(View::Front).has_value());
  scene.setShown(SceneItem::Axes, false);
  window->Render();
  EXPECT_FALSE(knobOf(View::Back).has_value()) << "what is not drawn can't be clicked";
}

TEST_F(PatchSceneFormTest, ACutTakesAwayWhatIsInFrontAndIsPickedThrough) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[1].T_o_u = demo.patches[0].cells[0].T_o_u;
  demo.patches[0].cells[1].T_o_u.t.z() -= 0.02;  // cell 2 hides behind cell 1
  scene.setReconstruction(shared(demo));
  scene.showStandardView(View::Front);
  const auto whole = picture();
  const auto [x, y] = pixelOf(demo, CellId(1));
  scene.setCut(0);
  EXPECT_LE(differingShare(whole, picture()), kMaxDifferingShare);
  EXPECT_EQ(scene.pick(x, y), CellId(1));
  scene.setCut(0.25);
  EXPECT_GT(differingShare(whole, picture()), kMaxDifferingShare);
  EXPECT_EQ(scene.pick(x, y), CellId(2));
  scene.setCut(1);
  window->Render();
  EXPECT_EQ(scene.pick(x, y), std::nullopt);
  scene.setCut(std::nullopt);
  EXPECT_EQ(differingShare(whole, picture()), 0);
  EXPECT_EQ(scene.pick(x, y), CellId(1));
}

TEST_F(PatchSceneFormTest, ACutStaysWhereItIsUntilItIsTurnedToTheViewer) {
  scene.setReconstruction(shared(cylinderSheet(60, 40)));
  look(View::Front);
  scene.setCut(0.5);
  ASSERT_TRUE(scene.cut());
  EXPECT_NEAR(scene.cut()->normal.z(), 1, 1e-9);
  look(View::Side);
  scene.setCut(0.6);
  EXPECT_NEAR(scene.cut()->normal.z(), 1, 1e-9) << "it is looked at from the side";
  scene.alignCut();
  EXPECT_NEAR(scene.cut()->normal.x(), 1, 1e-9);
  scene.setReconstruction(nullptr);
  window->Render();
  EXPECT_FALSE(scene.cut());
  scene.setReconstruction(shared(demoReconstruction()));
  window->Render();
  EXPECT_TRUE(scene.cut()) << "another skin is cut too";
}

TEST_F(PatchSceneFormTest, FitTakesInAllThatIsDrawnAndGoesBackWhenItIsGone) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  look(View::Front);
  const auto before = cameraPosition();
  EXPECT_EQ(pointsBesideTheWindow(), 0U);
  // Differences as long as the patch, drawn enlarged.
  Reconstruction moved = demo;
  for (CellPlacement& cell : moved.patches[0].cells) cell.T_o_u.t *= 2.5;
  overlays.comparison = shared(compareToReconstruction(demo, moved));
  scene.setOverlays(overlays);
  window->Render();
  EXPECT_NE(cameraPosition(), before);
  EXPECT_EQ(pointsBesideTheWindow(), 0U);
  scene.setShown(SceneItem::Comparison, false);
  window->Render();
  EXPECT_EQ(cameraPosition(), before);
  // A camera that was moved by hand stays, until it is asked to fit.
  scene.renderer()->GetActiveCamera()->Azimuth(10);
  const auto turned = cameraPosition();
  scene.setShown(SceneItem::Comparison, true);
  window->Render();
  EXPECT_EQ(cameraPosition(), turned);
  EXPECT_GT(pointsBesideTheWindow(), 0U);
  scene.fit();
  window->Render();
  EXPECT_EQ(pointsBesideTheWindow(), 0U);
}

TEST_F(PatchSceneFormTest, ACellIsBroughtIntoTheMiddleWithoutTurning) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  look(View::Front);
  const Eigen::Vector3d back = towardsViewer();
  const double distance = scene.renderer()->GetActiveCamera()->GetDistance();
  scene.centerOn(CellId(15));
  window->Render();
  EXPECT_NEAR(towardsViewer().dot(back), 1, 1e-12);
  EXPECT_NEAR(scene.renderer()->GetActiveCamera()->GetDistance(), distance, 1e-9);
  EXPECT_NEAR(pixelOf(demo, CellId(15))[0], 0.5 * kWidth, 1);
  const auto centred = cameraPosition();
  scene.centerOn(CellId(999));
  EXPECT_EQ(cameraPosition(), centred);
}

}  // namespace
}  // namespace hexoderm
