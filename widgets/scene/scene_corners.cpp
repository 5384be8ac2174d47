#include "widgets/scene/scene_corners.h"

#include "hexoderm/geometry/se3.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <algorithm>
#include <array>
#include <vector>

namespace hexoderm {
namespace {

constexpr double kLengthRange = 1.15;  // half the height of what a corner shows; see kAxisLength
constexpr double kAxisLength = 0.7;
constexpr double kLetterBeyond = 0.27;  // in the picture, from an axis's tip to the middle of its letter
constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

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

}  // namespace

struct SceneCorners::Parts {
  vtkNew<vtkRenderer> axes;
  vtkNew<vtkRenderer> gravity;
  std::vector<std::unique_ptr<Stick>> axis_sticks;
  std::array<vtkNew<vtkBillboardTextActor3D>, 3> letters;
  Stick shaft{{-0.85, 0, 0}, {0.45, 0, 0}, 0.045};
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkPolyDataMapper> cone_mapper;
  vtkNew<vtkActor> head;
  bool visible = false;
  bool has_down = false;

  void update() {
    axes->SetDraw(visible);
    gravity->SetDraw(has_down);
  }
  void placeLetters(const Eigen::Vector3d& back);
};

/// Beyond the tips as they are seen: an axis that points at the viewer is short, and has its letter beside it.
void SceneCorners::Parts::placeLetters(const Eigen::Vector3d& back) {
  constexpr double kShort = 0.15;
  std::array<Eigen::Vector3d, 3> seen;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    seen.at(static_cast<std::size_t>(k)) = axis - axis.dot(back) * back;
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Eigen::Vector3d away =
        seen.at(k).norm() > kShort ? seen.at(k) : Eigen::Vector3d(-seen.at((k + 1) % 3) - seen.at((k + 2) % 3));
    const Eigen::Vector3d p =
        kAxisLength * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k)) + kLetterBeyond * away.normalized();
    letters.at(k)->SetPosition(p.x(), p.y(), p.z());
  }
}

SceneCorners::SceneCorners() : parts_(std::make_unique<Parts>()) {
  for (vtkRenderer* renderer : {parts_->axes.Get(), parts_->gravity.Get()}) {
    renderer->SetLayer(1);
    renderer->InteractiveOff();
    renderer->GetActiveCamera()->ParallelProjectionOn();
    renderer->GetActiveCamera()->SetParallelScale(kLengthRange);
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

SceneCorners::~SceneCorners() = default;

void SceneCorners::attachTo(vtkRenderWindow* window) {
  window->AddRenderer(parts_->axes);
  window->AddRenderer(parts_->gravity);
}

void SceneCorners::detachFrom(vtkRenderWindow* window) {
  window->RemoveRenderer(parts_->axes);
  window->RemoveRenderer(parts_->gravity);
}

void SceneCorners::setColors(const SceneColors& colors) {
  Rgb shaft = colors.arrow_shaft;
  Rgb head = colors.arrow_head;
  parts_->shaft.actor->GetProperty()->SetColor(shaft.data());
  parts_->head->GetProperty()->SetColor(head.data());
  for (std::size_t k = 0; k < colors.axis.size(); ++k) {
    Rgb axis = colors.axis.at(k);
    parts_->axis_sticks.at(k)->actor->GetProperty()->SetColor(axis.data());
    parts_->letters.at(k)->GetTextProperty()->SetColor(axis.data());
  }
}

void SceneCorners::setDown(const std::optional<Eigen::Vector3d>& down_o) {
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

void SceneCorners::setAxesVisible(bool visible) {
  parts_->visible = visible;
  parts_->update();
}

void SceneCorners::setTextVisible(bool visible) {
  for (auto& letter : parts_->letters) letter->SetVisibility(visible);
}

void SceneCorners::setSmoothed(bool smoothed) {
  parts_->axes->SetUseFXAA(smoothed);
  parts_->gravity->SetUseFXAA(smoothed);
}

void SceneCorners::follow(vtkCamera* camera, vtkRenderWindow* window) {
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
  double back[3];
  camera->GetDirectionOfProjection(back);
  double up[3];
  camera->GetViewUp(up);
  parts_->placeLetters(-Eigen::Vector3d(back));
  for (vtkRenderer* renderer : {parts_->axes.Get(), parts_->gravity.Get()}) {
    vtkCamera* own = renderer->GetActiveCamera();
    own->SetFocalPoint(0, 0, 0);
    own->SetPosition(-5 * back[0], -5 * back[1], -5 * back[2]);
    own->SetViewUp(up);
    own->SetClippingRange(1, 10);
  }
}

}  // namespace hexoderm
