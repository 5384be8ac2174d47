#pragma once

#include "widgets/style/palette.h"

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

/// Motion in the 3D view while poses are captured: the picture follows the part, the ghost of the next pose turns to
/// its orientation, and the mouse or the arrow keys turn the part if it obeys.
class PartMotion : public QObject {
  Q_OBJECT

 public:
  static constexpr int kRequestEvery_ms = 50;

  /// `view` gets the keys, `canvas` (inside of it) the mouse; `button` switches what dragging turns, and is shown while
  /// the part can be turned. All must outlive this but `canvas`.
  /// `render` asks for a picture soon.
  PartMotion(QWidget* view, QWidget* canvas, QToolButton* button, PatchScene& scene, std::function<void()> render);
  ~PartMotion() override;

  /// Unit vectors in the frame of the largest patch. None: the picture stays as it is.
  void setUp(const std::optional<Eigen::Vector3d>& up_o);
  void setNextUp(const std::optional<Eigen::Vector3d>& up_o);
  void setNextTurn(const QString& angle);
  /// The skin or its shape is another one.
  void refresh();
  void setTurnable(bool turnable);
  /// Off: the ghost is shown as it should be held, and does not move.
  void setAnimated(bool animated);
  void setTheme(Theme theme);
  /// Paints the caption beside the ghost, into a screenshot of this size.
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

  std::optional<Eigen::Vector3d> up_o_;
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
