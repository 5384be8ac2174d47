#pragma once

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/cell_meshes.h"
#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace hexoderm {

/// The patch as it should be held next: its front faces with dashed outlines, small, on the right of the scene. It is
/// seen from where the scene is seen from, and turns from the present orientation to the next one about an axis that is
/// drawn through it. A skin of more than kMaxCells is shown as an arrow that is to point up.
class SceneGhost {
 public:
  static constexpr std::size_t kMaxCells = 2000;
  static constexpr double kShare = 0.34;  ///< share of the window's width

  SceneGhost() : parts_(std::make_unique<Parts>()) {
    vtkRenderer* renderer = parts_->renderer;
    renderer->SetLayer(1);
    renderer->InteractiveOff();
    renderer->GetActiveCamera()->ParallelProjectionOn();
    for (Drawn* drawn : {&parts_->fill, &parts_->outline, &parts_->arrow, &parts_->axis})
      renderer->AddActor(drawn->actor);
    parts_->fill.actor->GetProperty()->SetOpacity(0.16);
    parts_->outline.actor->GetProperty()->SetLineWidth(1.4F);
    parts_->arrow_source->SetTipResolution(32);
    parts_->arrow_source->SetShaftResolution(24);
    parts_->arrow.mapper->SetInputConnection(parts_->arrow_source->GetOutputPort());
    parts_->arrow.actor->GetProperty()->SetOpacity(0.55);
    parts_->axis.mapper->SetInputConnection(parts_->axis_line->GetOutputPort());
    parts_->axis.actor->GetProperty()->SetLineWidth(1.6F);
    parts_->update();
  }

  void attachTo(vtkRenderWindow* window) { window->AddRenderer(parts_->renderer); }
  void detachFrom(vtkRenderWindow* window) { window->RemoveRenderer(parts_->renderer); }
  void setColors(const SceneColors& colors) {
    Rgb color = colors.arrow_head;
    for (Drawn* drawn : {&parts_->fill, &parts_->outline, &parts_->arrow, &parts_->axis}) {
      drawn->actor->GetProperty()->SetColor(color.data());
    }
  }

  /// `first` and `count`: the cells of the layout that are shown.
  void setPatch(const SceneLayout& layout, std::size_t first, std::size_t count) {
    parts_->cells = count;
    const std::size_t per_cell = layout.pointsPerCell();
    Eigen::AlignedBox3d box;
    vtkNew<vtkPoints> corners;
    vtkNew<vtkPoints> dash_ends;
    vtkNew<vtkCellArray> faces;
    vtkNew<vtkCellArray> dashes;
    for (std::size_t cell = first; cell < first + count; ++cell) {
      const Eigen::Vector3d* corner = &layout.points[per_cell * cell];
      for (vtkIdType k = 0; k < kGhostSides; ++k) box.extend(corner[k]);
      if (count > kMaxCells) continue;
      std::array<vtkIdType, kGhostSides> ids{};
      for (vtkIdType k = 0; k < kGhostSides; ++k) {
        const auto index = static_cast<std::size_t>(k);
        ids.at(index) = corners->InsertNextPoint(corner[k].data());
        // OpenGL of today draws no dashes: they are lines of their own.
        const Eigen::Vector3d along = (corner[(k + 1) % kGhostSides] - corner[k]) / (2 * kDashesPerSide);
        for (int dash = 0; dash < kDashesPerSide; ++dash) {
          const Eigen::Vector3d from = corner[k] + 2 * dash * along;
          const Eigen::Vector3d to = from + 1.1 * along;
          const vtkIdType begin = dash_ends->InsertNextPoint(from.data());
          const vtkIdType end = dash_ends->InsertNextPoint(to.data());
          dashes->InsertNextCell({begin, end});
        }
      }
      faces->InsertNextCell(kGhostSides, ids.data());
    }
    parts_->center = box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center());
    parts_->radius_m = 0;
    for (std::size_t k = per_cell * first; k < per_cell * (first + count); ++k) {
      parts_->radius_m = std::max(parts_->radius_m, (layout.points[k] - parts_->center).norm());
    }
    vtkNew<vtkPolyData> fill;
    fill->SetPoints(corners);
    fill->SetPolys(faces);
    parts_->fill.mapper->SetInputData(fill);
    vtkNew<vtkPolyData> outline;
    outline->SetPoints(dash_ends);
    outline->SetLines(dashes);
    parts_->outline.mapper->SetInputData(outline);
    parts_->update();
  }

  /// Unit vectors in the patch frame: where up is now and where it is to be. Without the latter there is no ghost.
  void setTurn(const Eigen::Vector3d& from_up, const std::optional<Eigen::Vector3d>& to_up) {
    parts_->from_up = from_up;
    parts_->to_up = to_up;
    parts_->update();
  }

  /// Share of the turn that is done, 0 to 1.
  void setPhase(double phase) {
    parts_->phase = std::clamp(phase, 0.0, 1.0);
    parts_->update();
  }

  [[nodiscard]] bool isVisible() const { return parts_->isVisible(); }
  [[nodiscard]] bool isArrow() const { return parts_->isArrow(); }
  /// Looks the same way as `camera`, and keeps its place in the window; called before each rendering.
  void follow(vtkCamera* camera, vtkRenderWindow* window) {
    if (!isVisible()) return;
    const int* size = window->GetSize();
    if (size[0] <= 0 || size[1] <= 0) return;
    const auto [left, bottom, right, top] = placeIn(size[0], size[1]);
    parts_->renderer->SetViewport(left / size[0], bottom / size[1], right / size[0], top / size[1]);
    double back[3];
    camera->GetDirectionOfProjection(back);
    double up[3];
    camera->GetViewUp(up);
    const double away = 4 * parts_->radius_m;
    vtkCamera* own = parts_->renderer->GetActiveCamera();
    own->SetFocalPoint(0, 0, 0);
    own->SetPosition(-away * back[0], -away * back[1], -away * back[2]);
    own->SetViewUp(up);
    own->SetParallelScale(kMargin * parts_->radius_m);
    own->SetClippingRange(0.4 * away, 1.6 * away);
  }

  /// Its place in a window of this size: left, bottom, right and top, from the lower left.
  static std::array<double, 4> placeIn(double width, double height) {
    const double side = std::min(kShare * width, kMostHeight * height);
    const double right = (1 - kBesideEdge) * width;
    const double bottom = kMiddleHeight * height - 0.5 * side;
    return {right - side, bottom, right, bottom + side};
  }

 private:
  static constexpr vtkIdType kGhostSides = 6;
  static constexpr int kDashesPerSide = 4;
  static constexpr double kMargin = 1.06;        // around the patch
  static constexpr double kMiddleHeight = 0.55;  // share of the window's height
  static constexpr double kMostHeight = 0.56;
  static constexpr double kBesideEdge = 0.02;
  struct Drawn {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    Drawn() {
      actor->SetMapper(mapper);
      actor->GetProperty()->LightingOff();
      actor->PickableOff();
    }
  };

  struct Parts {
    vtkNew<BlendingRenderer> renderer;
    Drawn fill;
    Drawn outline;
    Drawn arrow;
    Drawn axis;  ///< about which it turns
    vtkNew<vtkLineSource> axis_line;
    vtkNew<vtkArrowSource> arrow_source;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    double radius_m = 0;
    std::size_t cells = 0;
    Eigen::Vector3d from_up = Eigen::Vector3d::UnitZ();
    std::optional<Eigen::Vector3d> to_up;
    double phase = 1;

    [[nodiscard]] bool isVisible() const { return to_up && cells > 0; }
    [[nodiscard]] bool isArrow() const { return cells > kMaxCells; }
    /// The ghost turns in the frame of the part as it is held now, in which the camera stands too.
    void update() {
      renderer->SetDraw(isVisible());
      fill.actor->SetVisibility(!isArrow());
      outline.actor->SetVisibility(!isArrow());
      arrow.actor->SetVisibility(isArrow());
      if (!isVisible()) return;
      const Eigen::Vector3d turn = logSO3(shortestRotation(*to_up, from_up));
      const Eigen::Matrix3d R = expSO3(phase * turn);
      axis.actor->SetVisibility(turn.norm() >= kThere_rad);
      if (turn.norm() >= kThere_rad) {
        const Eigen::Vector3d end = radius_m * turn.normalized();
        axis_line->SetPoint1(-end.x(), -end.y(), -end.z());
        axis_line->SetPoint2(end.x(), end.y(), end.z());
      }
      const auto set = [](vtkActor* actor, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
        vtkNew<vtkMatrix4x4> matrix;
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, rotation(row, column));
          matrix->SetElement(row, 3, translation(row));
        }
        actor->SetUserMatrix(matrix);
      };
      set(fill.actor, R, -(R * center));
      set(outline.actor, R, -(R * center));
      // The arrow is as large as the patch would be, with its middle in the middle.
      const Eigen::Matrix3d along = R * shortestRotation(Eigen::Vector3d::UnitX(), *to_up);
      set(arrow.actor, 1.4 * radius_m * along, -0.7 * radius_m * along.col(0));
    }
  };
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
