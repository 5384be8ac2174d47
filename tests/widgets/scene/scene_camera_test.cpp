// From where the scene is seen, and what lies under a pixel.
#include "tests/widgets/scene/patch_scene_test.h"

#include "widgets/scene/scene_corners.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>

namespace hexoderm {
namespace {

TEST_F(PatchSceneTest, LargeSkinShowsShadedCellsFromBehindAndCanBePickedThere) {
  const Reconstruction sheet = sheetReconstruction(60, 50);
  scene.setReconstruction(shared(sheet));
  scene.setShown(SceneItem::Gravity, false);
  scene.setShown(SceneItem::Axes, false);
  setSmoothed(*window, false);
  scene.showStandardView(PatchScene::View::Front);
  const CellId middle(30 + 60 * 25);
  const auto colourOf = [&](const QImage& image) {
    const auto [x, y] = pixelOf(sheet, middle);
    return image.pixelColor(static_cast<int>(x), static_cast<int>(y));
  };
  const auto front = colourOf(picture());
  scene.renderer()->GetActiveCamera()->Azimuth(180);
  const auto behind = colourOf(picture());
  // Darker and greyed: value is the largest channel, saturation the spread of all in proportion to it.
  const auto spread = [](const QColor& color) { return color.value() * color.saturationF(); };
  EXPECT_LT(spread(behind), 0.6 * spread(front));
  EXPECT_LT(behind.value(), 0.8 * front.value());
  const auto [x, y] = pixelOf(sheet, middle);
  EXPECT_EQ(scene.pick(x, y), middle);
}

TEST_F(PatchSceneTest, CellsOfAPixelAreDrawnAsBricksThatLookTheSame) {
  const auto sheet = shared(sheetReconstruction(300, 220));
  const auto content = makeSceneContent(sheet);
  ASSERT_EQ(content->bricks->GetNumberOfPoints(), 4 * 300 * 220);
  const auto pointsDrawn = [&] {
    vtkIdType most = 0;
    vtkActorCollection* actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
      if (actor->GetVisibility() != 0) most = std::max(most, actor->GetMapper()->GetInput()->GetNumberOfPoints());
    }
    return most;
  };
  const auto middleOf = [](const QImage& image) {
    double sum = 0;
    for (int y = kHeight / 2 - 30; y < kHeight / 2 + 30; ++y) {
      for (int x = kWidth / 2 - 30; x < kWidth / 2 + 30; ++x) sum += qGreen(image.pixel(x, y));
    }
    return sum / 3600;
  };
  scene.setContent(content);
  setSmoothed(*window, false);
  scene.showStandardView(PatchScene::View::Front);
  const double far = middleOf(picture());
  EXPECT_EQ(pointsDrawn(), 4 * 300 * 220);
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  camera->Dolly(40);
  const double near = middleOf(picture());
  EXPECT_EQ(pointsDrawn(), 6 * 300 * 220);
  EXPECT_NEAR(far, near, 12);
  // Colours reach what is drawn, whichever it is.
  scene.setColoring(Coloring::Patch);
  const double recoloured = middleOf(picture());
  camera->Dolly(1.0 / 40);
  EXPECT_NEAR(middleOf(picture()), recoloured, 12);
  EXPECT_GT(std::abs(recoloured - near), 12);
  scene.setParallel(true);
  picture();
  EXPECT_EQ(pointsDrawn(), 4 * 300 * 220);
  camera->Zoom(40);
  picture();
  EXPECT_EQ(pointsDrawn(), 6 * 300 * 220);
}

TEST_F(PatchSceneTest, ParallelProjectionKeepsTheSizeAndFits) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  scene.showStandardView(PatchScene::View::Top);
  const auto perspective = picture();
  scene.setParallel(true);
  EXPECT_GT(differingShare(perspective, picture()), kMaxDifferingShare);
  for (const CellPlacement& cell : demo.patches[0].cells) {
    const auto [x, y] = pixelOf(demo, cell.cell);
    EXPECT_THAT(x, testing::AllOf(testing::Gt(0), testing::Lt(kWidth)));
    EXPECT_THAT(y, testing::AllOf(testing::Gt(0), testing::Lt(kHeight)));
  }
  const auto [x, y] = pixelOf(demo, CellId(6));
  EXPECT_EQ(scene.pick(x, y), CellId(6));
  scene.setParallel(false);
  EXPECT_EQ(differingShare(perspective, picture()), 0);

  // A scene that is turned by hand keeps its scale.
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  camera->Azimuth(20);
  camera->Dolly(1.5);
  const double distance = camera->GetDistance();
  scene.setParallel(true);
  window->Render();
  scene.setParallel(false);
  window->Render();
  EXPECT_NEAR(camera->GetDistance(), distance, 1e-9);
}

TEST_F(PatchSceneTest, TheCameraMovesForAnotherShapeAndOtherCellsUntilItIsMovedByHand) {
  const Reconstruction demo = demoReconstruction();
  const auto scaled = [&demo](double factor) {
    Reconstruction other = demo;
    for (CellPlacement& cell : other.patches[0].cells) cell.T_o_u.t *= factor;
    return other;
  };
  const auto first = cameraFor(demo);
  EXPECT_EQ(cameraFor(scaled(1.02)), first) << "a new pose's small changes don't make the picture jump";
  EXPECT_NE(cameraFor(scaled(1.3)), first);
  const auto fitted = cameraFor(demo);
  DemoOptions shorter;
  shorter.arm_cells = 2;
  EXPECT_NE(cameraFor(demoReconstruction(shorter)), fitted);
  cameraFor(demo);
  scene.renderer()->GetActiveCamera()->Azimuth(30);
  const auto turned = cameraPosition();
  Reconstruction changed = demo;
  changed.patches[0].cells[1].T_o_u.t.z() += 0.05;
  changed.patches[0].links[0].quality = EdgeQuality::Over;
  EXPECT_EQ(cameraFor(changed), turned);
}

TEST_F(PatchSceneTest, FitsAgainWhenThePatchLeavesThePicture) {
  const Reconstruction demo = demoReconstruction();
  const auto movedBy = [&demo](double up_m) {
    Reconstruction moved = demo;
    for (CellPlacement& cell : moved.patches[0].cells) cell.T_o_u.t.y() += up_m;
    return moved;
  };
  for (const bool parallel : {false, true}) {
    scene.setParallel(parallel);
    cameraFor(movedBy(0));
    scene.showStandardView(PatchScene::View::Front);
    const auto fitted = cameraFor(movedBy(0));
    EXPECT_EQ(cameraFor(movedBy(0.001)), fitted) << "it would jump with every pose";
    EXPECT_NEAR(cameraFor(movedBy(0.05)).at(1), fitted.at(1) + 0.05, 1e-9);
  }
}

TEST_F(PatchSceneTest, FitsAgainInAResizedWindowUntilTheCameraIsMoved) {
  const auto wide = cameraFor(demoReconstruction());
  window->SetSize(kWidth / 3, kHeight);
  window->Render();
  const auto narrow = cameraPosition();
  EXPECT_NE(narrow, wide);
  scene.renderer()->GetActiveCamera()->Azimuth(10);
  const auto moved = cameraPosition();
  window->SetSize(kWidth, kHeight);
  window->Render();
  EXPECT_EQ(cameraPosition(), moved);
}

TEST_F(PatchSceneTest, FitKeepsTheCellsOffTheArrowOfGravity) {
  const Reconstruction sheet = sheetReconstruction(4, 20);  // from the upper left to the lower right
  const auto cellsUnderTheArrow = [&] {
    window->Render();
    std::size_t cells = 0;
    for (const CellPlacement& cell : sheet.patches[0].cells) {
      const auto [x, y] = pixelOf(sheet, cell.cell);
      EXPECT_THAT(x, testing::AllOf(testing::Gt(0), testing::Lt(kWidth))) << "cell " << cell.cell;
      cells +=
          x > kWidth - SceneCorners::kRight - SceneCorners::kSize && y < SceneCorners::kBottom + SceneCorners::kSize;
    }
    return cells;
  };
  for (const bool parallel : {false, true}) {
    scene.setParallel(parallel);
    scene.setReconstruction(shared(sheet));
    scene.setShown(SceneItem::Gravity, false);
    scene.showStandardView(PatchScene::View::Front);
    EXPECT_GT(cellsUnderTheArrow(), 0U) << "where there is no arrow, they may be anywhere";
    scene.setShown(SceneItem::Gravity, true);
    scene.fit();
    EXPECT_EQ(cellsUnderTheArrow(), 0U);
  }
}

TEST_F(PatchSceneTest, APatchLiesBetweenWhatCoversTheTopAndTheBottomAlsoWhileItGrows) {
  constexpr int kAbove = 40;
  constexpr int kBelow = 80;
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  scene.showStandardView(PatchScene::View::Front);
  const auto reach = [&] {
    window->Render();
    double lowest = kHeight;
    double highest = 0;
    for (const Eigen::Vector3d& p : scene.content()->layout.points) {
      const double y = pixelOf(p)[1];
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
    return std::pair(lowest, highest);
  };
  EXPECT_LT(reach().first, kBelow) << "it has all the room at first";
  scene.setTopMargin(kAbove);
  scene.setBottomMargin(kBelow);
  EXPECT_GE(reach().first, kBelow - 0.5);
  for (int step = 0; step <= 20; ++step) {
    Reconstruction grown = demo;
    for (CellPlacement& cell : grown.patches[0].cells) cell.T_o_u.t.y() += 0.001 * step;
    scene.setReconstruction(shared(grown));
    EXPECT_LE(reach().second, kHeight - kAbove + 0.5) << "moved by " << step << " mm";
  }
}

TEST_F(PatchSceneTest, AfterThePartWasFollowedItIsSeenFromWhereItWasBefore) {
  scene.setReconstruction(shared(demoReconstruction()));
  scene.showStandardView(PatchScene::View::Top);
  window->Render();
  const auto before = picture();
  scene.keepView();
  moment.up_o = Eigen::Vector3d::UnitY();
  scene.setMoment(moment);
  moment.up_o = Eigen::Vector3d::UnitX();
  scene.setMoment(moment);
  EXPECT_GT(differingShare(before, picture()), kMaxDifferingShare);
  moment.up_o = std::nullopt;
  scene.setMoment(moment);
  scene.returnToKeptView();
  EXPECT_LE(differingShare(before, picture()), kMaxDifferingShare);
  const auto again = cameraPosition();
  scene.returnToKeptView();
  window->Render();
  EXPECT_EQ(cameraPosition(), again) << "nothing was kept";
}

}  // namespace
}  // namespace hexoderm
