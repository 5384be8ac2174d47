#include "widgets/robot/robot_view.h"

#include "hexoderm/base/units.h"
#include "widgets/controls/heavy_turn.h"
#include "widgets/patch/arrow_keys.h"
#include "widgets/patch/opengl_info.h"
#include "widgets/patch/scene_look.h"
#include "widgets/patch/scene_widget.h"

#include <vtkRenderWindowInteractor.h>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace hexoderm {

RobotView::RobotView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("robotView"));
  setAccessibleName(tr("The robot in three dimensions"));
  setMinimumSize(320, 240);
}

RobotView::~RobotView() {
  // The scene gives its OpenGL objects back while the context is still there.
  scene_.reset();
  delete canvas_;
}

void RobotView::build() {
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
  canvas_->setFocusPolicy(Qt::NoFocus);
  canvas_->installEventFilter(this);
  canvas_->renderWindow()->GetInteractor()->SetInteractorStyle(makeSceneInteractorStyle());
  scene_ = std::make_unique<RobotScene>();
  scene_->attachTo(canvas_->renderWindow());
  layout->addWidget(canvas_);
  setFocusPolicy(Qt::TabFocus);
  dress();
}

void RobotView::setPicture(const RobotPicture& picture) {
  picture_ = picture;
  if (!is_built_ && picture.bodies) build();
  if (!canDraw()) return;
  scene_->setPicture(picture);
  HeavyTurn::note();
  requestRender();
}

void RobotView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (dressed_.isChangedBy(*event)) dress();
}

void RobotView::dress() {
  if (!canDraw()) return;
  scene_->setColors(sceneColors(themeOf(palette())));
  canvas_->setBackground(Colors::of(palette()).scene_bottom);
  requestRender();
}

void RobotView::setPicking(bool picking) {
  picking_ = picking;
  showCursor();
}

void RobotView::setMoving(bool moving) {
  moving_ = moving;
  if (moving) setFocus(Qt::OtherFocusReason);
}

void RobotView::showCursor() {
  if (!canDraw()) return;
  canvas_->setCursor(pulling_ ? Qt::ClosedHandCursor : picking_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

bool RobotView::canDraw() const { return scene_ != nullptr; }

void RobotView::requestRender() {
  if (canDraw() && canvas_->isVisible()) canvas_->requestRender();
}

void RobotView::drawNow() {
  if (canDraw()) canvas_->drawNow();
}

QImage RobotView::screenshot() {
  if (!canDraw()) return {};
  drawNow();
  return canvas_->picture();
}

void RobotView::fit() {
  if (!canDraw()) return;
  scene_->fit();
  requestRender();
}

void RobotView::lookAtSkin(std::optional<std::size_t> patch) {
  if (!canDraw()) return;
  scene_->lookAtSkin(patch);
  requestRender();
}

void RobotView::pickAt(const QPoint& position) {
  const Eigen::Vector2d pixel = canvas_->pixelAt(position);
  const auto picked = scene_->pick(pixel.x(), pixel.y());
  if (picked) emit pointPicked(picked->link, picked->x_l);
}

bool RobotView::beginPulling(const QPoint& position) {
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
void RobotView::pullTo(const QPoint& position) {
  if (!picture_.movable) return;
  const Eigen::Vector2d pixel = canvas_->pixelAt(position);
  const auto picked = scene_->pick(pixel.x(), pixel.y());
  if (picked && picked->link == picture_.patches[*picture_.movable].link) emit pulledTo(picked->x_l);
}

bool RobotView::eventFilter(QObject* /*watched*/, QEvent* event) {
  constexpr int kClickSlack = 3;  // pixels that a hand trembles within a click
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      event->ignore();  // so that it goes on to the window
      return true;
    case QEvent::Show:
    case QEvent::Resize:
      requestRender();
      return false;
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

bool RobotView::moveByKey(const QKeyEvent& event) {
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

void RobotView::keyPressEvent(QKeyEvent* event) {
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

void RobotView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Colors::of(palette()).scene_bottom);
  if (!hasFocus()) return;
  painter.setPen(QPen(Colors::of(palette()).accent, 2));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

}  // namespace hexoderm
