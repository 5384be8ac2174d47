#include "widgets/patch/picture_smoothing.h"

#include "widgets/patch/scene_widget.h"
#include "widgets/scene/patch_scene.h"

#include <vtkCommand.h>
#include <vtkInteractorObserver.h>
#include <vtkRenderWindowInteractor.h>

namespace hexoderm {

PictureSmoothing::PictureSmoothing(SceneWidget* canvas, PatchScene& scene, bool by_processor)
    : canvas_(canvas), scene_(scene), by_processor_(by_processor) {
  constexpr int kRest_ms = 150;
  constexpr double kSmoothing_ms = 8;  // a quarter of a picture's time at 30 a second
  scene_.setSmoothed(!by_processor_);
  if (by_processor_) canvas_->setSmoothingBudget(kSmoothing_ms);
  canvas_->setHollows([this] { return hollowSight(); });
  at_rest_.setSingleShot(true);
  at_rest_.setInterval(kRest_ms);
  connect(&at_rest_, &QTimer::timeout, this, &PictureSmoothing::smoothAtRest);
  vtkInteractorObserver* style = canvas_->renderWindow()->GetInteractor()->GetInteractorStyle();
  style->AddObserver(vtkCommand::StartInteractionEvent, this, &PictureSmoothing::startInteraction);
  style->AddObserver(vtkCommand::EndInteractionEvent, this, &PictureSmoothing::endInteraction);
}

void PictureSmoothing::expectRender() {
  if (by_processor_) at_rest_.start();
}

void PictureSmoothing::drawNow() {
  at_rest_.stop();
  scene_.setSmoothed(!by_processor_);
  canvas_->drawNow();
  if (by_processor_) canvas_->smoothPicture();
}

void PictureSmoothing::startInteraction() {
  at_rest_.stop();
  scene_.setSmoothed(false);
}

void PictureSmoothing::smoothAtRest() {
  if (by_processor_) {
    canvas_->smoothPictureBeside();
    return;
  }
  scene_.setSmoothed(true);
  if (canvas_->isVisible()) canvas_->requestRender();
}

std::optional<HollowSight> PictureSmoothing::hollowSight() const {
  constexpr double kFull = 0.25;  // share of a cell's side: what stands out by as much is no more part of the surface
  if (scene_.content() == nullptr) return std::nullopt;
  const PatchScene::Depths depths = scene_.depths();
  HollowSight sight{
      depths.near_m, depths.far_m, depths.parallel, kFull * scene_.content()->reconstruction->model->side_m, {}};
  const int height = canvas_->renderWindow()->GetSize()[1];
  for (const auto& [left, bottom, right, top] : depths.elsewhere) {
    sight.elsewhere.emplace_back(left, height - top, right - left, top - bottom);
  }
  return sight;
}

}  // namespace hexoderm
