#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/polydata_builder.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_sight.h"

#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace hexoderm {

/// The patch as it should be held next: its front faces with dashed outlines, small, on the right of the scene. It is
/// seen from where the scene is seen from, and turns from the present orientation to the next one about an axis that is
/// drawn through it. A skin of more than kMaxCells is shown as an arrow that is to point up.
class SceneGhost {
 public:
  static constexpr std::size_t kMaxCells = 2000;
  static constexpr double kShare = 0.34;  ///< share of the window's width

  SceneGhost() {
    renderer_->SetLayer(1);
    renderer_->InteractiveOff();
    renderer_->GetActiveCamera()->ParallelProjectionOn();
    for (const MeshActor* drawn : {&fill_, &outline_, &arrow_, &axis_}) {
      drawn->property()->LightingOff();
      renderer_->AddActor(drawn->actor);
    }
    fill_.property()->SetOpacity(0.16);
    outline_.property()->SetLineWidth(1.4F);
    const vtkNew<vtkArrowSource> arrow;
    arrow->SetTipResolution(32);
    arrow->SetShaftResolution(24);
    arrow_.mapper->SetInputConnection(arrow->GetOutputPort());
    arrow_.property()->SetOpacity(0.55);
    axis_.property()->SetLineWidth(1.6F);
    update();
  }

  void attachTo(vtkRenderWindow* window) { window->AddRenderer(renderer_); }
  void detachFrom(vtkRenderWindow* window) { window->RemoveRenderer(renderer_); }
  void setColors(const SceneColors& colors) {
    for (const MeshActor* drawn : {&fill_, &outline_, &arrow_, &axis_}) drawn->setColor(colors.arrow_head);
  }

  /// Shows the largest patch of this layout.
  void setLayout(const SceneLayout& layout) {
    const auto begin = std::ranges::lower_bound(layout.cells, layout.largest, {}, &SceneCell::patch);
    const auto end = std::ranges::upper_bound(layout.cells, layout.largest, {}, &SceneCell::patch);
    cells_ = static_cast<std::size_t>(end - begin);
    const std::size_t per_cell = layout.pointsPerCell();
    const auto points =
        std::span(layout.points)
            .subspan(per_cell * static_cast<std::size_t>(begin - layout.cells.begin()), per_cell * cells_);
    Eigen::AlignedBox3d box;
    PolyDataBuilder faces;
    PolyDataBuilder dashes;
    for (std::size_t cell = 0; cell < cells_; ++cell) {
      const auto corners = points.subspan(per_cell * cell, kGhostSides);
      for (const Eigen::Vector3d& corner : corners) box.extend(corner);
      if (isArrow()) continue;
      faces.addPolygon(faces.addPoints(corners));
      for (std::size_t k = 0; k < kGhostSides; ++k) {
        const Eigen::Vector3d& to = corners[(k + 1) % kGhostSides];
        dashes.addDashes(corners[k], to, (to - corners[k]).norm() / kDashesPerSide, 0.55);
      }
    }
    center_ = box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center());
    radius_m_ = 0;
    for (const Eigen::Vector3d& point : points) radius_m_ = std::max(radius_m_, (point - center_).norm());
    fill_.show(faces.finish());
    outline_.show(dashes.finish());
    update();
  }

  /// Unit vectors in the patch frame: where up is now and where it is to be. Without the latter there is no ghost.
  void setTurn(const Eigen::Vector3d& from_up, const std::optional<Eigen::Vector3d>& to_up) {
    from_up_ = from_up;
    to_up_ = to_up;
    update();
  }

  /// Share of the turn that is done, 0 to 1.
  void setPhase(double phase) {
    phase_ = std::clamp(phase, 0.0, 1.0);
    update();
  }

  [[nodiscard]] bool isVisible() const { return to_up_ && cells_ > 0; }
  /// Looks the same way as the scene, and keeps its place in the window; called before each rendering.
  void follow(const SceneSight& sight) {
    const auto [width, height] = sight.window;
    if (!isVisible() || width <= 0 || height <= 0) return;
    const auto [left, bottom, right, top] = placeIn(width, height);
    renderer_->SetViewport(left / width, bottom / height, right / width, top / height);
    const double away = 4 * radius_m_;
    vtkCamera* own = renderer_->GetActiveCamera();
    const Eigen::Vector3d position = away * sight.back;
    own->SetFocalPoint(0, 0, 0);
    own->SetPosition(position.data());
    own->SetViewUp(sight.up.data());
    own->SetParallelScale(kMargin * radius_m_);
    own->SetClippingRange(0.4 * away, 1.6 * away);
  }

  /// Its place in a window of this size: left, bottom, right and top, from the lower left.
  static std::array<double, 4> placeIn(double width, double height) {
    const double side = std::min(kShare * width, kMaxHeight * height);
    const double right = (1 - kBesideEdge) * width;
    const double bottom = kMiddleHeight * height - 0.5 * side;
    return {right - side, bottom, right, bottom + side};
  }

 private:
  static constexpr std::size_t kGhostSides = 6;
  static constexpr int kDashesPerSide = 4;
  static constexpr double kMargin = 1.06;        // around the patch
  static constexpr double kMiddleHeight = 0.55;  // share of the window's height
  static constexpr double kMaxHeight = 0.56;
  static constexpr double kBesideEdge = 0.02;

  [[nodiscard]] bool isArrow() const { return cells_ > kMaxCells; }
  /// The ghost turns in the frame of the part as it is held now, in which the camera stands too.
  void update() {
    renderer_->SetDraw(isVisible());
    arrow_.actor->SetVisibility(isArrow());
    if (!isVisible()) return;
    const Eigen::Vector3d turn = logSO3(shortestRotation(*to_up_, from_up_));
    const Eigen::Matrix3d R = expSO3(phase_ * turn);
    PolyDataBuilder axis;
    if (turn.norm() >= kThere_rad) {
      const Eigen::Vector3d end = radius_m_ * turn.normalized();
      axis.addLine({axis.addPoint(-end), axis.addPoint(end)});
    }
    axis_.show(axis.finish());
    for (const MeshActor* drawn : {&fill_, &outline_}) setPlace(drawn->actor, R, -(R * center_));
    // The arrow is as large as the patch would be, with its middle in the middle.
    const Eigen::Matrix3d along = R * shortestRotation(Eigen::Vector3d::UnitX(), *to_up_);
    setPlace(arrow_.actor, 1.4 * radius_m_ * along, -0.7 * radius_m_ * along.col(0));
  }

  vtkNew<BlendingRenderer> renderer_;
  MeshActor fill_;
  MeshActor outline_;
  MeshActor arrow_;
  MeshActor axis_;  ///< about which it turns
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  double radius_m_ = 0;
  std::size_t cells_ = 0;
  Eigen::Vector3d from_up_ = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> to_up_;
  double phase_ = 1;
};

}  // namespace hexoderm
