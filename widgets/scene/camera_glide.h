#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/scene/scene_pointing.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace hexoderm {

/// Where a camera stands, and where it looks. Metres, in the scene's frame.
struct CameraStand {
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();
  Eigen::Vector3d back = Eigen::Vector3d::UnitZ();  ///< unit, from the focus to the camera
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();    ///< unit, perpendicular to it
  double distance = 1;
};

/// Height of the picture where a cell is large enough, in sides of a cell: 640 pixels show it 64 pixels high.
inline constexpr double kReadableHeight = 20;
/// The obliquer, the less is seen of a cell.
inline constexpr double kOblique = 65 * kDegree;
inline double halfAngleOf(vtkCamera* camera) { return std::tan(0.5 * camera->GetViewAngle() * kDegree); }

inline CameraStand standOf(vtkCamera* camera) {
  CameraStand stand;
  stand.focus = toEigen(camera->GetFocalPoint());
  stand.back = -toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d up = toEigen(camera->GetViewUp());
  stand.up = (up - up.dot(stand.back) * stand.back).normalized();
  stand.distance =
      camera->GetParallelProjection() != 0 ? camera->GetParallelScale() / halfAngleOf(camera) : camera->GetDistance();
  return stand;
}

inline void placeCamera(vtkCamera* camera, const CameraStand& stand) {
  const Eigen::Vector3d position = stand.focus + stand.distance * stand.back;
  camera->SetFocalPoint(stand.focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(stand.up.data());
  camera->SetParallelScale(stand.distance * halfAngleOf(camera));
}

/// Turns the stand by a rotation about its focus.
inline CameraStand turnedAbout(CameraStand stand, const Eigen::Matrix3d& R) {
  stand.back = (R * stand.back).normalized();
  stand.up = R * stand.up;
  stand.up = (stand.up - stand.up.dot(stand.back) * stand.back).normalized();
  return stand;
}

/// The angle about `up` from one direction to another, as far as both have one; 0 if not.
inline double azimuthBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& up) {
  const Eigen::Vector3d a = from - from.dot(up) * up;
  const Eigen::Vector3d b = to - to.dot(up) * up;
  constexpr double kUpright = 0.05;
  if (a.norm() < kUpright || b.norm() < kUpright) return 0;
  return std::atan2(a.cross(b).dot(up), a.dot(b));
}

/// Stands from which a face is seen better and better; the first is as the camera looks now.
inline std::vector<CameraStand> standsTowards(const CameraStand& now, const Eigen::Vector3d& normal,
                                              const std::optional<Eigen::Vector3d>& up) {
  std::vector<CameraStand> stands = {now};
  if (up) {
    const double azimuth = azimuthBetween(now.back, normal, *up);
    for (const double share : {0.6, 1.0}) stands.push_back(turnedAbout(now, expSO3(share * azimuth * *up)));
    return stands;
  }
  const double angle = angleBetween(now.back, normal);
  const Eigen::Vector3d turn = logSO3(shortestRotation(now.back, normal));
  for (const double left : {45 * kDegree, 20 * kDegree, 0.0}) {
    if (angle > left) stands.push_back(turnedAbout(now, expSO3((1 - left / angle) * turn)));
  }
  return stands;
}

inline CameraStand bestStand(PatchScene& scene, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                             const std::function<bool()>& is_seen) {
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  const CameraStand before = standOf(camera);
  CameraStand now = before;
  now.focus = point;
  const double side_m = scene.content()->reconstruction->model->side_m;
  now.distance = std::min(before.distance, 0.5 * kReadableHeight * side_m / halfAngleOf(camera));
  CameraStand best = now;
  for (const CameraStand& stand : standsTowards(now, normal, scene.moment().up_o)) {
    best = stand;
    if (angleBetween(stand.back, normal) > kOblique && !scene.moment().up_o) continue;
    placeCamera(camera, stand);
    scene.renderer()->ResetCameraClippingRange();
    if (is_seen()) break;
  }
  placeCamera(camera, before);
  scene.renderer()->ResetCameraClippingRange();
  return best;
}

/// Where a cell is seen from: in the middle of the picture, large enough to be read, from the side where its front is
/// not hidden. The camera turns and comes closer no further than that takes. Where an up direction is followed, it
/// stays upwards: the camera only goes round it. None if the scene does not have the cell.
inline std::optional<CameraStand> standBefore(PatchScene& scene, CellId id) {
  const SceneCell* cell = scene.content() == nullptr ? nullptr : scene.content()->layout.find(id);
  if (cell == nullptr) return std::nullopt;
  return bestStand(scene, cell->T_s_u.t, cell->T_s_u.R.col(2), [&] {
    const std::optional<SeenCell> seen = seenCell(scene, id);
    return seen && seen->is_seen;
  });
}

/// The same of the middle of a link.
inline std::optional<CameraStand> standBefore(PatchScene& scene, LinkEnd a, LinkEnd b) {
  if (scene.content() == nullptr) return std::nullopt;
  const SceneCell* source = scene.content()->layout.find(a.cell);
  const SceneCell* target = scene.content()->layout.find(b.cell);
  if (source == nullptr || target == nullptr) return std::nullopt;
  const Eigen::Vector3d normal = source->T_s_u.R.col(2) + target->T_s_u.R.col(2);
  return bestStand(
      scene, 0.5 * (source->T_s_u.t + target->T_s_u.t),
      normal.norm() > 1e-6 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d(source->T_s_u.R.col(2)), [&] {
        const std::optional<SeenCell> at_source = seenCell(scene, a.cell);
        const std::optional<SeenCell> at_target = seenCell(scene, b.cell);
        return at_source && at_target && (at_source->is_seen || at_target->is_seen);
      });
}

/// The way of a camera from one stand to another. Each step is made from where the camera is then, so that a picture
/// that follows a part meanwhile stays upright.
class CameraGlide {
 public:
  /// From where the camera is. `up`: upwards in the picture all the way; none: the shortest turn.
  CameraGlide(vtkCamera* camera, const CameraStand& to, const std::optional<Eigen::Vector3d>& up)
      : camera_(camera), from_(standOf(camera)), to_(to) {
    if (up) {
      turn_ = azimuthBetween(from_.back, to_.back, *up) * *up;
      return;
    }
    const auto axesOf = [](const CameraStand& stand) {
      Eigen::Matrix3d axes;
      axes << stand.up.cross(stand.back), stand.up, stand.back;
      return axes;
    };
    turn_ = logSO3(axesOf(to_) * axesOf(from_).transpose());
  }

  /// `share` of the way, 0 to 1, never less than before.
  void moveTo(double share) {
    CameraStand stand = turnedAbout(standOf(camera_), expSO3((share - done_) * turn_));
    done_ = share;
    stand.focus = from_.focus + share * (to_.focus - from_.focus);
    stand.distance = from_.distance * std::pow(to_.distance / from_.distance, share);
    placeCamera(camera_, stand);
  }

 private:
  vtkCamera* camera_;
  CameraStand from_;
  CameraStand to_;
  Eigen::Vector3d turn_;  ///< of the whole way, rad
  double done_ = 0;
};

}  // namespace hexoderm
