#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <Eigen/Core>

#include <cmath>

namespace hexoderm {

inline Eigen::Vector3d backOfCamera(vtkCamera* camera) { return -toEigen(camera->GetDirectionOfProjection()); }

/// Looks at the focal point from `back` (unit). If it looks along `up`, `other_up` is upwards instead.
inline void lookFromBack(vtkCamera* camera, const Eigen::Vector3d& back, const Eigen::Vector3d& up,
                         const Eigen::Vector3d& other_up) {
  constexpr double kAlong = 0.02;
  const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
  const Eigen::Vector3d position = focus + camera->GetDistance() * back;
  const Eigen::Vector3d& upwards = back.cross(up).norm() > kAlong ? up : other_up;
  camera->SetPosition(position.data());
  camera->SetViewUp(upwards.data());
  camera->OrthogonalizeViewUp();
}

// Functions that move the camera of the 3D scene with the part that is held. Directions are up directions, unit vectors
// in the scene's frame, which is the patch's: the part stays where it is there, and the camera goes round it.

/// Turns the camera about its focal point as the world turns about the part when up goes from one direction to another:
/// by the smallest rotation, so that the part does not spin about gravity. Up is upwards in the picture afterwards, and
/// the camera looks at the part from as far above as before.
inline void turnCameraWithPart(vtkCamera* camera, const Eigen::Vector3d& from_up, const Eigen::Vector3d& to_up) {
  const Eigen::Matrix3d turn = shortestRotation(from_up, to_up);
  lookFromBack(camera, turn * backOfCamera(camera), to_up, turn * toEigen(camera->GetViewUp()));
}

/// Up is upwards in the picture, seen a little from above, from about the side it was seen from before.
inline void standCameraUpright(vtkCamera* camera, const Eigen::Vector3d& up) {
  constexpr double kElevation = 20 * kDegree;
  constexpr double kTooSteep = 0.2;
  const Eigen::Vector3d back = backOfCamera(camera);
  Eigen::Vector3d level = back - back.dot(up) * up;
  // Seen from right above or below, its upper edge becomes its far side.
  if (level.norm() < kTooSteep) {
    const Eigen::Vector3d view_up = toEigen(camera->GetViewUp());
    level = (back.dot(up) > 0 ? -1 : 1) * (view_up - view_up.dot(up) * up);
  }
  lookFromBack(camera, std::cos(kElevation) * level.normalized() + std::sin(kElevation) * up, up, up.unitOrthogonal());
}

/// Turns the camera about up through its focal point: the part seems to turn by `angle_rad`, counter-clockwise seen
/// from above.
inline void spinPartInPicture(vtkCamera* camera, const Eigen::Vector3d& up, double angle_rad) {
  const Eigen::Matrix3d turn = expSO3(-angle_rad * up);
  lookFromBack(camera, turn * backOfCamera(camera), turn * toEigen(camera->GetViewUp()), up);
}

/// The direction to the right in the picture, perpendicular to `up`.
inline Eigen::Vector3d rightInPicture(vtkCamera* camera, const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = toEigen(camera->GetViewUp()).cross(backOfCamera(camera));
  const Eigen::Vector3d level = right - right.dot(up) * up;
  return level.norm() > 1e-9 ? level.normalized() : up.unitOrthogonal();
}

}  // namespace hexoderm
