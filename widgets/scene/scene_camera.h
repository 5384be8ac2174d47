#pragma once

#include "hexoderm/base/units.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/scene/scene_ghost.h"
#include "widgets/scene/scene_items.h"
#include "widgets/scene/scene_sight.h"
#include "widgets/style/of_enum.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The camera of the 3D scene: it fits the skin into the part of the window that nothing else covers, fits it again
/// while nobody has moved the camera by hand, and goes along when the part is turned. Directions are in the scene's
/// frame, which is the patch's.
class SceneCamera {
 public:
  using View = StandardView;

  /// The window, and what covers it in the scene besides the skin.
  struct Surroundings {
    std::array<int, 2> window{};    ///< width and height in pixels; zero without a window
    double pixels_per_point = 1;    ///< 1 at 72 dpi
    bool ghost = false;             ///< on the right
    bool arrow_of_gravity = false;  ///< in the lower right corner
  };

  /// The renderer must outlive this.
  explicit SceneCamera(vtkRenderer* renderer) : renderer_(renderer) {
    camera()->SetViewAngle(kViewAngle_deg);
    lookFrom(View::Oblique);
  }

  /// The camera moves only when the set of cells has changed: another skin is looked at obliquely, and one that lost or
  /// gained some cells is fitted.
  void setContent(std::shared_ptr<const SceneContent> content) {
    const std::shared_ptr<const SceneContent> before = std::exchange(content_, std::move(content));
    content_is_new_ = true;
    if (sameCells(before.get(), content_.get())) return;
    if (isOtherSkin(before.get(), content_.get())) {
      lookFrom(View::Oblique);
    } else {
      fit();
    }
  }

  /// Pixels of the window's top that something else covers: a fitted skin stays below.
  void setTopMargin(int pixels) {
    if (std::exchange(top_margin_, pixels) != pixels) fitIfUntouched();
  }

  /// The same at the bottom.
  void setBottomMargin(int pixels) {
    if (std::exchange(bottom_margin_, pixels) != pixels) fitIfUntouched();
  }

  /// Points of what is drawn besides the cells, which is fitted too. The camera moves for them unless somebody has
  /// moved it by hand, and moves back when they are gone.
  void setMore(std::vector<Eigen::Vector3d> points) {
    if (points.empty() && more_.empty()) return;
    more_ = std::move(points);
    content_is_new_ = true;
    if (more_.empty() && fitted_ && fitted_->wider) fitIfUntouched();
  }

  /// Moves the camera along its direction until everything fits; done by the next prepare().
  void fit() { fit_pending_ = true; }
  /// Fits the view unless somebody has moved the camera by hand.
  void fitIfUntouched() {
    if (isUntouched()) fit_pending_ = true;
  }

  void lookFrom(View view) { lookFrom(directionOf(view)); }

  /// Turns about what is in the middle of the picture now by bringing this point there; the direction, and what fits
  /// into the picture, stay.
  void centerOn(const Eigen::Vector3d& point) {
    const Eigen::Vector3d position = toEigen(camera()->GetPosition()) + point - toEigen(camera()->GetFocalPoint());
    camera()->SetFocalPoint(point.data());
    camera()->SetPosition(position.data());
  }

  /// The camera looks along this view's direction already, whatever is upwards.
  [[nodiscard]] bool looksFrom(View view) const {
    constexpr double kSame = 0.9999;  // cosine
    return backOfCamera(camera()).dot(directionOf(view).from) > kSame;
  }

  /// Remembers the present direction; returnToKeptView() looks from there again and fits. Without a kept view it does
  /// nothing.
  void keepView() { kept_view_ = ViewDirection{backOfCamera(camera()), toEigen(camera()->GetViewUp())}; }

  void returnToKeptView() {
    if (const auto kept = std::exchange(kept_view_, std::nullopt)) lookFrom(*kept);
  }

  /// Parallel instead of perspective projection; the point that is looked at keeps its size.
  void setParallel(bool parallel) {
    if ((camera()->GetParallelProjection() != 0) == parallel) return;
    const double half = std::tan(0.5 * kViewAngle_deg * kDegree);
    if (isUntouched()) {
      fit_pending_ = true;
    } else if (parallel) {
      camera()->SetParallelScale(camera()->GetDistance() * half);
    } else {
      camera()->Dolly(camera()->GetDistance() * half / camera()->GetParallelScale());
    }
    camera()->SetParallelProjection(parallel);
  }

  /// Keeps `up_o`, a unit vector, upwards in the picture as the part is turned; none: the picture stays.
  void follow(const std::optional<Eigen::Vector3d>& up_o) {
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

  /// Makes the part seem to turn about `up_o`, counter-clockwise seen from above; none: about the picture's vertical.
  void spin(const std::optional<Eigen::Vector3d>& up_o, double angle_rad) {
    const bool untouched = isUntouched();
    spinPartInPicture(camera(), up_o.value_or(toEigen(camera()->GetViewUp())), angle_rad);
    if (untouched) fitted_->position = toEigen(camera()->GetPosition());
  }

  /// Called before each rendering: carries out a fit that is due.
  void prepare(const Surroundings& around) {
    around_ = around;
    centerInFreePart();
    const bool outgrown = std::exchange(content_is_new_, false) && content_ && isUntouched() && hasOutgrownTheFit();
    if (fit_pending_ || outgrown || (isUntouched() && fitted_->window != around_.window)) fitNow();
  }

  /// Called before a pixel is picked: only a fit that was asked for.
  void fitIfPending(const Surroundings& around) {
    around_ = around;
    if (fit_pending_) fitNow();
  }

 private:
  static constexpr double kViewAngle_deg = 30;
  static constexpr double kEdge = 0.08;  // in half windows: a growing patch may exceed the fit by this much
  // Shares of the window that a fitted skin fills: what covers the top and the bottom stays free.
  static constexpr double kFitWidth = 0.88;
  static constexpr double kFitHeight = 0.74;
  static constexpr double kMinFitHeight = 0.4;
  static constexpr double kBetween = 0.02;  // between what covers top or bottom and the skin
  struct ViewDirection {
    Eigen::Vector3d from;  ///< unit, from what is looked at to the camera
    Eigen::Vector3d up;
  };

  static ViewDirection directionOf(View view) {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    return ofEnum<View, ViewDirection>(view, {{Eigen::Vector3d(0.45, 0.42, 1.0).normalized(), y},
                                              {z, y},
                                              {x, y},
                                              {y, -z},
                                              {-z, y},
                                              {-x, y},
                                              {-y, z},
                                              {Eigen::Vector3d::Ones().normalized(), y}});
  }

  static bool sameCells(const SceneContent* before, const SceneContent* after) {
    if (before == nullptr || after == nullptr) return before == after;
    return std::ranges::equal(before->layout.cells, after->layout.cells, {}, &SceneCell::id, &SceneCell::id);
  }

  /// Fewer than half of the cells are the same: not a skin that lost or gained some cells.
  static bool isOtherSkin(const SceneContent* before, const SceneContent* after) {
    const std::size_t had = before ? before->layout.cells.size() : 0;
    const std::size_t has = after ? after->layout.cells.size() : 0;
    if (had == 0 || has == 0) return had != has;
    const auto kept = std::ranges::count_if(
        after->layout.cells, [&](const SceneCell& cell) { return before->layout.find(cell.id) != nullptr; });
    return 2 * static_cast<std::size_t>(kept) < std::max(had, has);
  }

  /// Camera, window and patch as the last fit left them: while nobody has moved the camera, a resized window or a patch
  /// that has taken another shape (flat at first, bent from the first poses on) is fitted again.
  struct Fitted {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    double parallel_scale = 0;
    std::array<int, 2> window{};
    double extent_m = 0;
    bool wider = false;  ///< it made room for more than the cells
  };

  [[nodiscard]] vtkCamera* camera() const { return renderer_->GetActiveCamera(); }
  void lookFrom(const ViewDirection& direction) {
    lookFromBack(camera(), direction.from, direction.up, direction.up);
    fit_pending_ = true;
  }

  void fitNow() {
    const auto [width, height] = around_.window;
    if (!content_ || content_->layout.points.empty() || width <= 0 || height <= 0) return;
    fit_pending_ = false;
    const SceneSight sight = SceneSight::of(camera(), around_.window, 72);
    Eigen::Matrix3d axes;
    axes << sight.right, sight.up, sight.back;
    std::vector<Eigen::Vector3d> seen;  // right, up, towards the viewer
    Eigen::AlignedBox3d box;
    const auto see = [&](const Eigen::Vector3d& p) {
      seen.emplace_back(axes.transpose() * p);
      box.extend(seen.back());
    };
    std::ranges::for_each(content_->layout.points, see);
    for (const std::size_t patch : content_->layout.framed()) std::ranges::for_each(content_->frameCorners(patch), see);
    const Eigen::AlignedBox3d cell_box = box;
    std::ranges::for_each(more_, see);
    const Eigen::Vector3d center = box.center();
    const double tan_height = freeHeight() * std::tan(0.5 * kViewAngle_deg * kDegree);
    const double tan_width = freeWidth() * std::tan(0.5 * kViewAngle_deg * kDegree) * width / height;
    const double least = 2 * content_->reconstruction->model->side_m;
    double distance = least;
    double flat_distance = least;  // from where a skin without depth would fit
    for (Eigen::Vector3d& v : seen) {
      v -= center;
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
    const Eigen::Vector3d focus = axes * (center + shift * Eigen::Vector3d::UnitX());
    const Eigen::Vector3d position = focus + distance * sight.back;
    camera()->SetFocalPoint(focus.data());
    camera()->SetPosition(position.data());
    camera()->SetParallelScale(flat_distance * std::tan(0.5 * kViewAngle_deg * kDegree));
    fitted_ = Fitted{
        position, focus, camera()->GetParallelScale(), {width, height}, content_->extent_m, !cell_box.contains(box)};
  }

  /// Distance by which the camera has to go to its right so that the arrow of gravity covers none of the points, which
  /// are given as (right, up, towards the viewer) from the point that is looked at. None if others would leave the
  /// picture.
  [[nodiscard]] std::optional<double> shiftPastArrow(const std::vector<Eigen::Vector3d>& seen, double distance) const {
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

  /// Nobody has moved the camera since the last fit.
  [[nodiscard]] bool isUntouched() const {
    return fitted_ && fitted_->position == toEigen(camera()->GetPosition()) &&
           fitted_->focus == toEigen(camera()->GetFocalPoint()) &&
           fitted_->parallel_scale == camera()->GetParallelScale();
  }

  /// The patch has another shape than it was fitted with, or part of it has come close to the edge of the picture.
  [[nodiscard]] bool hasOutgrownTheFit() const {
    // Small changes, as every new pose brings them, must not make the picture jump.
    constexpr double kOtherShape = 0.1;
    if (std::abs(content_->extent_m - fitted_->extent_m) > kOtherShape * fitted_->extent_m) return true;
    const SceneSight sight = SceneSight::of(camera(), around_.window, 72);
    const Eigen::Array2d half_window(0.5 * around_.window[0], 0.5 * around_.window[1]);
    const bool has_arrow = around_.arrow_of_gravity && !up_o_;
    const Eigen::Vector2d corner = cornerFrom(0) + windowCenter();
    const auto isOutside = [&](const Eigen::Vector3d& p) {
      const Eigen::Array2d v = (sight.at(p) - sight.middle_px).array() / half_window;
      return !sight.isAhead(p) || std::abs(v.x()) > freeWidth() + kEdge || v.y() > freeHeight() + slackAbove() ||
             -v.y() > freeHeight() + kEdge || (has_arrow && v.x() > corner.x() && v.y() < corner.y());
    };
    return std::ranges::any_of(content_->layout.points, isOutside) || std::ranges::any_of(more_, isOutside);
  }

  /// Shares of the window.
  [[nodiscard]] double freeWidth() const { return around_.ghost ? kFitWidth - SceneGhost::kShare : kFitWidth; }
  [[nodiscard]] double freeHeight() const {
    return std::max(kMinFitHeight, 1 - freeFrom(bottom_margin_) - freeFrom(top_margin_));
  }

  /// The share of the window at its top or bottom where no fitted skin is, if that many pixels of it are covered.
  [[nodiscard]] double freeFrom(int margin_px) const {
    constexpr double kMin = 0.5 * (1 - kFitHeight);
    const int height = around_.window[1];
    return height <= 0 ? kMin : std::max(kMin, static_cast<double>(margin_px) / height + kBetween);
  }

  /// Distance that a growing patch may exceed the fit by until it is fitted again, in half heights of the window.
  [[nodiscard]] double slackAbove() const {
    const double fitted_top = 2 * (freeFrom(bottom_margin_) + freeHeight()) - 1;
    const double covered_from = 1 - 2.0 * top_margin_ / std::max(1, around_.window[1]);
    return std::clamp(covered_from - fitted_top, 0.0, kEdge);
  }

  /// The upper left corner of the arrow of gravity with its word, in half windows from the window's middle.
  [[nodiscard]] Eigen::Vector2d cornerFrom(int around_px) const {
    const auto [width, height] = around_.window;
    const double scale = around_.pixels_per_point;
    return {1 - 2 * scale * (SceneCorners::kRight + SceneCorners::kSize + around_px) / width,
            -1 + 2 * scale * (SceneCorners::kBottom + SceneCorners::kSize + SceneCorners::kWord + around_px) / height};
  }

  /// The middle of the window, seen from the point that the camera looks at, in half windows.
  [[nodiscard]] Eigen::Vector2d windowCenter() const {
    return {around_.ghost ? SceneGhost::kShare : 0, 1 - 2 * freeFrom(bottom_margin_) - freeHeight()};
  }

  /// The free part of the window has the focus in its middle.
  void centerInFreePart() {
    const Eigen::Vector2d center = windowCenter();
    camera()->SetWindowCenter(center.x(), center.y());
  }

  vtkRenderer* renderer_;
  std::shared_ptr<const SceneContent> content_;
  Surroundings around_;
  std::optional<Eigen::Vector3d> up_o_;  ///< followed
  std::optional<Fitted> fitted_;
  std::optional<ViewDirection> kept_view_;
  std::vector<Eigen::Vector3d> more_;
  bool fit_pending_ = false;
  bool content_is_new_ = false;  ///< since the last picture: the cells, or what is drawn besides
  int top_margin_ = 0;           ///< pixels
  int bottom_margin_ = 0;        ///< pixels
};

}  // namespace hexoderm
