#include "widgets/patch/patch_clicks.h"

#include "widgets/patch/scene_widget.h"
#include "widgets/scene/patch_scene.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <utility>

namespace hexoderm {

PatchClicks::PatchClicks(SceneWidget* canvas, PatchScene& scene, std::function<void()> render)
    : canvas_(canvas), scene_(scene), render_(std::move(render)) {
  canvas_->installEventFilter(this);
}

QPointF PatchClicks::inScene(const QPoint& position) const {
  return canvas_->devicePixelRatioF() * QPointF(position.x(), canvas_->height() - 1 - position.y());
}

bool PatchClicks::turnByKnobAt(const QPoint& position) {
  const QPointF at = inScene(position);
  const auto wanted = scene_.viewAt(at.x(), at.y());
  if (!wanted) return false;
  scene_.showStandardView(*wanted);
  render_();
  return true;
}

void PatchClicks::hoverAt(const QPoint& position) {
  const QPointF at = inScene(position);
  if (scene_.hoverAxes(at.x(), at.y())) render_();
}

bool PatchClicks::eventFilter(QObject* /*watched*/, QEvent* event) {
  constexpr int kClickSlack = 3;  // pixels that a hand trembles within a click
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      pressed_at_ = static_cast<QMouseEvent*>(event)->pos();
      return false;
    case QEvent::MouseMove:
      hoverAt(static_cast<QMouseEvent*>(event)->pos());
      return false;
    case QEvent::Leave:
      hoverAt({-1, -1});
      return false;
    case QEvent::ContextMenu:  // comes when the button goes down, and dragging with it zooms
      return static_cast<QContextMenuEvent*>(event)->reason() == QContextMenuEvent::Mouse;
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if ((mouse->pos() - pressed_at_).manhattanLength() > kClickSlack) return false;
      if (mouse->button() == Qt::LeftButton && !turnByKnobAt(mouse->pos())) emit clicked(mouse->pos());
      if (mouse->button() == Qt::RightButton) emit menuWanted(mouse->pos());
      return false;
    }
    default:
      return false;
  }
}

}  // namespace hexoderm
