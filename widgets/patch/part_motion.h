#pragma once

#include "hexoderm/capture/calm_up.h"

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QTimer>
#include <functional>
#include <optional>

class QPainter;
class QToolButton;
class QWidget;

namespace hexoderm {

class PatchScene;
class GhostCaption;
struct PatchMoment;

/// The motion in the 3D view while poses are captured: the picture follows the part, the ghost of the next pose turns
/// to the orientation in which the part should be held, and the mouse or the arrow keys ask for turns of the part.
class PartMotion : public QObject {
  Q_OBJECT

 public:
  static constexpr int kRequestEvery_ms = 50;

  /// `view` receives the keys, and `canvas`, which lies inside it, the mouse. `button` decides whether dragging turns
  /// the picture or the part, and is shown while the part can be turned. `render` asks for a picture soon. All but
  /// `canvas` must outlive this.
  PartMotion(QWidget* view, QWidget* canvas, QToolButton* button, PatchScene& scene, std::function<void()> render);
  ~PartMotion() override;

  /// Hands the moment on to the scene with the up direction that CalmUp makes of it, and starts the ghost's turn where
  /// the next pose is another one.
  void setMoment(const PatchMoment& moment);
  /// Must be called when another skin, or another shape of it, is shown.
  void refresh();
  void setTurnable(bool turnable);
  /// Off: the ghost does not move and is shown in the orientation in which the part should be held.
  void setAnimated(bool animated);
  /// Paints the words beside the ghost into a screenshot of this size.
  void paintCaption(QPainter& painter, const QSize& area) const;

  [[nodiscard]] bool isAnimating() const { return frames_.isActive(); }

 signals:
  /// The part should be turned until this direction points up; at most 20 times a second.
  void turnRequested(Eigen::Vector3d up_o);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool onMouse(QEvent* event);
  bool onKey(QEvent* event);
  void beginTurn();
  void turnBy(double right_rad, double down_rad);
  void request();
  void play();
  void nextFrame();
  void updateCaption();
  void place();

  QWidget* view_;
  QWidget* canvas_;
  PatchScene& scene_;
  std::function<void()> render_;
  GhostCaption* caption_;
  QToolButton* button_;

  CalmUp calm_up_;
  std::optional<Eigen::Vector3d> up_o_;  ///< shown
  std::optional<Eigen::Vector3d> next_o_;

  bool turnable_ = false;
  bool is_dragging_ = false;
  QPoint last_;
  Eigen::Vector3d wanted_up_o_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d right_o_ = Eigen::Vector3d::UnitX();  ///< right of the picture, with the part turned as wanted
  QTimer request_soon_;
  QElapsedTimer since_request_;
  QTimer turn_over_;  ///< the keys have rested: the next turn starts from where the part is

  bool animated_ = true;
  QTimer frames_;
  QElapsedTimer since_start_;
};

}  // namespace hexoderm
