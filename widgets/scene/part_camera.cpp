#include "widgets/scene/part_camera.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/util/units.h"

#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <cmath>

namespace hexoderm {
namespace {

Eigen::Vector3d backOf(vtkCamera* camera) { return -toEigen(camera->GetDirectionOfProjection()); }

/// Looks at the focal point from `back` (unit). If it looks along `up`, `other_up` is upwards instead.
void lookFrom(vtkCamera* camera, const Eigen::Vector3d& back, const Eigen::Vector3d& up,
              const Eigen::Vector3d& other_up) {
  constexpr double kAlong = 0.02;
  const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
  const Eigen::Vector3d position = focus + camera->GetDistance() * back;
  const Eigen::Vector3d& upwards = back.cross(up).norm() > kAlong ? up : other_up;
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetViewUp(upwards.x(), upwards.y(), upwards.z());
  camera->OrthogonalizeViewUp();
}

}  // namespace

void turnCameraWithPart(vtkCamera* camera, const Eigen::Vector3d& from_up, const Eigen::Vector3d& to_up) {
  const Eigen::Matrix3d turn = shortestRotation(from_up, to_up);
  lookFrom(camera, turn * backOf(camera), to_up, turn * toEigen(camera->GetViewUp()));
}

void standCameraUpright(vtkCamera* camera, const Eigen::Vector3d& up) {
  constexpr double kElevation = 20 * kDegree;
  constexpr double kTooSteep = 0.2;
  const Eigen::Vector3d back = backOf(camera);
  Eigen::Vector3d level = back - back.dot(up) * up;
  // Seen from right above or below, its upper edge becomes its far side.
  if (level.norm() < kTooSteep) {
    const Eigen::Vector3d view_up = toEigen(camera->GetViewUp());
    level = (back.dot(up) > 0 ? -1 : 1) * (view_up - view_up.dot(up) * up);
  }
  lookFrom(camera, std::cos(kElevation) * level.normalized() + std::sin(kElevation) * up, up, up.unitOrthogonal());
}

void spinPartInPicture(vtkCamera* camera, const Eigen::Vector3d& up, double angle_rad) {
  const Eigen::Matrix3d turn = expSO3(-angle_rad * up);
  lookFrom(camera, turn * backOf(camera), turn * toEigen(camera->GetViewUp()), up);
}

Eigen::Vector3d rightInPicture(vtkCamera* camera, const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = toEigen(camera->GetViewUp()).cross(backOf(camera));
  const Eigen::Vector3d level = right - right.dot(up) * up;
  return level.norm() > 1e-9 ? level.normalized() : up.unitOrthogonal();
}

}  // namespace hexoderm
