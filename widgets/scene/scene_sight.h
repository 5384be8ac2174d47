#pragma once

#include "hexoderm/base/units.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <Eigen/Core>

#include <array>
#include <cmath>

namespace hexoderm {

/// From where a scene is seen, in its frame, and where its points are in the picture. Pixels count from the window's
/// lower left corner.
struct SceneSight {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< with `up` and `back` (towards the viewer) a right-handed frame
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double pixels_per_m = 1;  ///< in parallel projection; in perspective one metre before the eye
  Eigen::Vector2d middle_px = Eigen::Vector2d::Zero();  ///< the pixel straight ahead
  std::array<int, 2> window{};
  double text_scale = 1;  ///< pixels of a letter per pixel at 72 dpi

  static SceneSight of(vtkCamera* camera, const std::array<int, 2>& window, int dpi) {
    SceneSight sight;
    sight.eye = toEigen(camera->GetPosition());
    sight.back = -toEigen(camera->GetDirectionOfProjection());
    sight.right = toEigen(camera->GetViewUp()).cross(sight.back).normalized();
    sight.up = sight.back.cross(sight.right);
    sight.parallel = camera->GetParallelProjection() != 0;
    sight.pixels_per_m =
        0.5 * window[1] /
        (sight.parallel ? camera->GetParallelScale() : std::tan(0.5 * camera->GetViewAngle() * kDegree));
    const double* center = camera->GetWindowCenter();
    sight.middle_px = {0.5 * window[0] * (1 - center[0]), 0.5 * window[1] * (1 - center[1])};
    sight.window = window;
    sight.text_scale = dpi / 72.0;
    return sight;
  }

  /// Pixels per metre at this distance before the eye; 0 behind it.
  [[nodiscard]] double scaleAt(double depth_m) const {
    return parallel ? pixels_per_m : depth_m > 0 ? pixels_per_m / depth_m : 0;
  }
  [[nodiscard]] double depthOf(const Eigen::Vector3d& p) const { return (eye - p).dot(back); }
  [[nodiscard]] bool isAhead(const Eigen::Vector3d& p) const { return parallel || depthOf(p) > 1e-6; }
  /// Unit, from the point to the viewer.
  [[nodiscard]] Eigen::Vector3d towards(const Eigen::Vector3d& p) const {
    return parallel ? back : Eigen::Vector3d((eye - p).normalized());
  }
  /// The pixel of a point ahead.
  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector3d& p) const {
    return middle_px + scaleAt(depthOf(p)) * Eigen::Vector2d((p - eye).dot(right), (p - eye).dot(up));
  }
  /// The point that a pixel shows at this distance before the eye.
  [[nodiscard]] Eigen::Vector3d pointAt(const Eigen::Vector2d& pixel, double depth_m) const {
    const Eigen::Vector2d across = (pixel - middle_px) / scaleAt(depth_m);
    return eye + across.x() * right + across.y() * up - depth_m * back;
  }
  friend bool operator==(const SceneSight&, const SceneSight&) = default;
};

}  // namespace hexoderm
