#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/capture/calm_up.h"
#include "widgets/controls/arrow_keys.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/scene/part_camera.h"
#include "widgets/scene/patch_scene.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <Eigen/Core>

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QObject>
#include <QPoint>
#include <QTimeLine>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

class QWidget;

namespace hexoderm {

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
  PartMotion(QWidget* view, QWidget* canvas, QToolButton* button, PatchScene& scene, std::function<void()> render)
      : view_(view), canvas_(canvas), scene_(scene), render_(std::move(render)), button_(named(button, "turnThePart")) {
    button_->setText(tr("Turn the part"));
    button_->setCheckable(true);
    button_->setToolTip(
        tr("Dragging and the arrow keys turn the part instead of the picture; dragging with Shift always does"));
    button_->hide();
    connect(button_, &QToolButton::toggled, this, [this](bool on) {
      canvas_->setCursor(on ? Qt::OpenHandCursor : Qt::ArrowCursor);
      if (on) view_->setFocus();
    });
    setUpOnce(request_soon_, kRequestEvery_ms, this, &PartMotion::request);
    turn_over_.setSingleShot(true);
    turn_over_.setInterval(kTurnOver_ms);
    turns_.setUpdateInterval(kFrame_ms);
    turns_.setLoopCount(kPlays);
    turns_.setEasingCurve(QEasingCurve::Linear);
    connect(&turns_, &QTimeLine::valueChanged, this, &PartMotion::turnGhost);
    connect(&turns_, &QTimeLine::finished, this, [this] { turnGhost(1); });
    // Later than the view's own: what turns the part is not seen by anybody else.
    canvas_->installEventFilter(this);
    view_->installEventFilter(this);
  }

  /// Hands the moment on to the scene with the up direction that CalmUp makes of it, and starts the ghost's turn where
  /// the next pose is another one.
  void setMoment(const PatchMoment& moment) {
    PatchMoment shown = moment;
    shown.up_o = calm_up_.follow(moment.up_o);
    const std::optional<Eigen::Vector3d> up_before = std::exchange(up_o_, shown.up_o);
    const std::optional<Eigen::Vector3d> next_before = std::exchange(next_o_, moment.next_up_o);
    scene_.setMoment(shown);
    const bool is_other_next = next_o_.has_value() != next_before.has_value() ||
                               (next_o_ && angleBetween(*next_o_, *next_before) > kOtherNext);
    if (is_other_next) play();
    if (up_o_ != up_before || next_o_ != next_before) render_();
  }

  void setTurnable(bool turnable) {
    turnable_ = turnable;
    if (!turnable) {
      button_->setChecked(false);
      is_dragging_ = false;
      request_soon_.stop();
    }
    button_->setVisible(turnable);
  }

  /// Off: the ghost does not move and is shown in the orientation in which the part should be held.
  void setAnimated(bool animated) {
    animated_ = animated;
    play();
  }

  [[nodiscard]] bool isAnimating() const { return turns_.state() == QTimeLine::Running; }

 signals:
  /// The part should be turned until this direction points up; at most 20 times a second.
  void turnRequested(Eigen::Vector3d up_o);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == view_) return event->type() == QEvent::KeyPress && onKey(event);
    switch (event->type()) {
      case QEvent::Hide:
        turns_.stop();
        return false;
      case QEvent::Show:
        if (next_o_ && animated_) play();
        return false;
      case QEvent::MouseButtonPress:
      case QEvent::MouseMove:
      case QEvent::MouseButtonRelease:
        return onMouse(event);
      default:
        return false;
    }
  }

 private:
  static constexpr int kPlay_ms = 2000;
  static constexpr double kTurning = 0.65;  // share of it
  static constexpr int kPlays = 3;
  static constexpr int kFrame_ms = 40;
  static constexpr double kOtherNext = 5 * kDegree;
  static constexpr double kKeyStep = 5 * kDegree;
  static constexpr int kTurnOver_ms = 800;
  /// Slow at both ends.
  static double eased(double t) { return t * t * (3 - 2 * t); }

  bool onMouse(QEvent* event) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const bool wanted = turnable_ && (button_->isChecked() || (mouse->modifiers() & Qt::ShiftModifier) != 0);
    if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton && wanted) {
      beginTurn();
      is_dragging_ = true;
      last_ = mouse->pos();
      canvas_->setCursor(Qt::ClosedHandCursor);
      return true;
    }
    if (!is_dragging_) return false;
    // The position of the release counts too: of moves that follow each other quickly, some are not reported.
    if (event->type() != QEvent::MouseButtonPress) {
      const QPoint moved = mouse->pos() - last_;
      last_ = mouse->pos();
      const double per_pixel = kPi / std::max(1, canvas_->height());
      turnBy(per_pixel * moved.x(), per_pixel * moved.y());
    }
    if (event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton) {
      is_dragging_ = false;
      canvas_->setCursor(button_->isChecked() ? Qt::OpenHandCursor : Qt::ArrowCursor);
    }
    return true;
  }

  bool onKey(QEvent* event) {
    if (!turnable_ || !button_->isChecked()) return false;
    const auto way = directionOfKey(static_cast<QKeyEvent*>(event)->key());
    if (!way) return false;
    // Keys that follow each other quickly add up, although the part has not arrived yet.
    if (!turn_over_.isActive()) beginTurn();
    turn_over_.start();
    turnBy(kKeyStep * way->x(), -kKeyStep * way->y());
    return true;
  }

  void beginTurn() {
    vtkCamera* camera = scene_.renderer()->GetActiveCamera();
    double view_up[3];
    camera->GetViewUp(view_up);
    wanted_up_o_ = up_o_ ? *up_o_ : scene_.upShown().value_or(Eigen::Vector3d(view_up[0], view_up[1], view_up[2]));
    wanted_up_o_.normalize();
    right_o_ = rightInPicture(camera, wanted_up_o_);
  }

  /// Turns the part as if its front were dragged. To the right it turns about gravity, which no sensor feels: the
  /// picture alone shows it. Downwards its upper edge comes nearer.
  void turnBy(double right_rad, double down_rad) {
    if (right_rad != 0) {
      right_o_ = expSO3(-right_rad * wanted_up_o_) * right_o_;
      scene_.spin(right_rad);
      render_();
    }
    if (down_rad == 0) return;
    wanted_up_o_ = (expSO3(-down_rad * right_o_) * wanted_up_o_).normalized();
    if (request_soon_.isActive()) return;
    const qint64 since = since_request_.isValid() ? since_request_.elapsed() : kRequestEvery_ms;
    if (since >= kRequestEvery_ms) {
      request();
    } else {
      request_soon_.start(static_cast<int>(kRequestEvery_ms - since));
    }
  }

  void request() {
    since_request_.start();
    emit turnRequested(wanted_up_o_);
  }

  void play() {
    turns_.stop();
    const bool moves = next_o_ && animated_;
    turnGhost(moves ? 0 : 1);
    if (moves && canvas_->isVisible()) turns_.start();
  }

  /// `share`: of the time of one turn, at the end of which it rests.
  void turnGhost(double share) {
    const double phase = eased(std::min(1.0, share / kTurning));
    // While it rests there is nothing to draw.
    if (std::exchange(ghost_phase_, phase) == phase) return;
    scene_.setGhostPhase(phase);
    render_();
  }

  QWidget* view_;
  QWidget* canvas_;
  PatchScene& scene_;
  std::function<void()> render_;
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
  QTimeLine turns_{kPlay_ms};  ///< of the ghost
  double ghost_phase_ = 1;
};

}  // namespace hexoderm
