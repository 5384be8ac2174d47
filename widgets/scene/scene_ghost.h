#pragma once

#include "widgets/scene/cell_meshes.h"
#include "widgets/style/scene_colors.h"

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>

class vtkCamera;
class vtkRenderWindow;

namespace hexoderm {

/// The patch as it should be held next: its front faces with dashed outlines, small, on the right of the scene. It is
/// seen from where the scene is seen from, and turns from the present orientation to the next one about an axis that is
/// drawn through it. A skin of more than kMaxCells is shown as an arrow that is to point up.
class SceneGhost {
 public:
  static constexpr std::size_t kMaxCells = 2000;
  static constexpr double kShare = 0.34;  ///< share of the window's width

  SceneGhost();
  ~SceneGhost();

  void attachTo(vtkRenderWindow* window);
  void detachFrom(vtkRenderWindow* window);
  void setColors(const SceneColors& colors);
  void setSmoothed(bool smoothed);

  /// `first` and `count`: the cells of the layout that are shown.
  void setPatch(const SceneLayout& layout, std::size_t first, std::size_t count);
  /// Unit vectors in the patch frame: where up is now and where it is to be. Without the latter there is no ghost.
  void setTurn(const Eigen::Vector3d& from_up, const std::optional<Eigen::Vector3d>& to_up);
  /// Share of the turn that is done, 0 to 1.
  void setPhase(double phase);

  [[nodiscard]] bool isVisible() const;
  [[nodiscard]] bool isArrow() const;
  /// Looks the same way as `camera`, and keeps its place in the window; called before each rendering.
  void follow(vtkCamera* camera, vtkRenderWindow* window);

  /// Its place in a window of this size: left, bottom, right and top, from the lower left.
  static std::array<double, 4> placeIn(double width, double height);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
