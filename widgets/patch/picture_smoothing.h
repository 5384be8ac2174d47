#pragma once

#include "widgets/patch/hollow_shading.h"

#include <QObject>
#include <QTimer>
#include <optional>

namespace hexoderm {

class PatchScene;
class SceneWidget;

/// When the pictures of a scene are smoothed, and by whom. While the mouse turns the scene, they come without the
/// shader that smooths. Without a graphics card, where that shader takes longer than the drawing, the processor smooths
/// each picture instead, as long as it is quick enough, and otherwise the picture at rest.
class PictureSmoothing : public QObject {
 public:
  /// `by_processor`: there is no graphics card. The canvas has its interactor style already; both must outlive this.
  PictureSmoothing(SceneWidget* canvas, PatchScene& scene, bool by_processor);

  /// A picture was asked for.
  void expectRender();
  /// Draws at once, as smoothly as possible.
  void drawNow();

 private:
  void startInteraction();
  void endInteraction() { at_rest_.start(); }
  void smoothAtRest();
  [[nodiscard]] std::optional<HollowSight> hollowSight() const;

  SceneWidget* canvas_;
  PatchScene& scene_;
  bool by_processor_;
  QTimer at_rest_;
};

}  // namespace hexoderm
