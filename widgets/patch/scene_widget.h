#pragma once

#include "widgets/controls/heavy_turn.h"

#include <QVTKInteractorAdapter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QTimer>
#include <QWidget>

namespace hexoderm {

/// Shows what VTK draws. It draws beside the screen, and its pictures are shown like those of any other widget: with
/// VTK's own widgets Qt would put the whole window together in OpenGL each time that any part of it changes, which
/// without a graphics card takes longer than drawing the scene.
///
/// Draws when it is asked to, when it becomes visible and when its size changes; until then it shows the picture that it
/// has. Needs OpenGL (see queryOpenGl()). Edges are smoothed by a shader; without a graphics card, where that takes longer than
/// the drawing, only in the picture at rest, which is drawn once more for it.
class SceneWidget : public QWidget {
  Q_OBJECT

 public:
  /// `by_processor`: there is no graphics card.
  explicit SceneWidget(bool by_processor, QWidget* parent = nullptr);
  ~SceneWidget() override;

  [[nodiscard]] vtkGenericOpenGLRenderWindow* renderWindow() const { return window_.Get(); }
  /// Draws soon, once for however many requests.
  void requestRender();
  /// Draws at once, with smooth edges, and waits for it: the next painting shows it.
  void drawNow();
  /// Whether the edges in the last picture are smooth; false while another one is being drawn.
  [[nodiscard]] bool isPictureSmoothed() const { return is_smoothed_ && !is_newer_drawn_; }
  /// Current while the window draws.
  [[nodiscard]] QOpenGLContext& context() { return context_; }
  bool makeCurrent() { return context_.makeCurrent(&surface_); }

  /// Seen where a picture of another size does not reach.
  void setBackground(const QColor& color);
  /// The pixel of the window (origin lower left) at a position of the widget.
  [[nodiscard]] Eigen::Vector2d pixelAt(const QPoint& position) const {
    return devicePixelRatioF() * Eigen::Vector2d(position.x(), height() - 1 - position.y());
  }
  /// The last picture; drawn now if there is none or its size has changed.
  [[nodiscard]] QImage picture();

 protected:
  /// Passes events on to VTK's interactor, but for keys: they belong to the window.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void connectWindow();
  /// Answers the questions that VTK asks its window's owner, by setting `answer`, and handles the end of a drawing.
  void answerWindow(vtkObject* window, unsigned long event, void* answer);
  void takeSize();
  /// Whether all that OpenGL was told to draw is drawn: it does so beside the window's thread.
  [[nodiscard]] bool isDrawn();
  void showWhenDrawn();
  /// Fetches what was drawn, once for however many drawings. Waits until it is drawn.
  void readPicture();

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
  HeavyTurn render_soon_;
  HeavyTurn show_soon_;
  QTimer at_rest_;
};

}  // namespace hexoderm
