#pragma once

#include "widgets/patch/hollow_shading.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/scene/patch_scene.h"

#include <vtkCommand.h>
#include <vtkInteractorObserver.h>
#include <vtkRenderWindowInteractor.h>

#include <QObject>
#include <QTimer>
#include <optional>

namespace hexoderm {

/// When the pictures of a scene are smoothed, and by whom. While the mouse turns the scene, they come without the
/// shader that smooths. Without a graphics card, where that shader takes longer than the drawing, the processor smooths
/// each picture instead, as long as it is quick enough, and otherwise the picture at rest.
class PictureSmoothing : public QObject {
 public:
  /// `by_processor`: there is no graphics card. The canvas has its interactor style already; both must outlive this.
  PictureSmoothing(SceneWidget* canvas, PatchScene& scene, bool by_processor)
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

  /// A picture was asked for.
  void expectRender() {
    if (by_processor_) at_rest_.start();
  }

  /// Draws at once, as smoothly as possible.
  void drawNow() {
    at_rest_.stop();
    scene_.setSmoothed(!by_processor_);
    canvas_->drawNow();
    if (by_processor_) canvas_->smoothPicture();
  }

 private:
  void startInteraction() {
    at_rest_.stop();
    scene_.setSmoothed(false);
  }

  void endInteraction() { at_rest_.start(); }
  void smoothAtRest() {
    if (by_processor_) {
      canvas_->smoothPictureBeside();
      return;
    }
    scene_.setSmoothed(true);
    if (canvas_->isVisible()) canvas_->requestRender();
  }

  [[nodiscard]] std::optional<HollowSight> hollowSight() const {
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

  SceneWidget* canvas_;
  PatchScene& scene_;
  bool by_processor_;
  QTimer at_rest_;
};

}  // namespace hexoderm
