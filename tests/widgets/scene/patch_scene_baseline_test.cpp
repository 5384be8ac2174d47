// Pictures of the scene, compared with kept ones, and checks that the comparison sees differences.
#include "tests/widgets/scene/patch_scene_test.h"

namespace hexoderm {
namespace {

class SceneBaselineTest : public PatchSceneTest {
 protected:
  void expectBaseline(const char* name) {
    EXPECT_LE(differenceToBaseline(picture().mirrored(), name, kChannelSlack, kMaxDifferingShare), kMaxDifferingShare)
        << name;
  }
  /// The negative controls: a change as small as this must be seen.
  void expectSeen(const QImage& before, const char* change) {
    EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare) << change;
  }
};

TEST_F(SceneBaselineTest, InBothThemesAndColouredByDeviation) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  expectBaseline("patch_scene_dark");
  scene.setColors(testColors(false));
  expectBaseline("patch_scene_light");
  scene.setColors(testColors(true));
  const auto before = picture();
  Reconstruction moved = demo;
  moved.patches[0].cells[1].T_o_u.t.z() += 0.004;
  scene.setReconstruction(shared(moved));
  expectSeen(before, "a moved cell");
  Reconstruction changed = demo;
  changed.patches[0].links[3].quality = EdgeQuality::Undefined;  // the last link of an arm that was fully defined
  scene.setReconstruction(shared(changed));
  expectSeen(before, "a colour");
  scene.setReconstruction(shared(demo));
  scene.setColoring(Coloring::Deviation);
  scene.showStandardView(PatchScene::View::Front);
  expectBaseline("patch_scene_deviation");
}

TEST_F(SceneBaselineTest, ColouredByPositionUncertainty) {
  scene.setColors(testColors(false));
  scene.setReconstruction(shared(withUncertainties()));
  scene.setColoring(Coloring::PositionUncertainty);
  expectBaseline("patch_scene_uncertainty");
  scene.setColors(testColors(true));
  const auto before = picture();
  scene.setReconstruction(shared(withUncertainties(2.5)));
  EXPECT_LE(differingShare(before, picture()), kMaxDifferingShare) << "the scale is fitted to them";
  // As the operator fixes it, the same colours mean the same.
  scene.setFixedRange(ColorRange{0, 6});
  const auto larger = picture();
  scene.setReconstruction(shared(withUncertainties()));
  expectSeen(larger, "smaller uncertainties");
}

TEST_F(SceneBaselineTest, WithEllipsoids) {
  scene.setReconstruction(shared(withUncertainties()));
  scene.setShown(SceneItem::Ellipsoids, true);
  expectBaseline("patch_scene_ellipsoids");
  ASSERT_TRUE(scene.notes().ellipsoid_factor.has_value());
  EXPECT_EQ(*scene.notes().ellipsoid_factor, 2);
  const auto before = picture();
  scene.setReconstruction(shared(withUncertainties(1.4)));
  expectSeen(before, "larger uncertainties");
}

TEST_F(SceneBaselineTest, WithAFittedCylinder) {
  const Reconstruction rough = roughened(0.0008);
  scene.setReconstruction(shared(rough));
  SurfaceEvaluation surface = evaluateSurface(rough.patches[0], SurfaceKind::Cylinder);
  overlays.surface = shared(surface);
  scene.setOverlays(overlays);
  scene.setColoring(Coloring::SurfaceDistance);
  expectBaseline("patch_scene_surface");
  EXPECT_TRUE(scene.notes().distance_factor.has_value());
  scene.setColoring(Coloring::LinkQuality);
  const auto before = picture();
  *surface.radius_m += 0.001;
  for (double& distance_m : surface.distance_m) distance_m -= 0.001;
  overlays.surface = shared(surface);
  scene.setOverlays(overlays);
  expectSeen(before, "a larger cylinder");
}

TEST_F(SceneBaselineTest, WithLinksAndTree) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  demo.patches[0].links[6].used = false;
  scene.setReconstruction(shared(demo));
  scene.setShown(SceneItem::Links, true);
  scene.setShown(SceneItem::Tree, true);
  scene.setShown(SceneItem::Ports, false);
  scene.showStandardView(PatchScene::View::Front);
  expectBaseline("patch_scene_links");
}

TEST_F(SceneBaselineTest, OfALargeSkin) {
  Reconstruction sheet = cylinderSheet(60, 40);
  scene.setReconstruction(shared(sheet));
  expectBaseline("patch_scene_large");
  const auto before = picture();
  for (LinkEstimate& link : sheet.patches[0].links) {  // links of two columns in the middle of the picture
    if (link.source.cell.value() > 28 * 40 && link.source.cell.value() <= 30 * 40) link.quality = EdgeQuality::Over;
  }
  scene.setReconstruction(shared(sheet));
  expectSeen(before, "two columns");
}

}  // namespace
}  // namespace hexoderm
