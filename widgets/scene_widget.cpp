#include "widgets/scene_widget.h"

#include "widgets/opengl_info.h"

#include <QVTKInteractor.h>
#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <QEvent>
#include <QOpenGLFunctions>
#include <QPainter>
#include <array>
#include <utility>

namespace hexoderm {
namespace {

/// What VTK asks its window's owner, who answers by setting what the event brings along.
template <class Answer>
class Asked : public vtkCommand {
 public:
  static vtkSmartPointer<Asked> by(Answer answer) { return vtkSmartPointer<Asked>::Take(new Asked(std::move(answer))); }
  void Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* data) override { answer_(data); }

 private:
  explicit Asked(Answer answer) : answer_(std::move(answer)) {}
  Answer answer_;
};

template <class Answer>
void answer(vtkObject* window, vtkCommand::EventIds event, Answer answer) {
  window->AddObserver(event, Asked<Answer>::by(std::move(answer)));
}

}  // namespace

SceneWidget::SceneWidget(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);  // or all that is below would be painted for each picture
  context_.setFormat(sceneSurfaceFormat());
  context_.create();
  surface_.setFormat(context_.format());
  surface_.create();
  connectWindow();
  makeCurrent();
  // As wide as OpenGL promises it; wider lines are drawn as faces.
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->SetReadyForRendering(true);
  window_->SetOwnContext(0);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
  const vtkNew<QVTKInteractor> interactor;
  interactor->SetRenderWindow(window_);
  interactor->Initialize();
  takeSize();
}

SceneWidget::~SceneWidget() {
  makeCurrent();
  window_->Finalize();
  window_->RemoveAllObservers();
  context_.doneCurrent();
}

void SceneWidget::connectWindow() {
  answer(window_, vtkCommand::WindowMakeCurrentEvent, [this](void*) { makeCurrent(); });
  answer(window_, vtkCommand::WindowIsCurrentEvent,
         [this](void* is_current) { *static_cast<bool*>(is_current) = QOpenGLContext::currentContext() == &context_; });
  answer(window_, vtkCommand::WindowSupportsOpenGLEvent, [](void* supports) { *static_cast<int*>(supports) = 1; });
  answer(window_, vtkCommand::WindowFrameEvent, [this](void*) {
    is_newer_drawn_ = true;
    update();
  });
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

void SceneWidget::readPicture() {
  if (!std::exchange(is_newer_drawn_, false) || !makeCurrent()) return;
  vtkOpenGLFramebufferObject* drawn = window_->GetDisplayFramebuffer();
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
}

bool SceneWidget::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::ScreenChangeInternal) takeSize();
  adapter_.ProcessEvent(event, window_->GetInteractor());
  return QWidget::event(event);
}

void SceneWidget::paintEvent(QPaintEvent* /*event*/) {
  readPicture();
  QPainter painter(this);
  const QSizeF shown = QSizeF(picture_.size()) / devicePixelRatioF();
  if (shown != size()) painter.fillRect(rect(), background_);
  painter.drawImage(QPointF((width() - shown.width()) / 2, (height() - shown.height()) / 2), picture_);
}

}  // namespace hexoderm
