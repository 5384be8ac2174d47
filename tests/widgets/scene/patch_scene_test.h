#pragma once

#include "tests/support/hand_made_skins.h"
#include "tests/support/picture_difference.h"
#include "widgets/scene/edge_smoothing.h"
#include "widgets/scene/patch_scene.h"

#include <gmock/gmock.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkWindowToImageFilter.h>
#include <cstdlib>

namespace hexoderm {

inline constexpr int kWidth = 400;
inline constexpr int kHeight = 300;
// A pixel differs if a channel is off by more than this; edges move by a pixel between drivers, faces don't.
inline constexpr int kChannelSlack = 32;
inline constexpr double kMaxDifferingShare = 0.002;

inline double differingShare(const QImage& a, const QImage& b) { return differingShare(a, b, kChannelSlack); }

/// Colours of the tests' own, so that a new palette does not change the baselines.
inline SceneColors testColors(bool dark) {
  SceneColors colors;
  colors.background_top = dark ? Rgb{0.08, 0.09, 0.11} : Rgb{0.93, 0.95, 0.96};
  colors.background_bottom = dark ? Rgb{0.12, 0.14, 0.17} : Rgb{0.87, 0.90, 0.93};
  colors.quality =
      dark ? std::array<Rgb, 4>{{{0.59, 0.20, 0.19}, {0.70, 0.61, 0.17}, {0.37, 0.67, 0.69}, {0.34, 0.29, 0.64}}}
           : std::array<Rgb, 4>{{{0.43, 0.04, 0.07}, {0.78, 0.37, 0.07}, {0.08, 0.54, 0.68}, {0.20, 0.10, 0.60}}};
  colors.neutral = {0.5, 0.55, 0.6};
  colors.no_data = colors.neutral;
  colors.scale = {{{0.27, 0.0, 0.33}, {0.13, 0.57, 0.55}, {0.99, 0.91, 0.14}}, {0.5, 0.5, 0.9}, {1, 1, 1}};
  colors.signed_scale = {{{0.25, 0.8, 0.93}, {0.44, 0.44, 0.44}, {1.0, 0.68, 0.33}}, {0.9, 1, 1}, {1, 0.95, 0.85}};
  colors.classes = {{0.5, 0.47, 0.98}, {0.78, 0.65, 0.2}, {0.5, 0.87, 0.96}};
  colors.edge = dark ? Rgb{0.08, 0.09, 0.11} : Rgb{0.11, 0.14, 0.17};
  colors.selection = dark ? Rgb{1, 1, 1} : Rgb{0, 0, 0};
  colors.light_mark = {1, 1, 1};
  colors.dark_mark = {0.08, 0.09, 0.11};
  colors.arrow_shaft = {0.6, 0.65, 0.7};
  colors.arrow_head = {0.37, 0.7, 0.91};
  colors.link_line = {{{0.84, 0.29, 0.27}, {1.0, 0.87, 0.24}, {0.53, 0.96, 0.98}, {0.48, 0.42, 0.91}}};
  colors.text = dark ? Rgb{0.9, 0.92, 0.93} : Rgb{0.11, 0.14, 0.17};
  colors.overlay = {0.37, 0.7, 0.91};
  colors.difference = {1.0, 0.87, 0.24};
  colors.axis = {{{0.85, 0.31, 0.29}, {0.22, 0.63, 0.33}, {0.27, 0.48, 0.90}}};
  colors.ellipsoid = dark ? Rgb{1, 1, 1} : Rgb{0.11, 0.14, 0.17};
  return colors;
}

inline DemoOptions mixedQualities() {
  DemoOptions options;
  options.arm_quality = {EdgeQuality::Fully, EdgeQuality::Partially, EdgeQuality::Over, EdgeQuality::Undefined};
  return options;
}

/// The demo with uncertainties that grow along its arms, largest across the path.
inline Reconstruction withUncertainties(double factor = 1) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  for (CellPlacement& cell : demo.patches[0].cells) {
    const double sigma_m = 0.0003 * factor * static_cast<double>(demo.patches[0].pathTo(cell.cell).size() - 1);
    const Eigen::Vector3d sigmas(0.4 * sigma_m, 0.6 * sigma_m, sigma_m);
    cell.cov_t_r = Matrix6d::Zero();
    cell.cov_t_r->topLeftCorner<3, 3>() = cell.T_o_u.R * sigmas.cwiseAbs2().asDiagonal() * cell.T_o_u.R.transpose();
  }
  return demo;
}

/// Every cell moved out or in by turns.
inline Reconstruction roughened(double by_m) {
  Reconstruction demo = demoReconstruction(mixedQualities());
  for (std::size_t k = 0; k < demo.patches[0].cells.size(); ++k) {
    SE3& T = demo.patches[0].cells[k].T_o_u;
    T.t += (k % 2 == 0 ? by_m : -by_m) * T.R.col(2);
  }
  return demo;
}

/// A window that is never shown, to draw a scene in.
class OffScreenTest : public testing::Test {
 protected:
  OffScreenTest() {
    window->SetOffScreenRendering(1);
    window->SetSize(kWidth, kHeight);
    window->SetDPI(72);
  }

  [[nodiscard]] vtkRenderer* renderer() const { return window->GetRenderers()->GetFirstRenderer(); }

  /// Its rows go up, as VTK counts them.
  QImage picture() {
    window->Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->Update();
    vtkImageData* drawn = filter->GetOutput();
    const auto* pixels = static_cast<const unsigned char*>(drawn->GetScalarPointer());
    const int* size = drawn->GetDimensions();
    return QImage(pixels, size[0], size[1], 3 * size[0], QImage::Format_RGB888).copy();
  }

  std::array<double, 3> cameraPosition() const {
    std::array<double, 3> position{};
    renderer()->GetActiveCamera()->GetPosition(position.data());
    return position;
  }

  /// Pixel at which a point of the scene is drawn.
  [[nodiscard]] std::array<double, 2> pixelOf(const Eigen::Vector3d& point) const {
    renderer()->SetWorldPoint(point.x(), point.y(), point.z(), 1);
    renderer()->WorldToDisplay();
    const double* display = renderer()->GetDisplayPoint();
    return {display[0], display[1]};
  }

  vtkNew<vtkRenderWindow> window;
};

class PatchSceneTest : public OffScreenTest {
 protected:
  PatchSceneTest() {
    scene.setTextVisible(false);
    scene.setColors(testColors(true));
    scene.attachTo(window);
    setSmoothed(*window, true);
  }

  using OffScreenTest::pixelOf;
  /// Pixel at which the centre of a cell's front face is drawn.
  [[nodiscard]] std::array<double, 2> pixelOf(const Reconstruction& reconstruction, CellId id) const {
    return pixelOf(reconstruction.find(id).cell->T_o_u.t);
  }

  /// Where the camera is once this skin is drawn.
  std::array<double, 3> cameraFor(const Reconstruction& skin) {
    scene.setReconstruction(shared(skin));
    window->Render();
    return cameraPosition();
  }

  PatchScene scene;
  PatchOverlays overlays;
  PatchMoment moment;
};

}  // namespace hexoderm
