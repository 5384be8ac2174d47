#include "widgets/patch/scene_widget.h"

#include "hexoderm/util/thread_priority.h"
#include "widgets/patch/edge_smoothing.h"
#include "widgets/patch/opengl_info.h"

#include <QVTKInteractor.h>
#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <QElapsedTimer>
#include <QEvent>
#include <QOpenGLFunctions>
#include <QPainter>
#include <array>

namespace hexoderm {
namespace {

/// Not in the very next turn of the event loop: the window may be painted in that, and then whoever has clicked
/// meanwhile would wait for both.
constexpr int kRenderAfter_ms = 10;
/// Nor is it shown in the turn that has drawn it.
constexpr int kShowAfter_ms = 1;

/// The threads of a pool end and begin when it likes.
void giveWayOnce() {
  thread_local bool gives_way = false;
  if (!std::exchange(gives_way, true)) giveWayToOtherThreads();
}

}  // namespace

SceneWidget::SceneWidget(QWidget* parent)
    : QWidget(parent),
      render_soon_(kRenderAfter_ms, [this] { window_->Render(); }),
      show_soon_(kShowAfter_ms, [this] { showWhenDrawn(); }) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);  // or all that is below would be painted for each picture
  context_.setFormat(sceneSurfaceFormat());
  context_.create();
  surface_.setFormat(context_.format());
  surface_.create();
  connectWindow();
  makeCurrent();
  // The widest lines that OpenGL guarantees; wider ones are drawn as faces.
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->SetReadyForRendering(true);
  window_->SetOwnContext(0);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
  const vtkNew<QVTKInteractor> interactor;
  interactor->SetRenderWindow(window_);
  interactor->Initialize();
  interactor->EnableRenderOff();  // several moves of the mouse in one turn of the event loop are one drawing
  interactor->AddObserver(vtkCommand::RenderEvent, this, &SceneWidget::requestRender);
  smoother_.setMaxThreadCount(1);
  takeSize();
}

SceneWidget::~SceneWidget() {
  makeCurrent();
  window_->GetInteractor()->RemoveAllObservers();
  window_->Finalize();
  window_->RemoveAllObservers();
  context_.extraFunctions()->glDeleteSync(std::exchange(drawing_, nullptr));
  context_.doneCurrent();
}

void SceneWidget::connectWindow() {
  for (const auto event : {vtkCommand::StartEvent, vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                           vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowFrameEvent}) {
    window_->AddObserver(event, this, &SceneWidget::answerWindow);
  }
}

void SceneWidget::answerWindow(vtkObject* /*window*/, unsigned long event, void* answer) {
  switch (event) {
    case vtkCommand::StartEvent:  // whoever draws, draws all that was asked for
      render_soon_.stop();
      // VTK would copy what it has drawn for a screen, and wait for that to be drawn.
      window_->SetSwapBuffers(static_cast<vtkTypeBool>(isMultisampled()));
      break;
    case vtkCommand::WindowMakeCurrentEvent:
      makeCurrent();
      break;
    case vtkCommand::WindowIsCurrentEvent:
      *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == &context_;
      break;
    case vtkCommand::WindowSupportsOpenGLEvent:
      *static_cast<int*>(answer) = 1;
      break;
    default:
      is_newer_drawn_ = true;
      context_.extraFunctions()->glDeleteSync(drawing_);
      drawing_ = context_.extraFunctions()->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
      context_.functions()->glFlush();
      show_soon_.start();
  }
}

void SceneWidget::requestRender() {
  if (!render_soon_.isActive()) render_soon_.start();
}

void SceneWidget::takeSize() {
  constexpr int kDpi = 72;
  const double ratio = devicePixelRatioF();
  const QSize wanted = (ratio * QSizeF(size())).toSize().expandedTo({1, 1});
  const int* has = window_->GetSize();
  const int dpi = qRound(kDpi * ratio);
  if (has[0] == wanted.width() && has[1] == wanted.height() && window_->GetDPI() == dpi) return;
  window_->SetDPI(dpi);
  adapter_.SetDevicePixelRatio(static_cast<float>(ratio), window_->GetInteractor());
  window_->SetSize(wanted.width(), wanted.height());
  window_->GetInteractor()->UpdateSize(wanted.width(), wanted.height());
}

void SceneWidget::setBackground(const QColor& color) {
  background_ = color;
  update();
}

QImage SceneWidget::picture() {
  takeSize();
  readPicture();
  if (picture_.size() != QSize(window_->GetSize()[0], window_->GetSize()[1])) {
    window_->Render();
    readPicture();
  }
  return picture_;
}

void SceneWidget::drawNow() {
  window_->Render();
  readPicture();
}

bool SceneWidget::isMultisampled() const { return window_->GetMultiSamples() > 1; }

bool SceneWidget::isDrawn() {
  return drawing_ == nullptr || !makeCurrent() ||
         context_.extraFunctions()->glClientWaitSync(drawing_, 0, 0) != GL_TIMEOUT_EXPIRED;
}

void SceneWidget::showWhenDrawn() {
  if (!isVisible()) return;  // fetched when it is painted
  if (isDrawn()) {
    readPicture();
    update();
  } else {
    show_soon_.start();
  }
}

void SceneWidget::readPicture() {
  if (!std::exchange(is_newer_drawn_, false) || !makeCurrent()) return;
  vtkOpenGLFramebufferObject* drawn =
      isMultisampled() ? window_->GetDisplayFramebuffer() : window_->GetRenderFramebuffer();
  std::array<int, 2> size{};
  drawn->GetLastSize(size[0], size[1]);
  QImage upside_down(size[0], size[1], QImage::Format_RGB32);
  vtkOpenGLState* state = window_->GetState();
  state->PushReadFramebufferBinding();
  drawn->Bind(GL_READ_FRAMEBUFFER);
  drawn->ActivateReadBuffer(0);
  context_.functions()->glReadPixels(0, 0, size[0], size[1], GL_BGRA, GL_UNSIGNED_BYTE, upside_down.bits());
  state->PopReadFramebufferBinding();
  picture_ = std::move(upside_down).mirrored();
  picture_.setDevicePixelRatio(devicePixelRatioF());
  is_smoothed_ = false;
  ++drawn_;
  const double pixels = 1.0 * size[0] * size[1];
  // The first one tells how long it takes.
  if (smoothing_budget_ms_ > 0 && pixels * smoothing_ms_per_pixel_.value_or(0) <= smoothing_budget_ms_) {
    take(smoothed(roughPicture()));
  }
}

SceneWidget::Rough SceneWidget::roughPicture() {
  Rough rough{picture_, hollows_ ? hollows_() : std::nullopt, {}};
  const QSize size = picture_.size();
  if (!rough.sight || size != QSize(window_->GetSize()[0], window_->GetSize()[1]) || !makeCurrent()) {
    rough.sight.reset();
    return rough;
  }
  rough.depths.assign(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()), 1.0F);
  window_->GetZbufferData(0, 0, size.width() - 1, size.height() - 1, rough.depths.data());
  return rough;
}

SceneWidget::Smoothed SceneWidget::smoothed(const Rough& rough) {
  constexpr double kNanoseconds = 1e-6;  // in milliseconds
  QElapsedTimer timer;
  timer.start();
  QImage picture = rough.picture;
  if (rough.sight) {
    picture = shadeHollows(picture, depthPicture(rough.depths, picture.size(), *rough.sight), rough.sight->full_m);
  }
  picture = smoothEdges(picture);
  const double pixels = 1.0 * picture.width() * picture.height();
  return {std::move(picture), kNanoseconds * static_cast<double>(timer.nsecsElapsed()) / pixels};
}

void SceneWidget::take(Smoothed result) {
  constexpr double kNewest = 0.3;  // one slow picture, of a busy computer, is not all of them
  picture_ = std::move(result.picture);
  is_smoothed_ = true;
  double& kept =
      smoothing_ms_per_pixel_ ? *smoothing_ms_per_pixel_ : smoothing_ms_per_pixel_.emplace(result.ms_per_pixel);
  kept += kNewest * (result.ms_per_pixel - kept);
}

void SceneWidget::smoothPicture() {
  readPicture();
  if (is_smoothed_ || picture_.isNull()) return;
  take(smoothed(roughPicture()));
  update();
}

void SceneWidget::smoothPictureBeside() {
  readPicture();
  if (is_smoothed_ || picture_.isNull()) return;
  smoother_.start([this, rough = roughPicture(), drawn = drawn_] {
    giveWayOnce();
    QMetaObject::invokeMethod(
        this,
        [this, result = smoothed(rough), drawn] {
          if (is_newer_drawn_ || is_smoothed_ || drawn != drawn_) return;
          take(result);
          update();
        },
        Qt::QueuedConnection);
  });
}

bool SceneWidget::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::ScreenChangeInternal) takeSize();
  adapter_.ProcessEvent(event, window_->GetInteractor());
  return QWidget::event(event);
}

void SceneWidget::paintEvent(QPaintEvent* /*event*/) {
  // What is still being drawn is shown when it is: nobody waits for it, least of all the rest of a window.
  if (picture_.isNull() || !show_soon_.isActive()) readPicture();
  QPainter painter(this);
  const QSizeF shown = QSizeF(picture_.size()) / devicePixelRatioF();
  if (shown != size()) painter.fillRect(rect(), background_);
  painter.drawImage(QPointF((width() - shown.width()) / 2, (height() - shown.height()) / 2), picture_);
}

}  // namespace hexoderm
