#include "widgets/scene/scene_labels.h"

#include "hexoderm/util/units.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kMinLabelFacing = 0.4;  // cosine between a face and the line of sight
constexpr int kMinLabelPixels = 8;
constexpr double kTightest = 0.65;  // share of its room that a label of that size is given at least
constexpr int kMaxLabelPixels = 26;

}  // namespace

struct SceneLabels::Label {
  vtkNew<vtkBillboardTextActor3D> actor;
  Eigen::Vector3d anchor;
  Eigen::Vector3d normal;
};

SceneLabels::SceneLabels(vtkRenderer* renderer) : renderer_(renderer) {}

SceneLabels::~SceneLabels() = default;

void SceneLabels::setContent(const std::shared_ptr<const SceneContent>& content) {
  const std::size_t cells = content ? content->layout.cells.size() : 0;
  const std::size_t wanted = cells <= kMaxLabelledCells ? cells : 0;
  while (labels_.size() > wanted) {
    renderer_->RemoveActor(labels_.back()->actor);
    labels_.pop_back();
  }
  while (labels_.size() < wanted) {
    labels_.push_back(std::make_unique<Label>());
    vtkTextProperty* property = labels_.back()->actor->GetTextProperty();
    property->SetJustificationToCentered();
    property->SetVerticalJustificationToCentered();
    property->BoldOn();
    labels_.back()->actor->PickableOff();
    // Drawn after all faces: what is not letter is let through, and VTK's pass for translucent things, which takes
    // longer than everything else in a software renderer, is not needed.
    labels_.back()->actor->ForceOpaqueOn();
    renderer_->AddActor(labels_.back()->actor);
  }
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    const SceneCell& cell = content->layout.cells[k];
    labels_[k]->actor->SetInput(toString(cell.id).c_str());
    labels_[k]->anchor = cell.T_s_u.t;
    labels_[k]->normal = cell.T_s_u.R.col(2);
  }
  if (content) side_m_ = content->reconstruction->model->side_m;
}

void SceneLabels::setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors) {
  for (std::size_t k = 0; k < std::min(labels_.size(), front_colors.size()); ++k) {
    Rgb mark = markOn(front_colors[k], colors);
    labels_[k]->actor->GetTextProperty()->SetColor(mark.data());
  }
}

void SceneLabels::setVisible(bool visible) { visible_ = visible; }

void SceneLabels::update(const std::array<int, 2>& window_size, int dpi) {
  if (labels_.empty()) return;
  vtkCamera* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d eye(camera->GetPosition());
  const Eigen::Vector3d back = -Eigen::Vector3d(camera->GetDirectionOfProjection());
  const bool parallel = camera->GetParallelProjection() != 0;
  const double pixels_at_one_m = 0.5 * window_size[1] / std::tan(0.5 * camera->GetViewAngle() * kDegree);
  const double pixels_parallel = 0.5 * window_size[1] / camera->GetParallelScale();
  const double text_scale = dpi / 72.0;
  for (const auto& label : labels_) {
    const Eigen::Vector3d sight = eye - label->anchor;
    const double distance = sight.norm();
    const Eigen::Vector3d toward = parallel ? back : Eigen::Vector3d(sight / distance);
    const double facing = label->normal.dot(toward);
    const double pixels_per_m = parallel ? pixels_parallel : pixels_at_one_m / distance;
    // Even sizes only, so that zooming does not make new letters at every step.
    const double wanted = 0.52 * side_m_ * pixels_per_m / text_scale;
    const int font = std::max(kMinLabelPixels, 2 * static_cast<int>(std::min(wanted, 1.0 * kMaxLabelPixels) / 2));
    const bool visible = visible_ && facing > kMinLabelFacing && wanted >= kTightest * kMinLabelPixels;
    label->actor->SetVisibility(visible);
    if (!visible) continue;
    if (label->actor->GetTextProperty()->GetFontSize() != font) label->actor->GetTextProperty()->SetFontSize(font);
    // The text stands upright to the viewer: it moves along the line of sight until its own tilted face can't cut it,
    // and stays behind everything that really is in front.
    const double tilt = std::sqrt(std::max(0.0, 1 - facing * facing)) / facing;
    const Eigen::Vector3d p = label->anchor + side_m_ * (0.05 + 0.4 * tilt) * toward;
    label->actor->SetPosition(p.x(), p.y(), p.z());
  }
}

}  // namespace hexoderm
