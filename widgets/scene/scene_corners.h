#pragma once

#include "hexoderm/base/se3.h"
#include "widgets/scene/mesh_actor.h"
#include "widgets/scene/scene_sight.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <optional>

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

  SceneCorners() {
    for (vtkRenderer* renderer : {axes_.Get(), gravity_.Get()}) {
      renderer->SetLayer(1);
      renderer->InteractiveOff();
      renderer->GetActiveCamera()->ParallelProjectionOn();
      renderer->GetActiveCamera()->SetParallelScale(kLengthRange);
    }
    axes_->AddActor(axes_plate_.actor);
    gravity_->AddActor(gravity_plate_.actor);
    for (std::size_t knob = 0; knob < knobs_.size(); ++knob) makeKnob(knob);
    for (std::size_t k = 0; k < sticks_.size(); ++k) {
      makeStick(sticks_.at(k), Eigen::Vector3d::Zero(), knobAt(2 * k));
      axes_->AddActor(sticks_.at(k).actor);
      vtkBillboardTextActor3D* letter = letters_.at(k);
      letter->SetInput(kAxisNames.at(k));
      letter->ForceOpaqueOn();
      letter->GetTextProperty()->SetFontSize(12);
      letter->GetTextProperty()->SetJustificationToCentered();
      letter->GetTextProperty()->SetVerticalJustificationToCentered();
      axes_->AddActor(letter);
    }
    makeStick(shaft_, {-0.85, 0, 0}, {0.45, 0, 0});
    const vtkNew<vtkConeSource> cone;
    cone->SetCenter(0.65, 0, 0);
    cone->SetDirection(1, 0, 0);
    cone->SetHeight(0.4);
    cone->SetRadius(0.17);
    cone->SetResolution(32);
    head_.mapper->SetInputConnection(cone->GetOutputPort());
    head_.setAmbient(0.55);
    gravity_->AddActor(shaft_.actor);
    gravity_->AddActor(head_.actor);
    setAxesVisible(false);
    setDown(std::nullopt);
  }

  void attachTo(vtkRenderWindow* window) {
    window->AddRenderer(axes_);
    window->AddRenderer(gravity_);
  }

  void detachFrom(vtkRenderWindow* window) {
    window->RemoveRenderer(axes_);
    window->RemoveRenderer(gravity_);
  }

  void setColors(const SceneColors& colors) {
    shaft_.setColor(colors.arrow_shaft);
    head_.setColor(colors.arrow_head);
    for (const Plate* plate : {&axes_plate_, &gravity_plate_}) plate->setColor(colors.background_bottom);
    for (std::size_t k = 0; k < colors.axis.size(); ++k) {
      const Rgb& axis = colors.axis.at(k);
      sticks_.at(k).setColor(axis);
      knobs_.at(2 * k).setColor(axis);
      knobs_.at(2 * k + 1).setColor(mixed(axis, colors.background_bottom, 0.5));
      Rgb letter = markOn(axis, colors);
      letters_.at(k)->GetTextProperty()->SetColor(letter.data());
    }
  }

  /// Unit vector in the patch frame; none hides the arrow.
  void setDown(const std::optional<Eigen::Vector3d>& down_o) {
    gravity_->SetDraw(down_o.has_value());
    if (!down_o) return;
    const Eigen::Matrix3d R = shortestRotation(Eigen::Vector3d::UnitX(), *down_o);
    for (const MeshActor* part : {&shaft_, &head_}) setPlace(part->actor, R, Eigen::Vector3d::Zero());
  }

  void setAxesVisible(bool visible) { axes_->SetDraw(visible); }
  void setTextVisible(bool visible) {
    for (auto& letter : letters_) letter->SetVisibility(visible);
  }

  /// Looks the same way as the scene, and keeps the size in pixels; called before each rendering.
  void follow(const SceneSight& sight) {
    const Eigen::Vector2d pixels(sight.window[0], sight.window[1]);
    if (pixels.minCoeff() <= 0) return;
    sight_ = sight;
    const double scale = sight.text_scale;
    const Eigen::Vector2d size = (scale * kSize * pixels.cwiseInverse()).cwiseMin(1.0);
    const double left = std::min(1 - size.x(), scale * kLeft / pixels.x());
    const double bottom = std::min(1 - size.y(), scale * kBottom / pixels.y());
    const double right = std::max(0.0, 1 - size.x() - scale * kRight / pixels.x());
    axes_->SetViewport(left, bottom, left + size.x(), bottom + size.y());
    gravity_->SetViewport(right, bottom, right + size.x(), bottom + size.y());
    middle_ = pixels.cwiseProduct(Eigen::Vector2d(left, bottom) + 0.5 * size);
    pixels_per_unit_ = 0.5 * size.y() * pixels.y() / kLengthRange;
    axes_plate_.face(sight.back);
    gravity_plate_.face(sight.back);
    for (std::size_t k = 0; k < letters_.size(); ++k) {
      Eigen::Vector3d p = knobAt(2 * k) + 1.1 * kHovered * kKnob * sight.back;
      letters_.at(k)->SetPosition(p.data());
    }
    for (vtkRenderer* renderer : {axes_.Get(), gravity_.Get()}) {
      vtkCamera* own = renderer->GetActiveCamera();
      const Eigen::Vector3d from = 5 * sight.back;
      own->SetFocalPoint(0, 0, 0);
      own->SetPosition(from.data());
      own->SetViewUp(sight.up.data());
      own->SetClippingRange(1, 10);
    }
  }

  /// The knob that is drawn at a pixel of the window (origin lower left), as it was followed last.
  [[nodiscard]] std::optional<AxisEnd> endAt(double x, double y) const {
    if (axes_->GetDraw() == 0 || pixels_per_unit_ <= 0) return std::nullopt;
    const Eigen::Vector2d at = (Eigen::Vector2d(x, y) - middle_) / pixels_per_unit_;
    std::optional<AxisEnd> found;
    double nearest = -2;
    for (std::size_t knob = 0; knob < knobs_.size(); ++knob) {
      const Eigen::Vector3d p = knobAt(knob);
      const Eigen::Vector2d seen(sight_.right.dot(p), sight_.up.dot(p));
      if ((at - seen).norm() > 1.1 * radiusOf(knob) || sight_.back.dot(p) <= nearest) continue;
      nearest = sight_.back.dot(p);
      found = AxisEnd{knob / 2, knob % 2 == 0};
    }
    return found;
  }

  /// Makes this knob larger; true if another one was before.
  bool setHovered(const std::optional<AxisEnd>& end) {
    if (end == hovered_) return false;
    if (hovered_) knobs_.at(knobOf(*hovered_)).actor->SetScale(1);
    hovered_ = end;
    if (end) knobs_.at(knobOf(*end)).actor->SetScale(kHovered);
    return true;
  }

 private:
  static constexpr double kLengthRange = 1.15;  // half the height of what a corner shows
  static constexpr double kAxisLength = 0.8;    // to the middle of its knob
  static constexpr double kKnob = 0.23;         // radius at the positive ends, which have letters
  static constexpr double kFarKnob = 0.15;      // at the negative ones
  static constexpr double kHovered = 1.25;      // larger under the mouse
  static constexpr double kPlate = 1.1;         // radius
  static constexpr double kPlateOpacity = 0.82;
  static constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};
  /// A disc behind what a corner shows; drawn first.
  struct Plate : MeshActor {
    vtkNew<vtkRegularPolygonSource> disc;

    Plate() {
      disc->SetNumberOfSides(64);
      disc->SetRadius(kPlate);
      disc->GeneratePolylineOff();
      mapper->SetInputConnection(disc->GetOutputPort());
      property()->LightingOff();
      property()->SetOpacity(kPlateOpacity);
      actor->ForceOpaqueOn();
    }
    /// Behind everything: `back` towards the viewer.
    void face(const Eigen::Vector3d& back) {
      const Eigen::Vector3d center = -2 * back;
      disc->SetCenter(center.x(), center.y(), center.z());
      disc->SetNormal(back.x(), back.y(), back.z());
    }
  };

  static Eigen::Vector3d knobAt(std::size_t knob) {
    return (knob % 2 == 0 ? kAxisLength : -kAxisLength) * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(knob / 2));
  }
  static double radiusOf(std::size_t knob) { return knob % 2 == 0 ? kKnob : kFarKnob; }
  static std::size_t knobOf(const AxisEnd& end) { return 2 * end.axis + (end.positive ? 0 : 1); }
  /// Round, between two points.
  static void makeStick(MeshActor& stick, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const vtkNew<vtkLineSource> line;
    line->SetPoint1(from.x(), from.y(), from.z());
    line->SetPoint2(to.x(), to.y(), to.z());
    const vtkNew<vtkTubeFilter> tube;
    tube->SetInputConnection(line->GetOutputPort());
    tube->SetRadius(0.045);
    tube->SetNumberOfSides(16);
    tube->CappingOn();
    stick.mapper->SetInputConnection(tube->GetOutputPort());
    stick.setAmbient(0.55);
  }

  void makeKnob(std::size_t index) {
    const vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radiusOf(index));
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    const MeshActor& knob = knobs_.at(index);
    const Eigen::Vector3d at = knobAt(index);
    knob.mapper->SetInputConnection(sphere->GetOutputPort());
    knob.actor->SetPosition(at.x(), at.y(), at.z());
    // A disc in its full colour, on which a letter is read.
    knob.property()->LightingOff();
    axes_->AddActor(knob.actor);
  }

  vtkNew<vtkRenderer> axes_;
  vtkNew<vtkRenderer> gravity_;
  Plate axes_plate_;
  Plate gravity_plate_;
  std::array<MeshActor, 3> sticks_;
  std::array<MeshActor, 6> knobs_;  ///< of x, -x, y, -y, z, -z
  std::array<vtkNew<vtkBillboardTextActor3D>, 3> letters_;
  MeshActor shaft_;
  MeshActor head_;
  std::optional<AxisEnd> hovered_;
  // As followed last.
  SceneSight sight_;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();  ///< of the axes' corner, in pixels
  double pixels_per_unit_ = 0;
};

}  // namespace hexoderm
