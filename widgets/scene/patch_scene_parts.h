#pragma once

#include "widgets/scene/blending_renderer.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/scene_labels.h"
#include "widgets/scene/scene_skin.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// What a scene is made of. Where its camera stands, patch_scene_camera.cpp says; what there is to see,
/// patch_scene.cpp.
struct PatchScene::Parts {
  static constexpr double kViewAngle_deg = 30;

  std::shared_ptr<const SceneContent> content;
  SceneColors colors;
  std::optional<CellId> picked_cell;
  std::optional<std::pair<LinkEnd, LinkEnd>> picked_link;
  std::optional<PoseId> pose;
  bool text_visible = true;
  ShownItems shown = kShownAtFirst;

  vtkNew<BlendingRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  unsigned long observer = 0;
  SceneSkin skin{renderer};
  SceneOverlays extras{renderer};
  SceneLabels labels{renderer};
  vtkNew<vtkActor> selection_actor;
  vtkNew<vtkPolyDataMapper> selection_mapper;
  SceneCorners corners;
  SceneGhost ghost;
  std::optional<Eigen::Vector3d> up_o;       ///< now
  std::optional<Eigen::Vector3d> next_up_o;  ///< of the ghost

  bool fit_pending = false;
  bool content_is_new = false;  ///< since the last picture
  int top_margin = 0;           ///< pixels
  /// Camera, window and patch as the last fit left them: while nobody has moved the camera, a resized window or a patch
  /// that has taken another shape (flat at first, bent from the first poses on) is fitted again.
  struct Fitted {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    double parallel_scale = 0;
    std::array<int, 2> size{};
    double extent_m = 0;
  };
  std::optional<Fitted> fitted;
  struct KeptView {
    Eigen::Vector3d back;
    Eigen::Vector3d up;
  };
  std::optional<KeptView> kept_view;

  Parts();
  ~Parts();

  void lookFrom(View view);
  void fitNow();
  /// How far the camera has to go to its right so that the arrow of gravity covers none of the points, which are seen
  /// from (right, up, towards the viewer) around what is looked at. None if others would leave the picture.
  [[nodiscard]] std::optional<double> shiftPastArrow(const std::vector<Eigen::Vector3d>& seen, double distance) const;
  /// Nobody has moved the camera since the last fit.
  [[nodiscard]] bool isUntouched() const;
  /// The patch has another shape than it was fitted with, or part of it has come close to the edge of the picture.
  [[nodiscard]] bool hasOutgrownTheFit() const;
  /// Shares of the window.
  [[nodiscard]] double freeWidth() const;
  [[nodiscard]] double freeHeight() const;
  /// What a patch that grows may go beyond the fit until it is fitted again, in half heights of the window.
  [[nodiscard]] double slackAbove() const;
  /// The upper left corner of where the arrow of gravity and its word are, in half windows from the window's middle.
  [[nodiscard]] Eigen::Vector2d cornerFrom(int around_px) const;
  /// Where the middle of the window is, seen from what the camera looks at, in half windows.
  [[nodiscard]] Eigen::Vector2d windowCenter() const;
  /// The free part of the window has the focus in its middle.
  void centerInFreePart();
  void beforeRender();
  void recolor();
  void updateItems();
  void updateSelection();
  void updateGravity();
  void updateGhost();
  void showGhostOfLargestPatch();
  void follow(const std::optional<Eigen::Vector3d>& up_o_now);
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const;
  [[nodiscard]] const GravityDirection* gravity() const;
  [[nodiscard]] std::array<int, 2> size() const;
};

}  // namespace hexoderm
