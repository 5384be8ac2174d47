#pragma once

#include "widgets/controls/heavy_turn.h"
#include "widgets/patch/hollow_shading.h"

#include <QVTKInteractorAdapter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <QColor>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QThreadPool>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Shows what VTK draws. It draws beside the screen, and its pictures are shown like those of any other widget: with
/// VTK's own widgets Qt would put the whole window together in OpenGL each time that any part of it changes, which
/// without a graphics card takes longer than drawing the scene.
///
/// Draws when it is asked to, and not by itself: with another size it shows the picture that it has until then. Needs
/// OpenGL (see queryOpenGl()).
class SceneWidget : public QWidget {
  Q_OBJECT

 public:
  explicit SceneWidget(QWidget* parent = nullptr);
  ~SceneWidget() override;

  [[nodiscard]] vtkGenericOpenGLRenderWindow* renderWindow() const { return window_.Get(); }
  /// Draws soon, once for however many requests.
  void requestRender();
  /// Draws at once and waits for it: the next painting shows it.
  void drawNow();
  /// Smooths the edges in the picture that was drawn last, by the processor (see smoothEdges()): now, or beside
  /// everything else, and shows it as soon as that is done, unless another one has been drawn by then.
  void smoothPicture();
  void smoothPictureBeside();
  /// Each picture is smoothed as soon as it is drawn, also while they follow each other, as long as that takes no more
  /// than `budget_ms`, as measured on those before. Where it takes longer, smoothPicture() at rest measures it anew. 0
  /// (at first): only smoothPicture() smooths.
  void setSmoothingBudget(double budget_ms) { smoothing_budget_ms_ = budget_ms; }
  /// Darkens hollows too where a picture is smoothed (see shadeHollows()). `sight` is asked for each such picture, and
  /// answers nothing where there are none.
  void setHollows(std::function<std::optional<HollowSight>()> sight) { hollows_ = std::move(sight); }
  [[nodiscard]] bool isPictureSmoothed() const { return is_smoothed_; }
  /// Current while the window draws.
  [[nodiscard]] QOpenGLContext& context() { return context_; }
  bool makeCurrent() { return context_.makeCurrent(&surface_); }

  /// Seen where a picture of another size does not reach.
  void setBackground(const QColor& color);
  /// The last picture; drawn now if there is none or its size has changed.
  [[nodiscard]] QImage picture();

 protected:
  /// Passes events on to VTK's interactor.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void connectWindow();
  /// Answers the questions that VTK asks its window's owner, by setting `answer`, and handles the end of a drawing.
  void answerWindow(vtkObject* window, unsigned long event, void* answer);
  void takeSize();
  [[nodiscard]] bool isMultisampled() const;
  /// Whether all that OpenGL was told to draw is drawn: it does so beside the window's thread.
  [[nodiscard]] bool isDrawn();
  void showWhenDrawn();
  /// Fetches what was drawn, once for however many drawings. Waits until it is drawn.
  void readPicture();
  /// The picture that was drawn last, with all that smoothing it takes.
  struct Rough {
    QImage picture;
    std::optional<HollowSight> sight;
    std::vector<float> depths;  ///< with `sight`
  };
  [[nodiscard]] Rough roughPicture();
  /// A picture with darker hollows and smooth edges, and how long that took.
  struct Smoothed {
    QImage picture;
    double ms_per_pixel = 0;
  };
  [[nodiscard]] static Smoothed smoothed(const Rough& rough);
  void take(Smoothed result);

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  QVTKInteractorAdapter adapter_;
  QImage picture_;
  QColor background_ = Qt::white;
  bool is_newer_drawn_ = false;
  GLsync drawing_ = nullptr;  ///< reached when what was drawn last is complete
  bool is_smoothed_ = false;
  std::uint64_t drawn_ = 0;  ///< pictures so far
  std::function<std::optional<HollowSight>()> hollows_;
  double smoothing_budget_ms_ = 0;
  std::optional<double> smoothing_ms_per_pixel_;  ///< as measured
  HeavyTurn render_soon_;
  HeavyTurn show_soon_;
  QThreadPool smoother_;  ///< last: ends before what it gives its pictures to
};

}  // namespace hexoderm
