// Pictures of the scene, compared with kept ones, and checks that the comparison sees differences.
#include "tests/widgets/scene/patch_scene_test.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/paths.h"

#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <filesystem>
#include <string>

namespace hexoderm {
namespace {

void writePng(vtkImageData* image, const std::string& path) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

/// Compares with the picture of this name in tests/baselines. HEXODERM_UPDATE_BASELINES=1 writes it instead.
double differenceToBaseline(vtkImageData* image, const std::string& name) {
  const std::string path = std::string(HEXODERM_BASELINES) + "/" + name + ".png";
  if (std::getenv("HEXODERM_UPDATE_BASELINES") != nullptr) writePng(image, path);
  if (!std::filesystem::exists(path)) return 1;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const double share = differingShare(image, reader->GetOutput());
  if (share > kMaxDifferingShare) writePng(image, name + "-actual.png");
  return share;
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineInBothThemesAndColouredByDeviation) {
  scene.setReconstruction(shared(demoReconstruction(mixedQualities())));
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_dark"), kMaxDifferingShare);
  scene.setColors(testColors(false));
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_light"), kMaxDifferingShare);
  scene.setColors(testColors(true));
  scene.setColoring(Coloring::Deviation);
  scene.showStandardView(PatchScene::View::Front);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_deviation"), kMaxDifferingShare);
}

/// The negative controls of the test above: small changes must be seen.
TEST_F(PatchSceneTest, TheBaselineComparisonSeesOneMovedCellAndOneChangedColour) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  const auto before = picture();
  Reconstruction moved = demo;
  moved.patches[0].cells[1].T_o_u.t.z() += 0.004;
  scene.setReconstruction(shared(moved));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
  Reconstruction changed = demo;
  changed.patches[0].links[3].quality = EdgeQuality::Undefined;  // the last link of an arm that was fully defined
  scene.setReconstruction(shared(changed));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineColouredByPositionUncertainty) {
  scene.setColors(testColors(false));
  scene.setReconstruction(shared(withUncertainties()));
  scene.setColoring(Coloring::PositionUncertainty);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_uncertainty"), kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineWithEllipsoids) {
  scene.setReconstruction(shared(withUncertainties()));
  scene.setShown(SceneItem::Ellipsoids, true);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_ellipsoids"), kMaxDifferingShare);
  ASSERT_TRUE(scene.notes().ellipsoid_factor.has_value());
  EXPECT_EQ(*scene.notes().ellipsoid_factor, 2);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineWithAFittedCylinder) {
  const Reconstruction rough = roughened(0.0008);
  scene.setReconstruction(shared(rough));
  overlays.surface = shared(evaluateSurface(rough.patches[0], SurfaceKind::Cylinder));
  scene.setOverlays(overlays);
  scene.setColoring(Coloring::SurfaceDistance);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_surface"), kMaxDifferingShare);
  EXPECT_TRUE(scene.notes().distance_factor.has_value());
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineWithLinksAndTree) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  demo.patches[0].links[6].used = false;
  scene.setReconstruction(shared(demo));
  scene.setShown(SceneItem::Links, true);
  scene.setShown(SceneItem::Tree, true);
  scene.setShown(SceneItem::Ports, false);
  scene.showStandardView(PatchScene::View::Front);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_links"), kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LargeSkinLooksLikeTheBaseline) {
  scene.setReconstruction(shared(cylinderSheet(60, 40)));
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_large"), kMaxDifferingShare);
}

/// The negative controls of these.
TEST_F(PatchSceneTest, TheBaselineComparisonSeesLargerUncertainties) {
  scene.setReconstruction(shared(withUncertainties()));
  scene.setColoring(Coloring::PositionUncertainty);
  const auto coloured = picture();
  scene.setColoring(Coloring::LinkQuality);
  scene.setShown(SceneItem::Ellipsoids, true);
  const auto ellipsoids = picture();
  scene.setReconstruction(shared(withUncertainties(1.4)));
  EXPECT_GT(differingShare(ellipsoids, picture()), 1.5 * kMaxDifferingShare);
  scene.setShown(SceneItem::Ellipsoids, false);
  scene.setColoring(Coloring::PositionUncertainty);
  scene.setReconstruction(shared(withUncertainties(2.5)));
  EXPECT_LE(differingShare(coloured, picture()), kMaxDifferingShare) << "the scale is fitted to them";
  // As the operator fixes it, the same colours mean the same.
  scene.setFixedRange(ColorRange{0, 6});
  const auto larger = picture();
  scene.setReconstruction(shared(withUncertainties()));
  EXPECT_GT(differingShare(larger, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, TheBaselineComparisonSeesAnotherSurface) {
  const Reconstruction rough = roughened(0.0008);
  scene.setReconstruction(shared(rough));
  SurfaceEvaluation surface = evaluateSurface(rough.patches[0], SurfaceKind::Cylinder);
  overlays.surface = shared(surface);
  scene.setOverlays(overlays);
  const auto before = picture();
  *surface.radius_m += 0.001;
  for (double& distance_m : surface.distance_m) distance_m -= 0.001;
  overlays.surface = shared(surface);
  scene.setOverlays(overlays);
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, TheBaselineComparisonSeesChangedCellsOfALargeSkin) {
  Reconstruction sheet = cylinderSheet(60, 40);
  scene.setReconstruction(shared(sheet));
  const auto before = picture();
  for (LinkEstimate& link : sheet.patches[0].links) {  // links of two columns in the middle of the picture
    if (link.source.cell.value() > 28 * 40 && link.source.cell.value() <= 30 * 40) link.quality = EdgeQuality::Over;
  }
  scene.setReconstruction(shared(sheet));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

}  // namespace
}  // namespace hexoderm
