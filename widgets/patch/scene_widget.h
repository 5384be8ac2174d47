#pragma once

#include "widgets/controls/heavy_turn.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/opengl_info.h"
#include "widgets/scene/edge_smoothing.h"

#include <QVTKInteractor.h>
#include <QVTKInteractorAdapter.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <Eigen/Core>
#include <QColor>
#include <QEvent>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QTimer>
#include <QWidget>
#include <array>
#include <utility>

namespace hexoderm {

/// The trackball without VTK's single-letter commands: keys belong to the window.
class SceneInteractorStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static SceneInteractorStyle* New() { VTK_STANDARD_NEW_BODY(SceneInteractorStyle); }
  vtkTypeMacro(SceneInteractorStyle, vtkInteractorStyleTrackballCamera) void OnChar() override {}
  void OnKeyPress() override {}
};

/// Shows what VTK draws. It draws beside the screen, and its pictures are shown like those of any other widget: with
/// VTK's own widgets Qt would put the whole window together in OpenGL each time that any part of it changes, which
/// without a graphics card takes longer than drawing the scene.
///
/// Draws when it is asked to, when it becomes visible and when its size changes; until then it shows the picture that
/// it has. Needs OpenGL (see queryOpenGl()). Edges are smoothed by a shader; without a graphics card, where that takes
/// longer than the drawing, only in the picture at rest, which is drawn once more for it.
class SceneWidget : public QWidget {
  Q_OBJECT

 public:
  /// `by_processor`: there is no graphics card.
  explicit SceneWidget(bool by_processor, QWidget* parent = nullptr) : QWidget(parent), by_processor_(by_processor) {
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
    window_->SetMultiSamples(0);  // which take the processor several times as long as smoothing
    const vtkNew<QVTKInteractor> interactor;
    interactor->SetRenderWindow(window_);
    interactor->Initialize();
    interactor->SetInteractorStyle(vtkNew<SceneInteractorStyle>());
    interactor->EnableRenderOff();  // several moves of the mouse in one turn of the event loop are one drawing
    interactor->AddObserver(vtkCommand::RenderEvent, this, &SceneWidget::requestRender);
    setUpOnce(at_rest_, kRest_ms, this, [this] {
      smooths_ = true;
      if (isVisible()) render_soon_.start();
    });
    takeSize();
  }
  ~SceneWidget() override {
    makeCurrent();
    window_->GetInteractor()->RemoveAllObservers();
    window_->Finalize();
    window_->RemoveAllObservers();
    context_.extraFunctions()->glDeleteSync(std::exchange(drawing_, nullptr));
    context_.doneCurrent();
  }

  [[nodiscard]] vtkGenericOpenGLRenderWindow* renderWindow() const { return window_.Get(); }
  /// Draws soon, once for however many requests.
  void requestRender() {
    if (by_processor_) {
      smooths_ = false;
      at_rest_.start();
    }
    if (!render_soon_.isActive()) render_soon_.start();
  }
  /// Draws at once, with smooth edges, and waits for it: the next painting shows it.
  void drawNow() {
    at_rest_.stop();
    smooths_ = true;
    window_->Render();
    readPicture();
  }
  /// Whether the edges in the last picture are smooth; false while another one is being drawn.
  [[nodiscard]] bool isPictureSmoothed() const { return is_smoothed_ && !is_newer_drawn_; }
  /// Current while the window draws.
  [[nodiscard]] QOpenGLContext& context() { return context_; }
  bool makeCurrent() { return context_.makeCurrent(&surface_); }

  /// Seen where a picture of another size does not reach.
  void setBackground(const QColor& color) {
    background_ = color;
    update();
  }
  /// The pixel of the window (origin lower left) at a position of the widget.
  [[nodiscard]] Eigen::Vector2d pixelAt(const QPoint& position) const {
    return devicePixelRatioF() * Eigen::Vector2d(position.x(), height() - 1 - position.y());
  }
  /// The last picture; drawn now if there is none or its size has changed.
  [[nodiscard]] QImage picture() {
    takeSize();
    readPicture();
    if (picture_.size() != QSize(window_->GetSize()[0], window_->GetSize()[1])) {
      window_->Render();
      readPicture();
    }
    return picture_;
  }

 protected:
  /// Passes events on to VTK's interactor, but for keys: they belong to the window.
  bool event(QEvent* event) override {
    switch (event->type()) {
      case QEvent::KeyPress:
      case QEvent::KeyRelease:
        event->ignore();  // so that it goes on to the window
        return true;
      case QEvent::Show:  // shows changes made while it was hidden
      case QEvent::Resize:
      case QEvent::ScreenChangeInternal:  // which may be a denser one
        takeSize();
        if (isVisible()) requestRender();
        break;
      default:
        break;
    }
    adapter_.ProcessEvent(event, window_->GetInteractor());
    return QWidget::event(event);
  }
  void paintEvent(QPaintEvent* /*event*/) override {
    // What is still being drawn is shown when it is: nobody waits for it, least of all the rest of a window.
    if (picture_.isNull() || !show_soon_.isActive()) readPicture();
    QPainter painter(this);
    const QSizeF shown = QSizeF(picture_.size()) / devicePixelRatioF();
    if (shown != size()) painter.fillRect(rect(), background_);
    painter.drawImage(QPointF((width() - shown.width()) / 2, (height() - shown.height()) / 2), picture_);
  }

 private:
  /// Not in the very next turn of the event loop: the window may be painted in that, and then whoever has clicked
  /// meanwhile would wait for both.
  static constexpr int kRenderAfter_ms = 10;
  /// Nor is it shown in the turn that has drawn it.
  static constexpr int kShowAfter_ms = 1;
  static constexpr int kRest_ms = 150;

  void connectWindow() {
    for (const auto event :
         {vtkCommand::StartEvent, vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
          vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowFrameEvent}) {
      window_->AddObserver(event, this, &SceneWidget::answerWindow);
    }
  }
  /// Answers the questions that VTK asks its window's owner, by setting `answer`, and handles the end of a drawing.
  void answerWindow(vtkObject* /*window*/, unsigned long event, void* answer) {
    switch (event) {
      case vtkCommand::StartEvent:  // whoever draws, draws all that was asked for
        render_soon_.stop();
        // VTK would copy what it has drawn for a screen, and wait for that to be drawn.
        window_->SwapBuffersOff();
        setSmoothed(*window_, smooths_);
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
        is_smoothed_ = smooths_;
        context_.extraFunctions()->glDeleteSync(drawing_);
        drawing_ = context_.extraFunctions()->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        context_.functions()->glFlush();
        show_soon_.start();
    }
  }
  void takeSize() {
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
  /// Whether all that OpenGL was told to draw is drawn: it does so beside the window's thread.
  [[nodiscard]] bool isDrawn() {
    return drawing_ == nullptr || !makeCurrent() ||
           context_.extraFunctions()->glClientWaitSync(drawing_, 0, 0) != GL_TIMEOUT_EXPIRED;
  }
  void showWhenDrawn() {
    if (!isVisible()) return;  // fetched when it is painted
    if (isDrawn()) {
      readPicture();
      update();
    } else {
      show_soon_.start();
    }
  }
  /// Fetches what was drawn, once for however many drawings. Waits until it is drawn.
  void readPicture() {
    if (!std::exchange(is_newer_drawn_, false) || !makeCurrent()) return;
    vtkOpenGLFramebufferObject* drawn = window_->GetRenderFramebuffer();
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

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  QVTKInteractorAdapter adapter_;
  QImage picture_;
  QColor background_ = Qt::white;
  bool is_newer_drawn_ = false;
  GLsync drawing_ = nullptr;  ///< reached when what was drawn last is complete
  bool by_processor_;
  bool smooths_ = true;       ///< the picture that is drawn next
  bool is_smoothed_ = false;  ///< the one that was drawn last
  HeavyTurn render_soon_{kRenderAfter_ms, [this] { window_->Render(); }};
  HeavyTurn show_soon_{kShowAfter_ms, [this] { showWhenDrawn(); }};
  QTimer at_rest_;
};

}  // namespace hexoderm
