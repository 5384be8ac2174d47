#pragma once

#include "hexoderm/geometry/se3.h"
#include "widgets/scene/vtk_eigen.h"
#include "widgets/style/scene_colors.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

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

  SceneCorners() : parts_(std::make_unique<Parts>()) {
    for (vtkRenderer* renderer : {parts_->axes.Get(), parts_->gravity.Get()}) {
      renderer->SetLayer(1);
      renderer->InteractiveOff();
      renderer->GetActiveCamera()->ParallelProjectionOn();
      renderer->GetActiveCamera()->SetParallelScale(kLengthRange);
    }
    parts_->axes->AddActor(parts_->axes_plate.actor);
    parts_->gravity->AddActor(parts_->gravity_plate.actor);
    for (std::size_t knob = 0; knob < 6; ++knob) {
      parts_->knobs.push_back(std::make_unique<Knob>(Parts::knobAt(knob), knob % 2 == 0 ? kKnob : kFarKnob));
      parts_->axes->AddActor(parts_->knobs.back()->actor);
    }
    for (int k = 0; k < 3; ++k) {
      const auto index = static_cast<std::size_t>(k);
      const Eigen::Vector3d tip = kAxisLength * Eigen::Vector3d::Unit(k);
      parts_->axis_sticks.push_back(std::make_unique<Stick>(Eigen::Vector3d::Zero(), tip, 0.045));
      parts_->axes->AddActor(parts_->axis_sticks.back()->actor);
      vtkBillboardTextActor3D* letter = parts_->letters.at(index);
      letter->SetInput(kAxisNames.at(index));
      letter->ForceOpaqueOn();  // as SceneLabels
      letter->GetTextProperty()->SetFontSize(12);
      letter->GetTextProperty()->SetJustificationToCentered();
      letter->GetTextProperty()->SetVerticalJustificationToCentered();
      parts_->axes->AddActor(letter);
    }
    parts_->cone->SetCenter(0.65, 0, 0);
    parts_->cone->SetDirection(1, 0, 0);
    parts_->cone->SetHeight(0.4);
    parts_->cone->SetRadius(0.17);
    parts_->cone->SetResolution(32);
    parts_->cone_mapper->SetInputConnection(parts_->cone->GetOutputPort());
    parts_->head->SetMapper(parts_->cone_mapper);
    parts_->head->GetProperty()->SetAmbient(0.55);
    parts_->head->GetProperty()->SetDiffuse(0.45);
    parts_->gravity->AddActor(parts_->shaft.actor);
    parts_->gravity->AddActor(parts_->head);
    parts_->update();
  }

  void attachTo(vtkRenderWindow* window) {
    window->AddRenderer(parts_->axes);
    window->AddRenderer(parts_->gravity);
  }

  void detachFrom(vtkRenderWindow* window) {
    window->RemoveRenderer(parts_->axes);
    window->RemoveRenderer(parts_->gravity);
  }

  void setColors(const SceneColors& colors) {
    Rgb shaft = colors.arrow_shaft;
    Rgb head = colors.arrow_head;
    parts_->shaft.actor->GetProperty()->SetColor(shaft.data());
    parts_->head->GetProperty()->SetColor(head.data());
    Rgb ground = colors.background_bottom;
    for (const Plate* plate : {&parts_->axes_plate, &parts_->gravity_plate}) {
      plate->actor->GetProperty()->SetColor(ground.data());
    }
    for (std::size_t k = 0; k < colors.axis.size(); ++k) {
      Rgb axis = colors.axis.at(k);
      Rgb far = mixed(axis, ground, 0.5);
      Rgb letter = markOn(axis, colors);
      parts_->axis_sticks.at(k)->actor->GetProperty()->SetColor(axis.data());
      parts_->knobs.at(2 * k)->actor->GetProperty()->SetColor(axis.data());
      parts_->knobs.at(2 * k + 1)->actor->GetProperty()->SetColor(far.data());
      parts_->letters.at(k)->GetTextProperty()->SetColor(letter.data());
    }
  }

  /// Unit vector in the patch frame; none hides the arrow.
  void setDown(const std::optional<Eigen::Vector3d>& down_o) {
    parts_->has_down = down_o.has_value();
    if (down_o) {
      const Eigen::Matrix3d R = shortestRotation(Eigen::Vector3d::UnitX(), *down_o);
      vtkNew<vtkMatrix4x4> matrix;
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, R(row, column));
      }
      parts_->shaft.actor->SetUserMatrix(matrix);
      parts_->head->SetUserMatrix(matrix);
    }
    parts_->update();
  }

  void setAxesVisible(bool visible) {
    parts_->visible = visible;
    parts_->update();
  }

  void setTextVisible(bool visible) {
    for (auto& letter : parts_->letters) letter->SetVisibility(visible);
  }

  /// Looks the same way as `camera`, and keeps the size in pixels; called before each rendering.
  void follow(vtkCamera* camera, vtkRenderWindow* window) {
    const int* size = window->GetSize();
    if (size[0] <= 0 || size[1] <= 0) return;
    const double scale = window->GetDPI() / 72.0;
    const double width = std::min(1.0, scale * kSize / size[0]);
    const double height = std::min(1.0, scale * kSize / size[1]);
    const double left = std::min(1 - width, scale * kLeft / size[0]);
    const double bottom = std::min(1 - height, scale * kBottom / size[1]);
    parts_->axes->SetViewport(left, bottom, left + width, bottom + height);
    const double right = std::max(0.0, 1 - width - scale * kRight / size[0]);
    parts_->gravity->SetViewport(right, bottom, right + width, bottom + height);
    const Eigen::Vector2d pixels(size[0], size[1]);
    parts_->lower_left = pixels.cwiseProduct(Eigen::Vector2d(left, bottom));
    parts_->size = pixels.cwiseProduct(Eigen::Vector2d(width, height));
    parts_->back = -toEigen(camera->GetDirectionOfProjection());
    parts_->right = toEigen(camera->GetViewUp()).cross(parts_->back).normalized();
    parts_->up = parts_->back.cross(parts_->right);
    parts_->axes_plate.face(parts_->back);
    parts_->gravity_plate.face(parts_->back);
    for (std::size_t k = 0; k < parts_->letters.size(); ++k) {
      const Eigen::Vector3d p = Parts::knobAt(2 * k) + 1.1 * kHovered * kKnob * parts_->back;
      parts_->letters.at(k)->SetPosition(p.x(), p.y(), p.z());
    }
    for (vtkRenderer* renderer : {parts_->axes.Get(), parts_->gravity.Get()}) {
      vtkCamera* own = renderer->GetActiveCamera();
      const Eigen::Vector3d from = 5 * parts_->back;
      own->SetFocalPoint(0, 0, 0);
      own->SetPosition(from.x(), from.y(), from.z());
      own->SetViewUp(parts_->up.x(), parts_->up.y(), parts_->up.z());
      own->SetClippingRange(1, 10);
    }
  }

  /// The knob that is drawn at a pixel of the window (origin lower left), as it was followed last.
  [[nodiscard]] std::optional<AxisEnd> endAt(double x, double y) const {
    if (!parts_->visible || parts_->size.y() <= 0) return std::nullopt;
    // From the corner's middle, in units of the axes.
    const Eigen::Vector2d at =
        2 * kLengthRange / parts_->size.y() * (Eigen::Vector2d(x, y) - parts_->lower_left - 0.5 * parts_->size);
    std::optional<AxisEnd> found;
    double nearest = -2;
    for (std::size_t knob = 0; knob < parts_->knobs.size(); ++knob) {
      const Eigen::Vector3d p = Parts::knobAt(knob);
      const Eigen::Vector2d seen(parts_->right.dot(p), parts_->up.dot(p));
      const double reach = 1.1 * (knob % 2 == 0 ? kKnob : kFarKnob);
      if ((at - seen).norm() > reach || parts_->back.dot(p) <= nearest) continue;
      nearest = parts_->back.dot(p);
      found = AxisEnd{knob / 2, knob % 2 == 0};
    }
    return found;
  }

  /// Makes this knob larger; true if another one was before.
  bool setHovered(const std::optional<AxisEnd>& end) {
    if (end == parts_->hovered) return false;
    if (parts_->hovered) parts_->knobs.at(Parts::knobOf(*parts_->hovered))->actor->SetScale(1);
    parts_->hovered = end;
    if (end) parts_->knobs.at(Parts::knobOf(*end))->actor->SetScale(kHovered);
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
  /// A round stick between two points.
  struct Stick {
    vtkNew<vtkLineSource> line;
    vtkNew<vtkTubeFilter> tube;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;

    Stick(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
      line->SetPoint1(from.x(), from.y(), from.z());
      line->SetPoint2(to.x(), to.y(), to.z());
      tube->SetInputConnection(line->GetOutputPort());
      tube->SetRadius(radius);
      tube->SetNumberOfSides(16);
      tube->CappingOn();
      mapper->SetInputConnection(tube->GetOutputPort());
      actor->SetMapper(mapper);
      actor->GetProperty()->SetAmbient(0.55);
      actor->GetProperty()->SetDiffuse(0.45);
    }
  };

  struct Knob {
    vtkNew<vtkSphereSource> sphere;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;

    Knob(const Eigen::Vector3d& at, double radius) {
      sphere->SetRadius(radius);
      sphere->SetThetaResolution(24);
      sphere->SetPhiResolution(16);
      mapper->SetInputConnection(sphere->GetOutputPort());
      actor->SetMapper(mapper);
      actor->SetPosition(at.x(), at.y(), at.z());
      // A disc in its full colour, on which a letter is read.
      actor->GetProperty()->LightingOff();
    }
  };

  /// A disc behind what a corner shows; drawn first.
  struct Plate {
    vtkNew<vtkRegularPolygonSource> disc;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;

    Plate() {
      disc->SetNumberOfSides(64);
      disc->SetRadius(kPlate);
      disc->GeneratePolylineOff();
      mapper->SetInputConnection(disc->GetOutputPort());
      actor->SetMapper(mapper);
      actor->GetProperty()->LightingOff();
      actor->GetProperty()->SetOpacity(kPlateOpacity);
      actor->ForceOpaqueOn();
      actor->PickableOff();
    }
    /// Behind everything: `back` towards the viewer.
    void face(const Eigen::Vector3d& back) {
      const Eigen::Vector3d center = -2 * back;
      disc->SetCenter(center.x(), center.y(), center.z());
      disc->SetNormal(back.x(), back.y(), back.z());
    }
  };

  struct Parts {
    vtkNew<vtkRenderer> axes;
    vtkNew<vtkRenderer> gravity;
    Plate axes_plate;
    Plate gravity_plate;
    std::vector<std::unique_ptr<Stick>> axis_sticks;
    std::vector<std::unique_ptr<Knob>> knobs;  ///< of x, -x, y, -y, z, -z
    std::array<vtkNew<vtkBillboardTextActor3D>, 3> letters;
    Stick shaft{{-0.85, 0, 0}, {0.45, 0, 0}, 0.045};
    vtkNew<vtkConeSource> cone;
    vtkNew<vtkPolyDataMapper> cone_mapper;
    vtkNew<vtkActor> head;
    bool visible = false;
    bool has_down = false;
    std::optional<AxisEnd> hovered;
    // As followed last: pixels of the corner, and the directions of the picture.
    Eigen::Vector2d lower_left = Eigen::Vector2d::Zero();
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    Eigen::Vector3d back = Eigen::Vector3d::UnitZ();

    static Eigen::Vector3d knobAt(std::size_t knob) {
      return (knob % 2 == 0 ? kAxisLength : -kAxisLength) * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(knob / 2));
    }
    static std::size_t knobOf(const AxisEnd& end) { return 2 * end.axis + (end.positive ? 0 : 1); }
    void update() {
      axes->SetDraw(visible);
      gravity->SetDraw(has_down);
    }
  };
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
