#pragma once

#include "hexoderm/util/ids.h"

#include <Eigen/Core>
#include <optional>

class vtkCamera;

namespace hexoderm {

class PatchScene;

/// Where a camera stands, and where it looks. Metres, in the scene's frame.
struct CameraStand {
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();  ///< unit, from the focus to the camera
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();    ///< unit, perpendicular to it
  double distance = 1;
};
CameraStand standOf(vtkCamera* camera);

/// Where a cell is seen from: in the middle of the picture, large enough to be read, from the side where its front is
/// not hidden. The camera turns and comes closer no further than that takes. Where an up direction is followed, it
/// stays upwards: the camera only goes round it. None if the scene does not have the cell.
std::optional<CameraStand> standBefore(PatchScene& scene, CellId cell);
/// The same of the middle of a link.
std::optional<CameraStand> standBefore(PatchScene& scene, LinkEnd a, LinkEnd b);

/// The way of a camera from one stand to another. Each step is made from where the camera is then, so that a picture
/// that follows a part meanwhile stays upright.
class CameraGlide {
 public:
  /// From where the camera is. `up`: upwards in the picture all the way; none: the shortest turn.
  CameraGlide(vtkCamera* camera, const CameraStand& to, const std::optional<Eigen::Vector3d>& up);
  /// `share` of the way, 0 to 1, never less than before.
  void moveTo(double share);

 private:
  vtkCamera* camera_;
  CameraStand from_;
  CameraStand to_;
  Eigen::Vector3d turn_;  ///< of the whole way, rad
  double done_ = 0;
};

}  // namespace hexoderm
