#include "widgets/patch_scene.h"

#include "hexoderm/reconstruction/overlays.h"
#include "support/demo_reconstruction.h"
#include "support/large_skin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>
#include <cstdlib>
#include <filesystem>

namespace hexoderm {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 300;
// A pixel differs if a channel is off by more than this; edges move by a pixel between drivers, faces don't.
constexpr int kChannelSlack = 32;
constexpr double kMaxDifferingShare = 0.002;

/// Colours of the tests' own, so that a new palette does not change the baselines.
SceneColors testColors(bool dark) {
  SceneColors colors;
  colors.background_top = dark ? Rgb{0.08, 0.09, 0.11} : Rgb{0.93, 0.95, 0.96};
  colors.background_bottom = dark ? Rgb{0.12, 0.14, 0.17} : Rgb{0.87, 0.90, 0.93};
  colors.quality =
      dark ? std::array<Rgb, 4>{{{0.59, 0.20, 0.19}, {0.70, 0.61, 0.17}, {0.37, 0.67, 0.69}, {0.34, 0.29, 0.64}}}
           : std::array<Rgb, 4>{{{0.43, 0.04, 0.07}, {0.78, 0.37, 0.07}, {0.08, 0.54, 0.68}, {0.20, 0.10, 0.60}}};
  colors.neutral = {0.5, 0.55, 0.6};
  colors.scale = {{0.27, 0.0, 0.33}, {0.13, 0.57, 0.55}, {0.99, 0.91, 0.14}};
  colors.edge = dark ? Rgb{0.08, 0.09, 0.11} : Rgb{0.11, 0.14, 0.17};
  colors.selection = dark ? Rgb{1, 1, 1} : Rgb{0, 0, 0};
  colors.light_mark = {1, 1, 1};
  colors.dark_mark = {0.08, 0.09, 0.11};
  colors.arrow_shaft = {0.6, 0.65, 0.7};
  colors.arrow_head = {0.37, 0.7, 0.91};
  colors.link_line = {{{0.84, 0.29, 0.27}, {1.0, 0.87, 0.24}, {0.53, 0.96, 0.98}, {0.48, 0.42, 0.91}}};
  colors.text = dark ? Rgb{0.9, 0.92, 0.93} : Rgb{0.11, 0.14, 0.17};
  colors.overlay = {0.37, 0.7, 0.91};
  colors.ellipsoid = dark ? Rgb{1, 1, 1} : Rgb{0.11, 0.14, 0.17};
  return colors;
}

DemoOptions mixedQualities() {
  DemoOptions options;
  options.arm_quality = {EdgeQuality::Fully, EdgeQuality::Partially, EdgeQuality::Over, EdgeQuality::Undefined};
  return options;
}

/// The demo with uncertainties that grow along its arms, largest across the path.
Reconstruction withUncertainties(double factor = 1) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  for (CellPlacement& cell : demo.patches[0].cells) {
    const double sigma_m = 0.0003 * factor * static_cast<double>(cell.path.size() - 1);
    const Eigen::Vector3d sigmas(0.4 * sigma_m, 0.6 * sigma_m, sigma_m);
    cell.cov_t_r = Matrix6d::Zero();
    cell.cov_t_r->topLeftCorner<3, 3>() = cell.T_o_u.R * sigmas.cwiseAbs2().asDiagonal() * cell.T_o_u.R.transpose();
  }
  return demo;
}

GroundTruth truthOf(const Reconstruction& reconstruction) {
  GroundTruth truth;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) truth.cells.push_back({cell.cell, cell.T_o_u});
  }
  return truth;
}

/// Every cell moved out or in by turns.
Reconstruction roughened(double by_m) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  for (std::size_t k = 0; k < demo.patches[0].cells.size(); ++k) {
    SE3& T = demo.patches[0].cells[k].T_o_u;
    T.t += (k % 2 == 0 ? by_m : -by_m) * T.R.col(2);
  }
  return demo;
}

std::shared_ptr<const Reconstruction> shared(Reconstruction reconstruction) {
  return std::make_shared<const Reconstruction>(std::move(reconstruction));
}

/// A scene in a window of its own that is never shown.
class PatchSceneTest : public testing::Test {
 protected:
  PatchSceneTest() {
    window->SetOffScreenRendering(1);
    window->SetSize(kWidth, kHeight);
    window->SetDPI(72);
    scene.setTextVisible(false);
    scene.setColors(testColors(true));
    scene.attachTo(window);
  }

  vtkSmartPointer<vtkImageData> picture() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->Update();
    return filter->GetOutput();
  }

  std::array<double, 3> cameraPosition() const {
    std::array<double, 3> position{};
    scene.renderer()->GetActiveCamera()->GetPosition(position.data());
    return position;
  }

  /// Where the centre of a cell's front face is drawn.
  std::array<double, 2> pixelOf(const Reconstruction& reconstruction, CellId id) {
    const Eigen::Vector3d center = reconstruction.find(id).cell->T_o_u.t;
    scene.renderer()->SetWorldPoint(center.x(), center.y(), center.z(), 1);
    scene.renderer()->WorldToDisplay();
    const double* display = scene.renderer()->GetDisplayPoint();
    return {display[0], display[1]};
  }

  vtkNew<vtkRenderWindow> window;
  PatchScene scene;
};

/// Share of the pixels that differ; 1 if the sizes do.
double differingShare(vtkImageData* a, vtkImageData* b) {
  const int* size = a->GetDimensions();
  const int* other = b->GetDimensions();
  if (size[0] != other[0] || size[1] != other[1]) return 1;
  int differing = 0;
  for (int y = 0; y < size[1]; ++y) {
    for (int x = 0; x < size[0]; ++x) {
      const auto* p = static_cast<const unsigned char*>(a->GetScalarPointer(x, y, 0));
      const auto* q = static_cast<const unsigned char*>(b->GetScalarPointer(x, y, 0));
      bool same = true;
      for (int channel = 0; channel < 3; ++channel) same = same && std::abs(p[channel] - q[channel]) <= kChannelSlack;
      if (!same) ++differing;
    }
  }
  return static_cast<double>(differing) / (static_cast<double>(size[0]) * size[1]);
}

void writePng(vtkImageData* image, const std::string& path) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

/// Compares with tests/baselines/NAME.png. HEXODERM_UPDATE_BASELINES=1 writes it instead.
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

TEST_F(PatchSceneTest, LooksLikeTheBaselineInTheDark) {
  scene.setReconstruction(shared(demoReconstruction(mixedQualities())));
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_dark"), kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineInTheLightWithAPickedCell) {
  scene.setColors(testColors(false));
  scene.setReconstruction(shared(demoReconstruction(mixedQualities())));
  scene.setSelection(CellId(6), std::nullopt);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_light"), kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineColouredByDeviation) {
  scene.setReconstruction(shared(demoReconstruction(mixedQualities())));
  scene.setColoring(CellColoring::Deviation);
  scene.showStandardView(PatchScene::View::Front);
  EXPECT_LE(differenceToBaseline(picture(), "patch_scene_deviation"), kMaxDifferingShare);
}

/// The negative controls of the three tests above: small changes must be seen.
TEST_F(PatchSceneTest, TheBaselineComparisonSeesOneMovedCell) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  const auto before = picture();
  Reconstruction moved = demo;
  moved.patches[0].cells[1].T_o_u.t.z() += 0.004;
  scene.setReconstruction(shared(moved));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, TheBaselineComparisonSeesOneChangedColour) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  const auto before = picture();
  Reconstruction changed = demo;
  changed.patches[0].links[3].quality = EdgeQuality::Undefined;  // the last link of an arm that was fully defined
  scene.setReconstruction(shared(changed));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, LooksLikeTheBaselineColouredByPositionUncertainty) {
  scene.setColors(testColors(false));
  scene.setReconstruction(shared(withUncertainties()));
  scene.setColoring(CellColoring::PositionUncertainty);
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
  scene.setSurface(evaluateSurface(rough.patches[0], SurfaceKind::Cylinder));
  scene.setColoring(CellColoring::SurfaceDistance);
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
  scene.setColoring(CellColoring::PositionUncertainty);
  const auto coloured = picture();
  scene.setColoring(CellColoring::LinkQuality);
  scene.setShown(SceneItem::Ellipsoids, true);
  const auto ellipsoids = picture();
  scene.setReconstruction(shared(withUncertainties(1.4)));
  EXPECT_GT(differingShare(ellipsoids, picture()), 1.5 * kMaxDifferingShare);
  scene.setShown(SceneItem::Ellipsoids, false);
  scene.setColoring(CellColoring::PositionUncertainty);
  scene.setReconstruction(shared(withUncertainties(2.5)));
  EXPECT_GT(differingShare(coloured, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, TheBaselineComparisonSeesAnotherSurface) {
  const Reconstruction rough = roughened(0.0008);
  scene.setReconstruction(shared(rough));
  SurfaceEvaluation surface = evaluateSurface(rough.patches[0], SurfaceKind::Cylinder);
  scene.setSurface(surface);
  const auto before = picture();
  *surface.radius_m += 0.001;
  for (double& distance_m : surface.distance_m) distance_m -= 0.001;
  scene.setSurface(surface);
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, TheBaselineComparisonSeesChangedCellsOfALargeSkin) {
  Reconstruction sheet = cylinderSheet(60, 40);
  scene.setReconstruction(shared(sheet));
  const auto before = picture();
  for (LinkEstimate& link : sheet.patches[0].links) {  // of two columns in the middle of the picture
    if (link.source.cell.value() > 28 * 40 && link.source.cell.value() <= 30 * 40) link.quality = EdgeQuality::Over;
  }
  scene.setReconstruction(shared(sheet));
  EXPECT_GT(differingShare(before, picture()), 1.5 * kMaxDifferingShare);
}

TEST_F(PatchSceneTest, WhatIsSwitchedOffIsGone) {
  const Reconstruction demo = withUncertainties();
  scene.setReconstruction(shared(demo));
  scene.setTruth(std::make_shared<const GroundTruth>(truthOf(roughened(0.003))));
  const auto plain = picture();
  for (const SceneItem item : {SceneItem::Links, SceneItem::Tree, SceneItem::Ellipsoids, SceneItem::Truth}) {
    EXPECT_EQ(scene.availability(item), Availability::Available);
    scene.setShown(item, true);
    EXPECT_GT(differingShare(plain, picture()), kMaxDifferingShare) << "item " << static_cast<int>(item);
    scene.setShown(item, false);
    EXPECT_EQ(differingShare(plain, picture()), 0) << "item " << static_cast<int>(item);
  }
  for (const SceneItem item : {SceneItem::Ports, SceneItem::Axes, SceneItem::Gravity}) {
    scene.setShown(item, false);
    EXPECT_GT(differingShare(plain, picture()), 0) << "item " << static_cast<int>(item);
    scene.setShown(item, true);
    EXPECT_EQ(differingShare(plain, picture()), 0) << "item " << static_cast<int>(item);
  }
}

TEST_F(PatchSceneTest, ResultsAreDrawnUntilTheyAreTakenBack) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  const auto plain = picture();
  EXPECT_EQ(scene.availability(SceneItem::Loop), Availability::NoData);
  scene.setLoop(evaluateLoop(demo, {CellId(14), PortNumber(1)}, {CellId(17), PortNumber(4)}));
  EXPECT_GT(differingShare(plain, picture()), 0.001);
  EXPECT_TRUE(scene.notes().loop_factor.has_value());
  scene.setLoop(std::nullopt);
  EXPECT_EQ(differingShare(plain, picture()), 0);

  scene.setComparison(compareToReconstruction(demo, roughened(0.001)));
  EXPECT_GT(differingShare(plain, picture()), 0.001);
  EXPECT_EQ(scene.notes().shift_factor, 10);
  scene.setComparison({});
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
  scene.setSurface(evaluateSurface(before.patches[0], SurfaceKind::Sphere));
  scene.setLoop(evaluateLoop(before, {CellId(114), PortNumber(1)}, {CellId(117), PortNumber(4)}));
  scene.setComparison(compareToReconstruction(before, before));
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

TEST_F(PatchSceneTest, LargeSkinShowsShadedCellsFromBehindAndCanBePickedThere) {
  const Reconstruction sheet = sheetReconstruction(60, 50);
  scene.setReconstruction(shared(sheet));
  scene.setShown(SceneItem::Gravity, false);
  scene.setShown(SceneItem::Axes, false);
  scene.setSmoothed(false);
  scene.showStandardView(PatchScene::View::Front);
  const CellId middle(30 + 60 * 25);
  const auto colourOf = [&](vtkImageData* image) {
    const auto [x, y] = pixelOf(sheet, middle);
    const auto* p =
        static_cast<const unsigned char*>(image->GetScalarPointer(static_cast<int>(x), static_cast<int>(y), 0));
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  const auto front = colourOf(picture());
  scene.renderer()->GetActiveCamera()->Azimuth(180);
  const auto behind = colourOf(picture());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(behind.at(k), 0.70 * front.at(k), 6) << k;
  const auto [x, y] = pixelOf(sheet, middle);
  EXPECT_EQ(scene.pick(x, y), middle);
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

  // What is turned by hand stays as large as it is.
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

TEST_F(PatchSceneTest, PicksTheCellUnderThePixel) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  scene.showStandardView(PatchScene::View::Front);
  window->Render();
  for (const std::uint32_t id : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U}) {
    const auto [x, y] = pixelOf(demo, CellId(id));
    EXPECT_EQ(scene.pick(x, y), CellId(id));
  }
  EXPECT_EQ(scene.pick(2, kHeight - 2), std::nullopt);
}

TEST_F(PatchSceneTest, PicksTheNearestCellWhereTwoOverlap) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[1].T_o_u = demo.patches[0].cells[0].T_o_u;
  demo.patches[0].cells[1].T_o_u.t.z() -= 0.02;  // cell 2 hides behind cell 1
  scene.setReconstruction(shared(demo));
  scene.showStandardView(PatchScene::View::Front);
  window->Render();
  const auto [x, y] = pixelOf(demo, CellId(1));
  EXPECT_EQ(scene.pick(x, y), CellId(1));
}

TEST_F(PatchSceneTest, KeepsTheCameraWhileTheCellsAreTheSame) {
  Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  window->Render();
  scene.renderer()->GetActiveCamera()->Azimuth(30);
  const auto turned = cameraPosition();
  demo.patches[0].cells[1].T_o_u.t.z() += 0.05;
  demo.patches[0].links[0].quality = EdgeQuality::Over;
  scene.setReconstruction(shared(demo));
  window->Render();
  EXPECT_EQ(cameraPosition(), turned);
}

TEST_F(PatchSceneTest, FollowsThePatchIntoAnotherShapeUntilTheCameraIsMoved) {
  Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  window->Render();
  const auto first = cameraPosition();
  for (CellPlacement& cell : demo.patches[0].cells) cell.T_o_u.t *= 1.02;
  scene.setReconstruction(shared(demo));
  window->Render();
  EXPECT_EQ(cameraPosition(), first) << "a new pose's small changes don't make the picture jump";
  for (CellPlacement& cell : demo.patches[0].cells) cell.T_o_u.t *= 1.3;
  scene.setReconstruction(shared(demo));
  window->Render();
  EXPECT_NE(cameraPosition(), first);
}

TEST_F(PatchSceneTest, FitsAgainWhenCellsComeOrGo) {
  DemoOptions options;
  scene.setReconstruction(shared(demoReconstruction(options)));
  window->Render();
  const auto before = cameraPosition();
  options.arm_cells = 2;
  scene.setReconstruction(shared(demoReconstruction(options)));
  window->Render();
  EXPECT_NE(cameraPosition(), before);
}

TEST_F(PatchSceneTest, FitsAgainInAResizedWindowUntilTheCameraIsMoved) {
  scene.setReconstruction(shared(demoReconstruction()));
  window->Render();
  const auto wide = cameraPosition();
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

TEST_F(PatchSceneTest, FitShowsEveryCellFromEverySide) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  for (const auto view :
       {PatchScene::View::Oblique, PatchScene::View::Front, PatchScene::View::Side, PatchScene::View::Top}) {
    scene.showStandardView(view);
    window->Render();
    for (const CellPlacement& cell : demo.patches[0].cells) {
      const auto [x, y] = pixelOf(demo, cell.cell);
      EXPECT_THAT(x, testing::AllOf(testing::Gt(0), testing::Lt(kWidth))) << "cell " << cell.cell;
      EXPECT_THAT(y, testing::AllOf(testing::Gt(0), testing::Lt(kHeight))) << "cell " << cell.cell;
    }
  }
}

TEST_F(PatchSceneTest, EmptySkinShowsTheBackgroundOnly) {
  scene.setReconstruction(shared(demoReconstruction()));
  window->Render();
  scene.setReconstruction(nullptr);
  const auto empty = picture();
  scene.setReconstruction(shared(demoReconstruction(std::vector<PatchReconstruction>{})));
  EXPECT_EQ(differingShare(empty, picture()), 0);
  const auto* first = static_cast<const unsigned char*>(empty->GetScalarPointer(0, kHeight / 2, 0));
  const auto* middle = static_cast<const unsigned char*>(empty->GetScalarPointer(kWidth / 2, kHeight / 2, 0));
  EXPECT_NEAR(first[1], middle[1], 2);
  EXPECT_FALSE(scene.showsGravity());
  EXPECT_EQ(scene.pick(0.5 * kWidth, 0.5 * kHeight), std::nullopt);
}

TEST_F(PatchSceneTest, SingleCellFillsTheMiddleAndCanBePicked) {
  DemoOptions options;
  options.arm_cells = 0;
  scene.setReconstruction(shared(demoReconstruction(options)));
  window->Render();
  EXPECT_EQ(scene.pick(0.5 * kWidth, 0.5 * kHeight), CellId(1));
}

TEST_F(PatchSceneTest, TenThousandCellsAreDrawnAndPicked) {
  const Reconstruction sheet = sheetReconstruction(100, 100);
  scene.setReconstruction(shared(sheet));
  scene.showStandardView(PatchScene::View::Front);
  window->Render();
  const auto [x, y] = pixelOf(sheet, CellId(5050));
  EXPECT_EQ(scene.pick(x, y), CellId(5050));
}

TEST_F(PatchSceneTest, PatchesStandSideBySide) {
  const CellModel model = builtInCellModel("hex-bma150");
  DemoOptions second;
  second.first_id = 101;
  const Reconstruction two = demoReconstruction({demoPatch(model), demoPatch(model, second)});
  scene.setReconstruction(shared(two));
  scene.showStandardView(PatchScene::View::Front);
  window->Render();
  std::optional<CellId> left;
  std::optional<CellId> right;
  for (int x = 0; x < kWidth; ++x) {
    const auto cell = scene.pick(x, 0.5 * kHeight);
    if (!cell) continue;
    if (!left) left = cell;
    right = cell;
  }
  ASSERT_TRUE(left && right);
  EXPECT_LT(left->value(), 100U);
  EXPECT_GT(right->value(), 100U);
}

TEST_F(PatchSceneTest, SelectionIsOutlinedAndTakenBack) {
  scene.setReconstruction(shared(demoReconstruction()));
  const auto plain = picture();
  scene.setSelection(CellId(3), std::nullopt);
  EXPECT_GT(differingShare(plain, picture()), 0.001);
  scene.setSelection(std::nullopt, std::pair(LinkEnd{CellId(1), PortNumber(1)}, LinkEnd{CellId(2), PortNumber(4)}));
  EXPECT_GT(differingShare(plain, picture()), 0.0005);
  scene.setSelection(CellId(999), std::nullopt);  // of another skin
  EXPECT_EQ(differingShare(plain, picture()), 0);
  scene.setSelection(std::nullopt, std::nullopt);
  EXPECT_EQ(differingShare(plain, picture()), 0);
}

TEST_F(PatchSceneTest, GravityArrowFollowsThePose) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  const auto last = picture();
  EXPECT_TRUE(scene.showsGravity());
  scene.setPose(PoseId(2));
  EXPECT_EQ(differingShare(last, picture()), 0);  // the last pose is what is shown by default
  scene.setPose(PoseId(1));
  EXPECT_GT(differingShare(last, picture()), 0.0005);
  scene.setPose(PoseId(77));
  EXPECT_FALSE(scene.showsGravity());
}

TEST_F(PatchSceneTest, NumbersAppearOnFacesThatLookAtTheCameraOnly) {
  DemoOptions options;
  options.arm_cells = 0;
  Reconstruction single = demoReconstruction(options);
  single.patches[0].gravity.clear();
  scene.setReconstruction(shared(single));
  scene.showStandardView(PatchScene::View::Front);
  const auto without = picture();
  scene.setTextVisible(true);
  const auto with = picture();
  int changed = 0;
  for (int y = kHeight / 2 - 20; y < kHeight / 2 + 20; ++y) {
    for (int x = kWidth / 2 - 20; x < kWidth / 2 + 20; ++x) {
      const auto* p = static_cast<const unsigned char*>(without->GetScalarPointer(x, y, 0));
      const auto* q = static_cast<const unsigned char*>(with->GetScalarPointer(x, y, 0));
      if (std::abs(p[0] - q[0]) > kChannelSlack) ++changed;
    }
  }
  EXPECT_GT(changed, 10);

  // From behind there is nothing to read.
  single.patches[0].cells[0].T_o_u.R = expSO3(kPi * Eigen::Vector3d::UnitY());
  scene.setReconstruction(shared(single));
  const auto behind = picture();
  scene.setTextVisible(false);
  const auto behind_without = picture();
  for (int y = kHeight / 2 - 20; y < kHeight / 2 + 20; ++y) {
    for (int x = kWidth / 2 - 20; x < kWidth / 2 + 20; ++x) {
      const auto* p = static_cast<const unsigned char*>(behind->GetScalarPointer(x, y, 0));
      const auto* q = static_cast<const unsigned char*>(behind_without->GetScalarPointer(x, y, 0));
      ASSERT_EQ(p[0], q[0]);
    }
  }
}

}  // namespace
}  // namespace hexoderm
