// Objects of the scene, and their removal.

#include "tests/widgets/scene/patch_scene_test.h"
#include "hexoderm/solve/metrics/overlays.h"
#include "widgets/scene/patch_scene.h"

namespace hexoderm {
namespace {

GroundTruth truthOf(const Reconstruction& reconstruction) {
  GroundTruth truth;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) truth.cells.push_back({cell.cell, cell.T_o_u});
  }
  return truth;
}

TEST_F(PatchSceneTest, WhatIsSwitchedOffIsGone) {
  const Reconstruction demo = withUncertainties();
  scene.setReconstruction(shared(demo));
  overlays.truth = std::make_shared<const GroundTruth>(truthOf(roughened(0.003)));
  scene.setOverlays(overlays);
  const auto plain = picture();
  for (const SceneItem item : {SceneItem::Links, SceneItem::Tree, SceneItem::Ellipsoids, SceneItem::Truth,
                               SceneItem::Ports, SceneItem::Axes, SceneItem::Gravity}) {
    SCOPED_TRACE(static_cast<int>(item));
    EXPECT_EQ(scene.availability(item), Availability::Available);
    const bool shown = kShownAtFirst.at(indexOf(item));
    scene.setShown(item, !shown);
    EXPECT_GT(differingShare(plain, picture()), shown ? 0 : kMaxDifferingShare);
    scene.setShown(item, shown);
    EXPECT_EQ(differingShare(plain, picture()), 0);
  }
}

TEST_F(PatchSceneTest, ResultsAreDrawnUntilTheyAreTakenBack) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  const auto plain = picture();
  EXPECT_EQ(scene.availability(SceneItem::Loop), Availability::NoData);
  overlays.loop = shared(evaluateLoop(demo, {CellId(14), PortNumber(1)}, {CellId(17), PortNumber(4)}));
  scene.setOverlays(overlays);
  EXPECT_GT(differingShare(plain, picture()), 0.001);
  EXPECT_TRUE(scene.notes().loop_factor.has_value());
  overlays.loop = nullptr;
  scene.setOverlays(overlays);
  EXPECT_EQ(differingShare(plain, picture()), 0);

  overlays.comparison = shared(compareToReconstruction(demo, roughened(0.001)));
  scene.setOverlays(overlays);
  EXPECT_GT(differingShare(plain, picture()), 0.001);
  EXPECT_EQ(scene.notes().shift_factor, 10);
  overlays.comparison = nullptr;
  scene.setOverlays(overlays);
  EXPECT_EQ(differingShare(plain, picture()), 0);
  EXPECT_EQ(scene.notes().shift_factor, std::nullopt);

  scene.setMeasured(CellId(2), CellId(15));
  EXPECT_GT(differingShare(plain, picture()), 0.0005);
  scene.setMeasured(std::nullopt, std::nullopt);
  EXPECT_EQ(differingShare(plain, picture()), 0);
}

TEST_F(PatchSceneTest, ResultsAboutAnotherSkinAreNotDrawn) {
  DemoOptions other;
  other.first_id = 101;
  const Reconstruction before = demoReconstruction(other);
  scene.setReconstruction(shared(before));
  overlays.surface = shared(evaluateSurface(before.patches[0], SurfaceKind::Sphere));
  overlays.loop = shared(evaluateLoop(before, {CellId(114), PortNumber(1)}, {CellId(117), PortNumber(4)}));
  overlays.comparison = shared(compareToReconstruction(before, before));
  scene.setOverlays(overlays);
  picture();
  DemoOptions options;
  options.arm_cells = 0;
  scene.setReconstruction(shared(demoReconstruction(options)));
  EXPECT_EQ(scene.availability(SceneItem::Loop), Availability::NoData);
  picture();
  EXPECT_EQ(scene.notes().distance_factor, std::nullopt);
  scene.setReconstruction(nullptr);
  picture();
  EXPECT_EQ(scene.availability(SceneItem::Surface), Availability::NoSkin);
}

TEST_F(PatchSceneTest, LargeSkinSaysWhatItLeavesOut) {
  scene.setReconstruction(shared(cylinderSheet(75, 40)));
  EXPECT_EQ(scene.availability(SceneItem::Ellipsoids), Availability::TooManyCells);
  EXPECT_EQ(scene.availability(SceneItem::Links), Availability::Available);
  scene.setReconstruction(shared(cylinderSheet(130, 40)));
  EXPECT_EQ(scene.availability(SceneItem::Links), Availability::TooManyCells);
}

TEST_F(PatchSceneTest, EmptySkinShowsTheBackgroundOnly) {
  scene.setReconstruction(shared(demoReconstruction()));
  window->Render();
  scene.setReconstruction(nullptr);
  const auto empty = picture();
  scene.setReconstruction(shared(demoPatches({})));
  EXPECT_EQ(differingShare(empty, picture()), 0);
  EXPECT_NEAR(qGreen(empty.pixel(0, kHeight / 2)), qGreen(empty.pixel(kWidth / 2, kHeight / 2)), 2);
  EXPECT_FALSE(scene.showsGravity());
  EXPECT_EQ(scene.pick(0.5 * kWidth, 0.5 * kHeight), std::nullopt);
}

TEST_F(PatchSceneTest, GravityArrowFollowsThePose) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  const auto last = picture();
  EXPECT_TRUE(scene.showsGravity());
  moment.pose = PoseId(2);
  scene.setMoment(moment);
  EXPECT_EQ(differingShare(last, picture()), 0);  // the last pose is what is shown by default
  moment.pose = PoseId(1);
  scene.setMoment(moment);
  EXPECT_GT(differingShare(last, picture()), 0.0005);
  moment.pose = PoseId(77);
  scene.setMoment(moment);
  EXPECT_FALSE(scene.showsGravity());
}

TEST_F(PatchSceneTest, BrushedCellsCarryARingUntilTheyAreBrushedNoMore) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  const auto plain = picture();
  scene.setBrushed({CellId(1), CellId(2), CellId(3)});
  const auto three = picture();
  EXPECT_GT(differingShare(plain, three), kMaxDifferingShare);
  scene.setReconstruction(nullptr);
  scene.setReconstruction(shared(demo));
  EXPECT_LT(differingShare(three, picture()), differingShare(plain, three)) << "the next result is marked, too";
  scene.setBrushed({CellId(2)});
  const double one = differingShare(plain, picture());
  EXPECT_GT(one, 0);
  EXPECT_LT(one, differingShare(plain, three));
  scene.setBrushed({CellId(99)});
  EXPECT_EQ(differingShare(plain, picture()), 0) << "a cell that is not there";
  scene.setBrushed({});
  EXPECT_EQ(differingShare(plain, picture()), 0);
}

}  // namespace
}  // namespace hexoderm
