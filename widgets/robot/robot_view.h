#pragma once

#include "hexoderm/base/units.h"
#include "widgets/controls/arrow_keys.h"
#include "widgets/controls/heavy_turn.h"
#include "widgets/patch/opengl_info.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/robot/robot_scene.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/dressed_theme.h"

#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPoint>
#include <QVBoxLayout>
#include <QWidget>
#include <memory>
#include <optional>

namespace hexoderm {

/// The robot in 3D with the skin on it, to be turned by the mouse, or by the arrow keys once it has the keyboard. It
/// computes nothing itself; without OpenGL it says so in words and stays empty.
///
/// The patch that the picture calls movable can be moved by hand: the mouse grips and pulls it, and in a mode of its
/// own the keyboard slides and turns it. Where it goes then, the next picture says.
class RobotView : public QWidget {
  Q_OBJECT

 public:
  explicit RobotView(QWidget* parent = nullptr) : QWidget(parent) {
    setObjectName(QStringLiteral("robotView"));
    setAccessibleName(tr("The robot in three dimensions"));
    setMinimumSize(320, 240);
  }

  ~RobotView() override {
    // The scene gives its OpenGL objects back while the context is still there.
    scene_.reset();
    delete canvas_;
  }

  /// Without bodies: an empty view with a hint.
  void setPicture(const RobotPicture& picture) {
    picture_ = picture;
    if (!is_built_ && picture.bodies) build();
    if (!canDraw()) return;
    scene_->setPicture(picture);
    HeavyTurn::note();
    requestRender();
  }

  [[nodiscard]] const RobotPicture& picture() const { return picture_; }

  /// On: the next click on the robot is told by pointPicked().
  void setPicking(bool picking) {
    picking_ = picking;
    showCursor();
  }

  /// On: arrow keys slide the patch and turn the robot no more; the view takes the keyboard.
  void setMoving(bool moving) {
    moving_ = moving;
    if (moving) setFocus(Qt::OtherFocusReason);
  }

  /// Whether anything is drawn at all.
  [[nodiscard]] bool canDraw() const { return scene_ != nullptr; }

  /// Draws at once, instead of in the next turns of the event loop.
  void drawNow() {
    if (canDraw()) canvas_->drawNow();
  }

  /// The scene as drawn; empty without OpenGL.
  [[nodiscard]] QImage screenshot() {
    if (!canDraw()) return {};
    drawNow();
    return canvas_->picture();
  }

 public slots:
  void fit() {
    if (!canDraw()) return;
    scene_->fit();
    requestRender();
  }

  /// The cells with their IDs: of one of the picture's patches, or of all.
  void lookAtSkin(std::optional<std::size_t> patch = std::nullopt) {
    if (!canDraw()) return;
    scene_->lookAtSkin(patch);
    requestRender();
  }

 signals:
  /// A point of a link's body, in the link's frame.
  void pointPicked(std::size_t link, Eigen::Vector3d x_l);
  /// The movable patch is gripped at this point of its link, and pulled to another; then let go.
  void gripped(Eigen::Vector3d x_l);
  void pulledTo(Eigen::Vector3d x_l);
  void released();
  /// By a key: along the screen, in the link's frame, m; counter-clockwise, rad.
  void slid(Eigen::Vector3d way_l);
  void turned(double angle_rad);
  /// Return: it is to lie where it is. Escape: where it was.
  void laid();
  void leftAlone();

 protected:
  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    if (dressed_.isChangedBy(*event)) dress();
  }

  bool eventFilter(QObject*, QEvent* event) override {
    constexpr int kClickSlack = 3;  // pixels that a hand trembles within a click
    switch (event->type()) {
      case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        pressed_at_ = mouse->pos();
        return mouse->button() == Qt::LeftButton && beginPulling(mouse->pos());
      }
      case QEvent::MouseMove: {
        const QPoint at = static_cast<QMouseEvent*>(event)->pos();
        if (pulling_ && (at - pressed_at_).manhattanLength() > kClickSlack) pullTo(at);
        return pulling_;
      }
      case QEvent::MouseButtonRelease: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (pulling_ && mouse->button() == Qt::LeftButton) {
          pulling_ = false;
          showCursor();
          emit released();
          return true;
        }
        const bool is_click = (mouse->pos() - pressed_at_).manhattanLength() <= kClickSlack;
        if (picking_ && mouse->button() == Qt::LeftButton && is_click) pickAt(mouse->pos());
        return false;
      }
      default:
        return false;
    }
  }

  void keyPressEvent(QKeyEvent* event) override {
    constexpr double kTurn_deg = 10;
    constexpr double kZoom = 1.15;
    if (!canDraw()) return QWidget::keyPressEvent(event);
    if ((moving_ || pulling_) && moveByKey(*event)) return;
    if (const auto way = directionOfKey(event->key())) {
      scene_->turn(kTurn_deg * way->x(), kTurn_deg * way->y());
    } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus) {
      scene_->zoom(event->key() == Qt::Key_Plus ? kZoom : 1 / kZoom);
    } else {
      return QWidget::keyPressEvent(event);
    }
    requestRender();
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.fillRect(rect(), Colors::of(palette()).scene_bottom);
    if (!hasFocus()) return;
    painter.setPen(QPen(Colors::of(palette()).accent, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }

 private:
  void build() {
    is_built_ = true;
    auto* layout = new QVBoxLayout(this);
    constexpr int kFrame = 2;  // shows that the view has the keyboard
    layout->setContentsMargins(kFrame, kFrame, kFrame, kFrame);
    const OpenGlInfo opengl = queryOpenGl();
    if (!opengl.usable) {
      auto* hint =
          new QLabel(tr("The 3D view needs OpenGL 3.2, which is not available here. Links, places and points can "
                        "still be chosen in the lists."));
      hint->setWordWrap(true);
      hint->setAlignment(Qt::AlignCenter);
      hint->setMargin(24);
      layout->addWidget(hint);
      return;
    }
    canvas_ = new SceneWidget(opengl.software, this);
    canvas_->setAccessibleName(accessibleName());
    canvas_->installEventFilter(this);
    scene_ = std::make_unique<RobotScene>();
    scene_->attachTo(canvas_->renderWindow());
    layout->addWidget(canvas_);
    setFocusPolicy(Qt::TabFocus);
    dress();
  }

  void dress() {
    if (!canDraw()) return;
    scene_->setColors(sceneColors(themeOf(palette())));
    canvas_->setBackground(Colors::of(palette()).scene_bottom);
    requestRender();
  }

  void requestRender() {
    if (canDraw() && canvas_->isVisible()) canvas_->requestRender();
  }

  void pickAt(const QPoint& position) {
    const Eigen::Vector2d pixel = canvas_->pixelAt(position);
    const auto picked = scene_->pick(pixel.x(), pixel.y());
    if (picked) emit pointPicked(picked->link, picked->x_l);
  }

  bool beginPulling(const QPoint& position) {
    if (picking_ || !picture_.movable) return false;
    const Eigen::Vector2d pixel = canvas_->pixelAt(position);
    const auto grip = scene_->grip(pixel.x(), pixel.y());
    if (!grip || grip->patch != *picture_.movable) return false;
    pulling_ = true;
    showCursor();
    setFocus(Qt::MouseFocusReason);  // for Escape
    emit gripped(grip->x_l);
    return true;
  }

  /// Beside the link the patch stays where it was last.
  void pullTo(const QPoint& position) {
    if (!picture_.movable) return;
    const Eigen::Vector2d pixel = canvas_->pixelAt(position);
    const auto picked = scene_->pick(pixel.x(), pixel.y());
    if (picked && picked->link == picture_.patches[*picture_.movable].link) emit pulledTo(picked->x_l);
  }

  bool moveByKey(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
      pulling_ = false;
      showCursor();
      emit leftAlone();
      return true;
    }
    if (!moving_ || !picture_.movable) return false;
    const double times = (event.modifiers() & Qt::ShiftModifier) != 0 ? 10 : 1;
    if (const auto way = directionOfKey(event.key())) {
      const Eigen::Vector2d way_m = times * kMillimetre * *way;
      emit slid(scene_->wayOnScreen(way_m.x(), way_m.y(), picture_.patches[*picture_.movable].link));
      return true;
    }
    switch (event.key()) {
      case Qt::Key_PageUp:
        emit turned(times * kDegree);
        return true;
      case Qt::Key_PageDown:
        emit turned(-times * kDegree);
        return true;
      case Qt::Key_Return:
      case Qt::Key_Enter:
        emit laid();
        return true;
      default:
        return false;
    }
  }

  void showCursor() {
    if (!canDraw()) return;
    canvas_->setCursor(pulling_ ? Qt::ClosedHandCursor : picking_ ? Qt::CrossCursor : Qt::ArrowCursor);
  }

  DressedTheme dressed_{*this};
  RobotPicture picture_;
  bool picking_ = false;
  bool moving_ = false;                ///< by keys
  bool pulling_ = false;               ///< by the mouse
  bool is_built_ = false;              ///< from the first robot on: getting OpenGL ready takes its time
  SceneWidget* canvas_ = nullptr;      ///< null until then, and without OpenGL
  std::unique_ptr<RobotScene> scene_;  ///< likewise
  QPoint pressed_at_;
};

}  // namespace hexoderm
