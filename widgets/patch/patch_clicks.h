#pragma once

#include "widgets/patch/scene_widget.h"
#include "widgets/scene/patch_scene.h"

#include <vtkRenderer.h>
#include <QApplication>
#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>
#include <utility>

namespace hexoderm {

/// Presses of the mouse on the 3D scene that turn nothing: a click on a knob of the axes looks from there, any other is
/// a click of the left button or asks for the menu by the right one, when it is let go where it was pressed. Lights the
/// knob under the mouse.
class PatchClicks : public QObject {
  Q_OBJECT

 public:
  /// `render` asks for a picture soon. All must outlive this.
  PatchClicks(SceneWidget* canvas, PatchScene& scene, std::function<void()> render)
      : canvas_(canvas), scene_(scene), render_(std::move(render)) {
    canvas_->installEventFilter(this);
  }

 signals:
  /// Positions on the canvas.
  void clicked(const QPoint& position);
  void menuWanted(const QPoint& position);

 protected:
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
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

 private:
  /// Turns the picture if there is a knob.
  bool turnByKnobAt(const QPoint& position) {
    const Eigen::Vector2d at = canvas_->pixelAt(position);
    const auto wanted = scene_.viewAt(at.x(), at.y());
    if (!wanted) return false;
    scene_.showStandardView(*wanted);
    render_();
    return true;
  }

  void hoverAt(const QPoint& position) {
    const Eigen::Vector2d at = canvas_->pixelAt(position);
    if (scene_.hoverAxes(at.x(), at.y())) render_();
  }

  SceneWidget* canvas_;
  PatchScene& scene_;
  std::function<void()> render_;
  QPoint pressed_at_;
};

}  // namespace hexoderm
