#include "widgets/scene/scene_camera.h"

#include "hexoderm/util/units.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/vtk_eigen.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kViewAngle_deg = 30;
constexpr double kEdge = 0.08;  // in half windows: a growing patch may exceed the fit by this much
// Shares of the window that a fitted skin fills: what covers the top and the bottom stays free.
constexpr double kFitWidth = 0.88;
constexpr double kFitHeight = 0.74;
constexpr double kLeastFitHeight = 0.4;
constexpr double kBetween = 0.02;  // between what covers top or bottom and the skin

struct ViewDirection {
  Eigen::Vector3d from;  ///< unit, from what is looked at to the camera
  Eigen::Vector3d up;
};

ViewDirection directionOf(SceneCamera::View view) {
  switch (view) {
    case SceneCamera::View::Front:
      return {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
    case SceneCamera::View::Side:
      return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
    case SceneCamera::View::Top:
      return {Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()};
    case SceneCamera::View::Back:
      return {-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()};
    case SceneCamera::View::OtherSide:
      return {-Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
    case SceneCamera::View::Bottom:
      return {-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    case SceneCamera::View::Isometric:
      return {Eigen::Vector3d::Ones().normalized(), Eigen::Vector3d::UnitY()};
    case SceneCamera::View::Oblique:
      break;
  }
  return {Eigen::Vector3d(0.45, 0.42, 1.0).normalized(), Eigen::Vector3d::UnitY()};
}

bool sameCells(const SceneContent* before, const SceneContent* after) {
  if (before == nullptr || after == nullptr) return before == after;
  return std::ranges::equal(before->layout.cells, after->layout.cells, {}, &SceneCell::id, &SceneCell::id);
}

/// Fewer than half of the cells are the same: not a skin that lost or gained some cells.
bool isOtherSkin(const SceneContent* before, const SceneContent* after) {
  const std::size_t had = before ? before->layout.cells.size() : 0;
  const std::size_t has = after ? after->layout.cells.size() : 0;
  if (had == 0 || has == 0) return had != has;
  const auto kept = std::ranges::count_if(
      after->layout.cells, [&](const SceneCell& cell) { return before->layout.find(cell.id) != nullptr; });
  return 2 * static_cast<std::size_t>(kept) < std::max(had, has);
}

}  // namespace

SceneCamera::SceneCamera(vtkRenderer* renderer) : renderer_(renderer) {
  camera()->SetViewAngle(kViewAngle_deg);
  lookFrom(View::Oblique);
}

vtkCamera* SceneCamera::camera() const { return renderer_->GetActiveCamera(); }

void SceneCamera::setContent(std::shared_ptr<const SceneContent> content) {
  const std::shared_ptr<const SceneContent> before = std::exchange(content_, std::move(content));
  content_is_new_ = true;
  if (sameCells(before.get(), content_.get())) return;
  if (isOtherSkin(before.get(), content_.get())) {
    lookFrom(View::Oblique);
  } else {
    fit();
  }
}

void SceneCamera::setTopMargin(int pixels) {
  if (std::exchange(top_margin_, pixels) != pixels) fitIfUntouched();
}

void SceneCamera::setMore(std::vector<Eigen::Vector3d> points) {
  if (points.empty() && more_.empty()) return;
  more_ = std::move(points);
  content_is_new_ = true;
  if (more_.empty() && fitted_ && fitted_->wider) fitIfUntouched();
}

void SceneCamera::setBottomMargin(int pixels) {
  if (std::exchange(bottom_margin_, pixels) != pixels) fitIfUntouched();
}

void SceneCamera::fitIfUntouched() {
  if (isUntouched()) fit_pending_ = true;
}

void SceneCamera::prepare(const Surroundings& around) {
  around_ = around;
  centerInFreePart();
  const bool outgrown = std::exchange(content_is_new_, false) && content_ && isUntouched() && hasOutgrownTheFit();
  if (fit_pending_ || outgrown || (isUntouched() && fitted_->window != around_.window)) fitNow();
}

void SceneCamera::fitIfPending(const Surroundings& around) {
  around_ = around;
  if (fit_pending_) fitNow();
}

double SceneCamera::freeWidth() const { return around_.ghost ? kFitWidth - SceneGhost::kShare : kFitWidth; }

double SceneCamera::freeFrom(int margin_px) const {
  constexpr double kLeast = 0.5 * (1 - kFitHeight);
  const int height = around_.window[1];
  return height <= 0 ? kLeast : std::max(kLeast, static_cast<double>(margin_px) / height + kBetween);
}

double SceneCamera::freeHeight() const {
  return std::max(kLeastFitHeight, 1 - freeFrom(bottom_margin_) - freeFrom(top_margin_));
}

double SceneCamera::slackAbove() const {
  const double fitted_top = 2 * (freeFrom(bottom_margin_) + freeHeight()) - 1;
  const double covered_from = 1 - 2.0 * top_margin_ / std::max(1, around_.window[1]);
  return std::clamp(covered_from - fitted_top, 0.0, kEdge);
}

Eigen::Vector2d SceneCamera::cornerFrom(int around_px) const {
  const auto [width, height] = around_.window;
  const double scale = around_.pixels_per_point;
  return {1 - 2 * scale * (SceneCorners::kRight + SceneCorners::kSize + around_px) / width,
          -1 + 2 * scale * (SceneCorners::kBottom + SceneCorners::kSize + SceneCorners::kWord + around_px) / height};
}

Eigen::Vector2d SceneCamera::windowCenter() const {
  return {around_.ghost ? SceneGhost::kShare : 0, 1 - 2 * freeFrom(bottom_margin_) - freeHeight()};
}

void SceneCamera::centerInFreePart() {
  const Eigen::Vector2d center = windowCenter();
  camera()->SetWindowCenter(center.x(), center.y());
}

void SceneCamera::lookFrom(View view) {
  const ViewDirection direction = directionOf(view);
  const Eigen::Vector3d focus = toEigen(camera()->GetFocalPoint());
  const Eigen::Vector3d position = focus + std::max(camera()->GetDistance(), 1e-3) * direction.from;
  camera()->SetPosition(position.x(), position.y(), position.z());
  camera()->SetViewUp(direction.up.x(), direction.up.y(), direction.up.z());
  camera()->OrthogonalizeViewUp();
  fit_pending_ = true;
}

bool SceneCamera::looksFrom(View view) const {
  constexpr double kSame = 0.9999;  // cosine
  return -toEigen(camera()->GetDirectionOfProjection()).dot(directionOf(view).from) > kSame;
}

void SceneCamera::centerOn(const Eigen::Vector3d& point) {
  const Eigen::Vector3d position = toEigen(camera()->GetPosition()) + point - toEigen(camera()->GetFocalPoint());
  camera()->SetFocalPoint(point.x(), point.y(), point.z());
  camera()->SetPosition(position.x(), position.y(), position.z());
}

std::optional<double> SceneCamera::shiftPastArrow(const std::vector<Eigen::Vector3d>& seen, double distance) const {
  constexpr int kAround_px = 8;
  const auto [width, height] = around_.window;
  const bool parallel = camera()->GetParallelProjection() != 0;
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

void SceneCamera::fitNow() {
  const auto [width, height] = around_.window;
  if (!content_ || content_->layout.points.empty() || width <= 0 || height <= 0) return;
  fit_pending_ = false;
  const Eigen::Vector3d back = -toEigen(camera()->GetDirectionOfProjection());
  const Eigen::Vector3d up =
      (toEigen(camera()->GetViewUp()) - toEigen(camera()->GetViewUp()).dot(back) * back).normalized();
  const Eigen::Vector3d right = up.cross(back);
  Eigen::AlignedBox3d box;
  std::vector<Eigen::Vector3d> points = content_->layout.points;
  for (const std::size_t patch : content_->layout.framed()) {
    std::ranges::copy(content_->frameCorners(patch), std::back_inserter(points));
  }
  const std::size_t of_cells = points.size();
  std::ranges::copy(more_, std::back_inserter(points));
  Eigen::AlignedBox3d cell_box;
  for (std::size_t k = 0; k < of_cells; ++k) {
    cell_box.extend(Eigen::Vector3d(right.dot(points[k]), up.dot(points[k]), back.dot(points[k])));
  }
  for (const Eigen::Vector3d& p : points) box.extend(Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)));
  const Eigen::Vector3d center = box.center();
  const double tan_height = freeHeight() * std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = freeWidth() * std::tan(0.5 * kViewAngle_deg * kDegree) * width / height;
  const double least = 2 * content_->reconstruction->model->side_m;
  double distance = least;
  double flat_distance = least;  // from where a skin without depth would fit
  std::vector<Eigen::Vector3d> seen;
  seen.reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d v = Eigen::Vector3d(right.dot(p), up.dot(p), back.dot(p)) - center;
    seen.push_back(v);
    // A part that is turned has to stay in the picture.
    if (up_o_) distance = std::max(distance, v.norm() / std::sin(std::atan(std::min(tan_width, tan_height))));
    const double flat = up_o_ ? v.norm() / std::min(tan_width, tan_height)
                              : std::max(std::abs(v.x()) / tan_width, std::abs(v.y()) / tan_height);
    flat_distance = std::max(flat_distance, flat);
    distance = std::max(distance, v.z() + flat);
  }
  double shift = 0;
  // A part that is turned has room on all sides.
  if (around_.arrow_of_gravity && !up_o_) {
    constexpr double kFarther = 1.04;
    constexpr double kFarthest = 1.5;
    for (double away = 1; away < kFarthest; away *= kFarther) {
      const auto found =
          shiftPastArrow(seen, away * (camera()->GetParallelProjection() != 0 ? flat_distance : distance));
      if (!found) continue;
      shift = *found;
      distance *= away;
      flat_distance *= away;
      break;
    }
  }
  const Eigen::Vector3d focus = right * (center.x() + shift) + up * center.y() + back * center.z();
  const Eigen::Vector3d position = focus + distance * back;
  camera()->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera()->SetPosition(position.x(), position.y(), position.z());
  camera()->SetParallelScale(flat_distance * std::tan(0.5 * kViewAngle_deg * kDegree));
  fitted_ = Fitted{
      position, focus, camera()->GetParallelScale(), {width, height}, content_->extent_m, !cell_box.contains(box)};
}

bool SceneCamera::isUntouched() const {
  return fitted_ && fitted_->position == toEigen(camera()->GetPosition()) &&
         fitted_->focus == toEigen(camera()->GetFocalPoint()) &&
         fitted_->parallel_scale == camera()->GetParallelScale();
}

bool SceneCamera::hasOutgrownTheFit() const {
  // Small changes, as every new pose brings them, must not make the picture jump.
  constexpr double kOtherShape = 0.1;
  if (std::abs(content_->extent_m - fitted_->extent_m) > kOtherShape * fitted_->extent_m) return true;
  const auto [width, height] = around_.window;
  const Eigen::Vector3d position = toEigen(camera()->GetPosition());
  const Eigen::Vector3d ahead = toEigen(camera()->GetDirectionOfProjection());
  const Eigen::Vector3d right = ahead.cross(toEigen(camera()->GetViewUp())).normalized();
  const Eigen::Vector3d up = right.cross(ahead);
  const double tan_height = std::tan(0.5 * kViewAngle_deg * kDegree);
  const double tan_width = tan_height * width / height;
  const bool has_arrow = around_.arrow_of_gravity && !up_o_;
  const Eigen::Vector2d corner = cornerFrom(0) + windowCenter();
  const auto isOutside = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = p - position;
    const double depth = camera()->GetParallelProjection() ? camera()->GetParallelScale() / tan_height : v.dot(ahead);
    return std::abs(v.dot(right)) > (freeWidth() + kEdge) * tan_width * depth ||
           v.dot(up) > (freeHeight() + slackAbove()) * tan_height * depth ||
           -v.dot(up) > (freeHeight() + kEdge) * tan_height * depth ||
           (has_arrow && v.dot(right) > corner.x() * tan_width * depth && v.dot(up) < corner.y() * tan_height * depth);
  };
  return std::ranges::any_of(content_->layout.points, isOutside) || std::ranges::any_of(more_, isOutside);
}

void SceneCamera::follow(const std::optional<Eigen::Vector3d>& up_o) {
  const bool untouched = isUntouched();
  if (up_o && up_o_) {
    turnCameraWithPart(camera(), *up_o_, *up_o);
  } else if (up_o) {
    standCameraUpright(camera(), *up_o);
  }
  // Following does not count as a hand on the camera.
  if (untouched) fitted_->position = toEigen(camera()->GetPosition());
  if (up_o.has_value() != up_o_.has_value() && (untouched || !fitted_)) fit_pending_ = true;
  up_o_ = up_o;
}

void SceneCamera::spin(const std::optional<Eigen::Vector3d>& up_o, double angle_rad) {
  const bool untouched = isUntouched();
  spinPartInPicture(camera(), up_o.value_or(toEigen(camera()->GetViewUp())), angle_rad);
  if (untouched) fitted_->position = toEigen(camera()->GetPosition());
}

void SceneCamera::keepView() {
  kept_view_ = KeptView{-toEigen(camera()->GetDirectionOfProjection()), toEigen(camera()->GetViewUp())};
}

void SceneCamera::returnToKeptView() {
  if (!kept_view_) return;
  const Eigen::Vector3d& up = kept_view_->up;
  const Eigen::Vector3d position = toEigen(camera()->GetFocalPoint()) + camera()->GetDistance() * kept_view_->back;
  camera()->SetPosition(position.x(), position.y(), position.z());
  camera()->SetViewUp(up.x(), up.y(), up.z());
  kept_view_.reset();
  fit_pending_ = true;
}

void SceneCamera::setParallel(bool parallel) {
  if ((camera()->GetParallelProjection() != 0) == parallel) return;
  const double half = std::tan(0.5 * kViewAngle_deg * kDegree);
  if (isUntouched()) {
    fit_pending_ = true;
  } else if (parallel) {
    camera()->SetParallelScale(camera()->GetDistance() * half);
  } else {
    const Eigen::Vector3d focus = toEigen(camera()->GetFocalPoint());
    const Eigen::Vector3d back = -toEigen(camera()->GetDirectionOfProjection());
    const Eigen::Vector3d position = focus + camera()->GetParallelScale() / half * back;
    camera()->SetPosition(position.x(), position.y(), position.z());
  }
  camera()->SetParallelProjection(parallel);
}

}  // namespace hexoderm
