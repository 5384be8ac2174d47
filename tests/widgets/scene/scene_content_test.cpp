// Where patches are drawn that are not placed against each other.
#include "widgets/scene/scene_content.h"

#include "hexoderm/solve/metrics/patch_mesh.h"
#include "tests/widgets/scene/patch_scene_test.h"
#include "widgets/scene/overlay_meshes.h"

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

DemoOptions armed(std::uint32_t first_id, std::uint32_t arm_cells) {
  DemoOptions options;
  options.first_id = first_id;
  options.arm_cells = arm_cells;
  return options;
}

/// A small patch, a large one, and single cells.
Reconstruction scattered(std::uint32_t lonely) {
  std::vector<DemoOptions> patches = {armed(1, 1), armed(101, 4)};
  for (std::uint32_t k = 0; k < lonely; ++k) patches.push_back(armed(1000 + k, 0));
  return demoPatches(patches);
}

void expectApart(const SceneLayout& layout) {
  for (std::size_t a = 0; a < layout.boxes.size(); ++a) {
    ASSERT_FALSE(layout.boxes[a].isEmpty());
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_FALSE(layout.boxes[a].intersects(layout.boxes[b])) << "patches " << a << " and " << b;
    }
  }
}

TEST(SceneLayout, TheLargestPatchLiesInItsOwnFrameAndNoOtherMeetsIt) {
  const Reconstruction skin = scattered(5);
  const auto content = makeSceneContent(shared(skin));
  const SceneLayout& layout = content->layout;
  EXPECT_EQ(layout.largest, 1U);
  EXPECT_TRUE(layout.shifts[1].isZero(0));
  EXPECT_THAT(layout.notPlaced(), ElementsAre(0, 2, 3, 4, 5, 6));
  expectApart(layout);
}

TEST(SceneLayout, PointsBoxesAndPlacementsOfACellAgree) {
  const Reconstruction skin = scattered(3);
  const SceneLayout layout = makeSceneContent(shared(skin))->layout;
  ASSERT_EQ(layout.cells.size(), skin.cellCount());
  for (std::size_t k = 0; k < layout.cells.size(); ++k) {
    const SceneCell& cell = layout.cells[k];
    const CellPlacement& placed = *skin.find(cell.id).cell;
    EXPECT_EQ(cell.T_s_u.R, placed.T_o_u.R) << "patches are moved, and not turned";
    EXPECT_LT((cell.T_s_u.t - placed.T_o_u.t - layout.shifts[cell.patch]).norm(), 1e-12);
    const auto corners = prismCorners(*skin.model, cell.T_s_u);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Eigen::Vector3d& point = layout.points[corners.size() * k + c];
      EXPECT_LT((point - corners.at(c)).norm(), 1e-12) << cell.id;
      EXPECT_LT(layout.boxes[cell.patch].exteriorDistance(point), 1e-12) << cell.id;
    }
  }
}

TEST(SceneLayout, ManyPatchesStandCloseTogetherAndTheSameEachTime) {
  const Reconstruction skin = scattered(300);
  const SceneLayout layout = makeSceneContent(shared(skin))->layout;
  expectApart(layout);
  Eigen::AlignedBox3d all;
  for (const Eigen::AlignedBox3d& box : layout.boxes) all.extend(box);
  EXPECT_LT(all.sizes().x(), 3 * all.sizes().y()) << "no endless row";
  const SceneLayout again = makeSceneContent(shared(skin))->layout;
  for (std::size_t p = 0; p < layout.shifts.size(); ++p) EXPECT_EQ(layout.shifts[p], again.shifts[p]);
}

TEST(SceneLayout, OnePatchOrNoneNeedsNoPlace) {
  const SceneLayout one = makeSceneContent(shared(demoReconstruction()))->layout;
  EXPECT_TRUE(one.shifts.at(0).isZero(0));
  EXPECT_THAT(one.notPlaced(), IsEmpty());
  EXPECT_THAT(makeSceneContent(shared(demoPatches({})))->layout.notPlaced(), IsEmpty());
}

TEST(PatchFrames, StandAboutThePatchesThatAreNotPlacedAlone) {
  const auto content = makeSceneContent(shared(scattered(1)));
  const auto frames = makePatchFrames(*content, {2});
  EXPECT_GT(frames->GetNumberOfLines(), 24) << "dashes";
  const double* bounds = frames->GetBounds();
  const Eigen::AlignedBox3d drawn(Eigen::Vector3d(bounds[0], bounds[2], bounds[4]),
                                  Eigen::Vector3d(bounds[1], bounds[3], bounds[5]));
  EXPECT_TRUE(drawn.contains(content->layout.boxes[2]));
  EXPECT_FALSE(drawn.intersects(content->layout.boxes[0]));
  EXPECT_FALSE(drawn.intersects(content->layout.boxes[1]));
}

TEST_F(PatchSceneTest, PatchesThatAreNotPlacedAreFramedAndNamed) {
  scene.setReconstruction(shared(demoReconstruction()));
  EXPECT_THAT(scene.notes().not_placed, IsEmpty());
  EXPECT_FALSE(scene.notes().frames);
  scene.setReconstruction(shared(scattered(1)));
  picture();
  EXPECT_THAT(scene.notes().not_placed, ElementsAre(CellId(1), CellId(1000)));
  EXPECT_TRUE(scene.notes().frames);
  scene.setReconstruction(shared(scattered(300)));
  EXPECT_EQ(scene.notes().not_placed.size(), 301U);
  EXPECT_FALSE(scene.notes().frames) << "too many to be told apart";
}

TEST_F(PatchSceneTest, NoLineIsDrawnBetweenCellsOfTwoPatches) {
  scene.setReconstruction(shared(scattered(0)));
  scene.showStandardView(PatchScene::View::Front);
  const auto between = [&](CellId a, CellId b) {
    const SceneLayout& layout = scene.content()->layout;
    const auto pixel = pixelOf(0.5 * (layout.find(a)->T_s_u.t + layout.find(b)->T_s_u.t));
    return QRect(static_cast<int>(pixel[0]) - 3, static_cast<int>(pixel[1]) - 3, 7, 7);
  };
  const auto plain = picture();
  scene.setMeasured(CellId(117), CellId(114));
  EXPECT_GT(differingShare(plain, picture(), kChannelSlack, between(CellId(117), CellId(114))), 0);
  scene.setMeasured(CellId(101), CellId(1));
  const auto across = picture();
  EXPECT_EQ(differingShare(plain, across, kChannelSlack, between(CellId(101), CellId(1))), 0);
  EXPECT_GT(differingShare(plain, across), 0) << "both are outlined";
}

TEST_F(PatchSceneTest, CellsOfEveryPatchArePickedWhereTheyAreDrawn) {
  scene.setReconstruction(shared(scattered(2)));
  scene.showStandardView(PatchScene::View::Front);
  window->Render();
  for (const SceneCell& cell : scene.content()->layout.cells) {
    if (!cell.origin) continue;
    const auto [x, y] = pixelOf(cell.T_s_u.t);
    EXPECT_EQ(scene.pick(x, y), cell.id);
  }
}

}  // namespace
}  // namespace hexoderm
