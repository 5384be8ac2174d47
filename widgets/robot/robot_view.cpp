#include "widgets/robot/robot_view.h"

#include "hexoderm/util/units.h"
#include "widgets/controls/heavy_turn.h"
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

struct RobotView::Parts {
  SceneWidget* canvas = nullptr;  ///< null without OpenGL
  std::unique_ptr<RobotScene> scene;
  QLabel* hint = nullptr;
  QPoint pressed_at;
};

RobotView::RobotView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("robotView"));
  setAccessibleName(tr("The robot in three dimensions"));
  setMinimumSize(320, 240);
}

RobotView::~RobotView() {
  if (!parts_) return;
  // The scene gives its OpenGL objects back while the context is still there.
  parts_->scene.reset();
  delete parts_->canvas;
}

void RobotView::build() {
  parts_ = std::make_unique<Parts>();
  auto* layout = new QVBoxLayout(this);
  constexpr int kFrame = 2;  // shows that the view has the keyboard
  layout->setContentsMargins(kFrame, kFrame, kFrame, kFrame);
  const OpenGlInfo opengl = queryOpenGl();
  if (!opengl.usable) {
    parts_->hint =
        new QLabel(tr("The 3D view needs OpenGL 3.2, which is not available here. Links, places and points can "
                      "still be chosen in the lists."));
    parts_->hint->setWordWrap(true);
    parts_->hint->setAlignment(Qt::AlignCenter);
    parts_->hint->setMargin(24);
    layout->addWidget(parts_->hint);
    return;
  }
  parts_->canvas = new SceneWidget(opengl.software, this);
  parts_->canvas->setAccessibleName(accessibleName());
  parts_->canvas->setFocusPolicy(Qt::NoFocus);
  parts_->canvas->installEventFilter(this);
  parts_->canvas->renderWindow()->GetInteractor()->SetInteractorStyle(makeSceneInteractorStyle());
  parts_->scene = std::make_unique<RobotScene>();
  parts_->scene->attachTo(parts_->canvas->renderWindow());
  layout->addWidget(parts_->canvas);
  setFocusPolicy(Qt::TabFocus);
  dress();
}

void RobotView::setPicture(const RobotPicture& picture) {
  picture_ = picture;
  if (!parts_ && picture.bodies) build();
  if (!parts_ || !parts_->scene) return;
  parts_->scene->setPicture(picture);
  HeavyTurn::note();
  requestRender();
}

void RobotView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (dressed_.isChangedBy(*event)) dress();
}

void RobotView::dress() {
  if (!canDraw()) return;
  parts_->scene->setColors(sceneColors(themeOf(palette())));
  parts_->canvas->setBackground(Colors::of(palette()).scene_bottom);
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
  if (!parts_ || parts_->canvas == nullptr) return;
  parts_->canvas->setCursor(pulling_ ? Qt::ClosedHandCursor : picking_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

bool RobotView::canDraw() const { return parts_ && parts_->scene; }

void RobotView::requestRender() {
  if (canDraw() && parts_->canvas->isVisible()) parts_->canvas->requestRender();
}

void RobotView::drawNow() {
  if (canDraw()) parts_->canvas->drawNow();
}

QImage RobotView::screenshot() {
  if (!canDraw()) return {};
  drawNow();
  return parts_->canvas->picture();
}

void RobotView::fit() {
  if (!canDraw()) return;
  parts_->scene->fit();
  requestRender();
}

void RobotView::lookAtSkin(std::optional<std::size_t> patch) {
  if (!canDraw()) return;
  parts_->scene->lookAtSkin(patch);
  requestRender();
}

std::pair<double, double> RobotView::pixelAt(const QPoint& position) const {
  const double ratio = parts_->canvas->devicePixelRatioF();
  return {ratio * position.x(), ratio * (parts_->canvas->height() - 1 - position.y())};
}

void RobotView::pickAt(const QPoint& position) {
  const auto [x, y] = pixelAt(position);
  const auto picked = parts_->scene->pick(x, y);
  if (picked) emit pointPicked(picked->link, picked->x_l);
}

bool RobotView::beginPulling(const QPoint& position) {
  if (picking_ || !picture_.movable) return false;
  const auto [x, y] = pixelAt(position);
  const auto grip = parts_->scene->grip(x, y);
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
  const auto [x, y] = pixelAt(position);
  const auto picked = parts_->scene->pick(x, y);
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
      parts_->pressed_at = mouse->pos();
      return mouse->button() == Qt::LeftButton && beginPulling(mouse->pos());
    }
    case QEvent::MouseMove: {
      const QPoint at = static_cast<QMouseEvent*>(event)->pos();
      if (pulling_ && (at - parts_->pressed_at).manhattanLength() > kClickSlack) pullTo(at);
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
      const bool is_click = (mouse->pos() - parts_->pressed_at).manhattanLength() <= kClickSlack;
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
  const double way_m = times * kMillimetre;
  const auto slide = [&](double right_m, double up_m) {
    emit slid(parts_->scene->wayOnScreen(right_m, up_m, picture_.patches[*picture_.movable].link));
  };
  switch (event.key()) {
    case Qt::Key_Left:
      slide(-way_m, 0);
      return true;
    case Qt::Key_Right:
      slide(way_m, 0);
      return true;
    case Qt::Key_Up:
      slide(0, way_m);
      return true;
    case Qt::Key_Down:
      slide(0, -way_m);
      return true;
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
  switch (event->key()) {
    case Qt::Key_Left:
      parts_->scene->turn(-kTurn_deg, 0);
      break;
    case Qt::Key_Right:
      parts_->scene->turn(kTurn_deg, 0);
      break;
    case Qt::Key_Up:
      parts_->scene->turn(0, kTurn_deg);
      break;
    case Qt::Key_Down:
      parts_->scene->turn(0, -kTurn_deg);
      break;
    case Qt::Key_Plus:
      parts_->scene->zoom(kZoom);
      break;
    case Qt::Key_Minus:
      parts_->scene->zoom(1 / kZoom);
      break;
    default:
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
