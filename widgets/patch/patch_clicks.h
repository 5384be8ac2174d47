#pragma once

#include <QObject>
#include <QPoint>
#include <QPointF>
#include <functional>

namespace hexoderm {

class PatchScene;
class SceneWidget;

/// Presses of the mouse on the 3D scene that turn nothing: a click on a knob of the axes looks from there, any other is
/// a click of the left button or asks for the menu by the right one, when it is let go where it was pressed. Lights the
/// knob under the mouse.
class PatchClicks : public QObject {
  Q_OBJECT

 public:
  /// `render` asks for a picture soon. All must outlive this.
  PatchClicks(SceneWidget* canvas, PatchScene& scene, std::function<void()> render);

 signals:
  /// Positions on the canvas.
  void clicked(const QPoint& position);
  void menuWanted(const QPoint& position);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Where the scene counts its pixels.
  [[nodiscard]] QPointF inScene(const QPoint& position) const;
  /// Turns the picture if there is a knob.
  bool turnByKnobAt(const QPoint& position);
  void hoverAt(const QPoint& position);

  SceneWidget* canvas_;
  PatchScene& scene_;
  std::function<void()> render_;
  QPoint pressed_at_;
};

}  // namespace hexoderm
