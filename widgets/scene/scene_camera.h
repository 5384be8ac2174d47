#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/scene/standard_view.h"

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkCamera;
class vtkRenderer;

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
  explicit SceneCamera(vtkRenderer* renderer);

  /// The camera moves only when the set of cells has changed: another skin is looked at obliquely, and one that lost or
  /// gained some cells is fitted.
  void setContent(std::shared_ptr<const SceneContent> content);
  /// Pixels of the window's top that something else covers: a fitted skin stays below.
  void setTopMargin(int pixels);
  /// The same at the bottom.
  void setBottomMargin(int pixels);

  /// Points of what is drawn besides the cells, which is fitted too. The camera moves for them unless somebody has
  /// moved it by hand, and moves back when they are gone.
  void setMore(std::vector<Eigen::Vector3d> points);

  /// Moves the camera along its direction until everything fits; done by the next prepare().
  void fit() { fit_pending_ = true; }
  /// Fits the view unless somebody has moved the camera by hand.
  void fitIfUntouched();
  void lookFrom(View view);
  /// Turns about what is in the middle of the picture now by bringing this point there; the direction, and what fits
  /// into the picture, stay.
  void centerOn(const Eigen::Vector3d& point);
  /// The camera looks along this view's direction already, whatever is upwards.
  [[nodiscard]] bool looksFrom(View view) const;
  /// Remembers the present direction; returnToKeptView() looks from there again and fits. Without a kept view it does
  /// nothing.
  void keepView();
  void returnToKeptView();
  /// Parallel instead of perspective projection; the point that is looked at keeps its size.
  void setParallel(bool parallel);

  /// Keeps `up_o`, a unit vector, upwards in the picture as the part is turned; none: the picture stays.
  void follow(const std::optional<Eigen::Vector3d>& up_o);
  /// True while an up direction is followed.
  [[nodiscard]] bool isFollowing() const { return up_o_.has_value(); }
  /// Makes the part seem to turn about `up_o`, counter-clockwise seen from above; none: about the picture's vertical.
  void spin(const std::optional<Eigen::Vector3d>& up_o, double angle_rad);

  /// Called before each rendering: carries out a fit that is due.
  void prepare(const Surroundings& around);
  /// Called before a pixel is picked: only a fit that was asked for.
  void fitIfPending(const Surroundings& around);

 private:
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
  struct KeptView {
    Eigen::Vector3d back;
    Eigen::Vector3d up;
  };

  [[nodiscard]] vtkCamera* camera() const;
  void fitNow();
  /// Distance by which the camera has to go to its right so that the arrow of gravity covers none of the points, which
  /// are given as (right, up, towards the viewer) from the point that is looked at. None if others would leave the
  /// picture.
  [[nodiscard]] std::optional<double> shiftPastArrow(const std::vector<Eigen::Vector3d>& seen, double distance) const;
  /// Nobody has moved the camera since the last fit.
  [[nodiscard]] bool isUntouched() const;
  /// The patch has another shape than it was fitted with, or part of it has come close to the edge of the picture.
  [[nodiscard]] bool hasOutgrownTheFit() const;
  /// Shares of the window.
  [[nodiscard]] double freeWidth() const;
  [[nodiscard]] double freeHeight() const;
  /// The share of the window at its top or bottom where no fitted skin is, if that many pixels of it are covered.
  [[nodiscard]] double freeFrom(int margin_px) const;
  /// Distance that a growing patch may exceed the fit by until it is fitted again, in half heights of the window.
  [[nodiscard]] double slackAbove() const;
  /// The upper left corner of the arrow of gravity with its word, in half windows from the window's middle.
  [[nodiscard]] Eigen::Vector2d cornerFrom(int around_px) const;
  /// The middle of the window, seen from the point that the camera looks at, in half windows.
  [[nodiscard]] Eigen::Vector2d windowCenter() const;
  /// The free part of the window has the focus in its middle.
  void centerInFreePart();

  vtkRenderer* renderer_;
  std::shared_ptr<const SceneContent> content_;
  Surroundings around_;
  std::optional<Eigen::Vector3d> up_o_;  ///< followed
  std::optional<Fitted> fitted_;
  std::optional<KeptView> kept_view_;
  std::vector<Eigen::Vector3d> more_;
  bool fit_pending_ = false;
  bool content_is_new_ = false;  ///< since the last picture: the cells, or what is drawn besides
  int top_margin_ = 0;           ///< pixels
  int bottom_margin_ = 0;        ///< pixels
};

}  // namespace hexoderm
