#pragma once

#include "widgets/style/scene_colors.h"

#include <Eigen/Core>
#include <memory>
#include <optional>

class vtkCamera;
class vtkRenderWindow;

namespace hexoderm {

/// One end of one of the patch frame's axes.
struct AxisEnd {
  std::size_t axis = 0;  ///< x, y, z
  bool positive = true;
  friend bool operator==(const AxisEnd&, const AxisEnd&) = default;
};

/// The two small pictures in the scene's lower corners, which turn with it: the patch frame's axes on the left, with a
/// knob on each end, and the direction of gravity on the right. Both lie on plates that keep them readable over cells.
class SceneCorners {
 public:
  // Size in pixels at 72 dpi. Below the corners there is room for a legend, right of the arrow for its word.
  static constexpr int kSize = 84;
  static constexpr int kBottom = 34;
  static constexpr int kLeft = 14;
  static constexpr int kRight = 14;
  static constexpr int kWord = 30;  ///< above the arrow

  SceneCorners();
  ~SceneCorners();

  void attachTo(vtkRenderWindow* window);
  void detachFrom(vtkRenderWindow* window);
  void setColors(const SceneColors& colors);
  /// Unit vector in the patch frame; none hides the arrow.
  void setDown(const std::optional<Eigen::Vector3d>& down_o);
  void setAxesVisible(bool visible);
  void setTextVisible(bool visible);
  void setSmoothed(bool smoothed);
  /// Looks the same way as `camera`, and keeps the size in pixels; called before each rendering.
  void follow(vtkCamera* camera, vtkRenderWindow* window);

  /// The knob that is drawn at a pixel of the window (origin lower left), as it was followed last.
  [[nodiscard]] std::optional<AxisEnd> endAt(double x, double y) const;
  /// Makes this knob larger; true if another one was before.
  bool setHovered(const std::optional<AxisEnd>& end);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
