#include "hexoderm/util/units.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/patch_scene_parts.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

constexpr double kEdge = 0.08;  // half the window: what a patch that grows may go beyond the fit
// Parts of the window that a fitted skin fills: the legend below stays free, and what covers the top.
constexpr double kFitWidth = 0.88;
constexpr double kFitHeight = 0.74;
constexpr double kLeastFitHeight = 0.4;
constexpr double kBelowTop = 0.02;  // between what covers the top and the skin

struct ViewDirection {
  Eigen::Vector3d from;  ///< unit, from what is looked at to the camera
  Eigen::Vector3d up;
};

ViewDirection directionOf(PatchScene::View view) {
  switch (view) {
    case PatchScene::View::Front:
      return {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
    case PatchScene::View::Side:
      return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
    case PatchScene::View::Top:
      return {Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()};
    case PatchScene::View::Oblique:
      break;
  }
  return {Eigen::Vector3d(0.45, 0.42, 1.0).normalized(), Eigen::Vector3d::UnitY()};
}

}  // namespace

std::array<int, 2> PatchScene::Parts::size() const {
  if (!window) return {0, 0};
  const int* pixels = window->GetSize();
  return {pixels[0], pixels[1]};
}

double PatchScene::Parts::freeWidth() const { return ghost.isVisible() ? kFitWidth - SceneGhost::kShare : kFitWidth; }

double PatchScene::Parts::freeHeight() const {
  const int height = size()[1];
  if (height <= 0) return kFitHeight;
  const double below = 0.5 * (1 - kFitHeight);
  const double above = static_cast<double>(top_margin) / height;
  return std::max(kLeastFitHeight, 1 - below - std::max(below, above + kBelowTop));
}

double PatchScene::Parts::slackAbove() const {
  const double fitted_top = 2 * freeHeight() - kFitHeight;
  const double covered_from = 1 - 2.0 * top_margin / std::max(1, size()[1]);
  return std::clamp(covered_from - fitted_top, 0.0, kEdge);
}

Eigen::Vector2d PatchScene::Parts::cornerFrom(int around_px) const {
  const auto [width, height] = size();
  const double scale = window ? window->GetDPI() / 72.0 : 1;
  return {1 - 2 * scale * (SceneCorners::kRight + SceneCorners::kSize + around_px) / width,
          -1 + 2 * scale * (SceneCorners::kBottom + SceneCorners::kSize + SceneCorners::kWord + around_px) / height};
}

Eigen::Vector2d PatchScene::Parts::windowCenter() const {
  return {ghost.isVisible() ? SceneGhost::kShare : 0, kFitHeight - freeHeight()};
}

void PatchScene::Parts::centerInFreePart() {
  const Eigen::Vector2d center = windowCenter();
  renderer->GetActiveCamera()->SetWindowCenter(center.x(), center.y());
}

void PatchScene::Parts::lookFrom(View view) {
  const ViewDirection direction = directionOf(view);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
  const Eigen::Vector3d position = focus + std::max(camera->GetDistance(), 1e-3) * direction.from;
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetViewUp(direction.up.x(), direction.up.y(), direction.up.z());
  camera->OrthogonalizeViewUp();
  fit_pending = true;
}

std::optional<double> PatchScene::Parts::shiftPastArrow(const std::vector<Eigen::Vector3d>& seen,
                                                        double distance) const {
  constexpr int kAround_px = 8;
  const auto [width, height] = size();
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  const Eigen::Vector2d corner = cornerFrom(kAround_px) + windowCenter();
  const double tan_height = std::tan(0.5 * kViewAngle_deg * kDegree);
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : seen) {
    const double half_height = tan_height * (parallel ? distance : distance - v.z());
    const double half_width = half_height * width / height;
    if (v.y() < corner.y() * half_height) least = std::max(least, v.x() - corner.x() * half_width);
    most = std::min(most, v.x() + freeWidth() * half_width);
  }
  if (least > 0 && least > most) return std::nullopt;
  return least;
}

void PatchScene::Parts::fitNow() {
  const auto [width, height] = size();
  if (!content || content->layout.points.empty() || width <= 0 || height <= 0) return;
  fit_pending = false;
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d up =
      (toEigen(camera->GetViewUp()) - toEigen(camera->GetViewUp()).dot(back) * back).normalized();
  const Eigen::Vector3d right = up.cross(back);
  Eigen::AlignedBox3d box;
  const std::vector<Eigen::Vector3d>& points = content->layout.points;
  for (const Eigen::Vector3d& p : points) box.extend(Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)));
  const Eigen::Vector3d center = box.center();
  const double tan_height = freeHeight() * std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = freeWidth() * std::tan(0.5 * kViewAngle_deg * kDegree) * width / height;
  const double least = 2 * content->reconstruction->model->side_m;
  double distance = least;
  double flat_distance = least;  // from where a skin without depth would fit
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d v = Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)) - center;
    seen.push_back(v);
    // A part that is turned has to stay in the picture.
    if (up_o) distance = std::max(distance, v.norm() / std::sin(std::atan(std::min(tan_width, tan_height))));
    const double flat = up_o ? v.norm() / std::min(tan_width, tan_height)
                             : std::max(std::abs(v.x()) / tan_width, std::abs(v.y()) / tan_height);
    flat_distance = std::max(flat_distance, flat);
    distance = std::max(distance, v.z() + flat);
  }
  double shift = 0;
  // A part that is turned has room on all sides.
  if (upShown() && !up_o) {
    constexpr double kFarther = 1.04;
    constexpr double kFarthest = 1.5;
    for (double away = 1; away < kFarthest; away *= kFarther) {
      const auto found = shiftPastArrow(seen, away * (camera->GetParallelProjection() != 0 ? flat_distance : distance));
      if (!found) continue;
      shift = *found;
      distance *= away;
      flat_distance *= away;
      break;
    }
  }
  const Eigen::Vector3d focus = right * (center.x() + shift) + up * center.y() + back * center.z();
  const Eigen::Vector3d position = focus + distance * back;
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetParallelScale(flat_distance * std::tan(0.5 * kViewAngle_deg * kDegree));
  fitted = Fitted{position, focus, camera->GetParallelScale(), {width, height}, content->extent_m};
}

bool PatchScene::Parts::isUntouched() const {
  vtkCamera* camera = renderer->GetActiveCamera();
  return fitted && fitted->position == toEigen(camera->GetPosition()) &&
         fitted->focus == toEigen(camera->GetFocalPoint()) && fitted->parallel_scale == camera->GetParallelScale();
}

bool PatchScene::Parts::hasOutgrownTheFit() const {
  // Small changes, as every new pose brings them, must not make the picture jump.
  constexpr double kOtherShape = 0.1;
  if (std::abs(content->extent_m - fitted->extent_m) > kOtherShape * fitted->extent_m) return true;
  const auto [width, height] = size();
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d position = toEigen(camera->GetPosition());
  const Eigen::Vector3d ahead = toEigen(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = ahead.cross(toEigen(camera->GetViewUp())).normalized();
  const Eigen::Vector3d up = right.cross(ahead);
  const double tan_height = std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = tan_height * width / height;
  const bool has_arrow = upShown() && !up_o;
  const Eigen::Vector2d corner = cornerFrom(0) + windowCenter();
  return std::any_of(content->layout.points.begin(), content->layout.points.end(), [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = p - position;
    const double depth = camera->GetParallelProjection() ? camera->GetParallelScale() / tan_height : v.dot(ahead);
    return std::abs(v.dot(right)) > (freeWidth() + kEdge) * tan_width * depth ||
           v.dot(up) > (freeHeight() + slackAbove()) * tan_height * depth ||
           -v.dot(up) > (freeHeight() + kEdge) * tan_height * depth ||
           (has_arrow && v.dot(right) > corner.x() * tan_width * depth && v.dot(up) < corner.y() * tan_height * depth);
  });
}

void PatchScene::Parts::follow(const std::optional<Eigen::Vector3d>& up_o_now) {
  const bool untouched = isUntouched();
  vtkCamera* camera = renderer->GetActiveCamera();
  if (up_o_now && up_o) {
    turnCameraWithPart(camera, *up_o, *up_o_now);
  } else if (up_o_now) {
    standCameraUpright(camera, *up_o_now);
  }
  // Following is not somebody's hand on the camera.
  if (untouched) fitted->position = toEigen(camera->GetPosition());
  if (up_o_now.has_value() != up_o.has_value() && (untouched || !fitted)) fit_pending = true;
  up_o = up_o_now;
  updateGravity();
  updateGhost();
}

void PatchScene::spin(double angle_rad) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const Eigen::Vector3d up = parts_->upShown().value_or(toEigen(camera->GetViewUp()));
  const bool untouched = parts_->isUntouched();
  spinPartInPicture(camera, up, angle_rad);
  if (untouched) parts_->fitted->position = toEigen(camera->GetPosition());
}

void PatchScene::keepView() {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  parts_->kept_view = Parts::KeptView{-toEigen(camera->GetDirectionOfProjection()), toEigen(camera->GetViewUp())};
}

void PatchScene::returnToKeptView() {
  if (!parts_->kept_view) return;
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  const Eigen::Vector3d& up = parts_->kept_view->up;
  const Eigen::Vector3d position = toEigen(camera->GetFocalPoint()) + camera->GetDistance() * parts_->kept_view->back;
  camera->SetPosition(position.x(), position.y(), position.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  parts_->kept_view.reset();
  parts_->fit_pending = true;
}

void PatchScene::showStandardView(View view) { parts_->lookFrom(view); }

void PatchScene::setParallel(bool parallel) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  if ((camera->GetParallelProjection() != 0) == parallel) return;
  const double half = std::tan(0.5 * Parts::kViewAngle_deg * kDegree);
  if (parts_->isUntouched()) {
    parts_->fit_pending = true;
  } else if (parallel) {
    camera->SetParallelScale(camera->GetDistance() * half);
  } else {
    const Eigen::Vector3d focus = toEigen(camera->GetFocalPoint());
    const Eigen::Vector3d back = -toEigen(camera->GetDirectionOfProjection());
    const Eigen::Vector3d position = focus + camera->GetParallelScale() / half * back;
    camera->SetPosition(position.x(), position.y(), position.z());
  }
  camera->SetParallelProjection(parallel);
}

}  // namespace hexoderm
