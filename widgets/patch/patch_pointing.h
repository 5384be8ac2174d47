#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/patch/found_places.h"
#include "widgets/patch/patch_marks.h"
#include "widgets/scene/camera_glide.h"
#include "widgets/scene/scene_pointing.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

class QKeyEvent;
class QShortcut;

namespace hexoderm {

class FigureCard;
class PatchScene;
class Selection;

/// Pointing in the 3D view: what is under the mouse is outlined, with its figures on a card; what is picked is outlined
/// and, if that is wanted, has a card with its figures and neighbours; arrow keys walk from neighbour to neighbour; and
/// the camera goes to what is sought. The scene is drawn anew only where the camera moves.
class PatchPointing : public QObject {
  Q_OBJECT

 public:
  /// `canvas` lies inside `view` and fills it; `render` asks for a picture soon. All but `canvas` must outlive this.
  PatchPointing(QWidget* view, QWidget* canvas, PatchScene& scene, Selection* selection, std::function<void()> render);
  ~PatchPointing() override;

  /// Off: the camera jumps.
  void setAnimated(bool animated) { animated_ = animated; }
  /// What the cells' colours stand for: its value stands on the cards.
  void setColoring(Coloring coloring);
  /// Only cells can be pointed at, as while distances between them are measured.
  void setOnlyCells(bool only);
  /// Kept free for the buttons.
  void setTopMargin(int pixels);
  /// The cell that an instruction speaks of.
  void setTold(std::optional<CellId> cell);
  /// Must be called when another skin, other figures or other readings are shown.
  void refresh();

  /// Picks what is at a position of the canvas, or nothing.
  void pickAt(const QPoint& position);
  /// The cell at a position of the canvas.
  [[nodiscard]] std::optional<CellId> cellAt(const QPoint& position) const;
  /// Moves the camera to what is picked.
  void goToPicked();
  /// Shows the figures of what is picked, whatever that is, until it is closed.
  void setFiguresShown(bool shown);
  [[nodiscard]] bool areFiguresShown() const { return figures_shown_; }
  /// There is no view to return to any more: somebody has asked for another one.
  void forgetReturn();
  /// Walks to a neighbour by an arrow key, or shows the figures by Return.
  [[nodiscard]] bool onKey(const QKeyEvent& event);

  [[nodiscard]] bool isGliding() const { return frames_.isActive(); }
  /// What stays in a picture of the view.
  void paintMarks(QPainter& painter) const { marks_->paintLasting(painter); }
  /// The outlines right above the canvas, the cards above everything else in the view.
  void raise();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Figures;

  void afterRender();
  void look();
  void hover(const SceneHit& hit);
  void placeHoverCard();
  void updateMarks();
  void updateFigures();
  void placeFigures();
  [[nodiscard]] CameraStand besideFigures(const CameraStand& stand) const;
  void glideTo(const CameraStand& stand);
  void nextGlideFrame();
  void stopGlide();
  void goBack();
  void walk(const Eigen::Vector2d& direction);
  [[nodiscard]] SceneHit picked() const;
  /// The pixel of the scene at a position of the canvas.
  [[nodiscard]] Eigen::Vector2d inScene(const QPoint& position) const;
  [[nodiscard]] SceneHit hitAtPosition(const QPoint& position);
  [[nodiscard]] Figures figuresOf(const SceneHit& hit) const;
  [[nodiscard]] SceneMark markOf(const SceneHit& hit) const;
  [[nodiscard]] std::vector<SceneMark> foundMarks() const;
  [[nodiscard]] QPointF toView(const Eigen::Vector2d& pixel) const;

  QWidget* view_;
  QWidget* canvas_;
  PatchScene& scene_;
  Selection* selection_;
  std::function<void()> render_;
  PatchMarks* marks_;
  FigureCard* hover_card_;
  FigureCard* figure_card_;
  QShortcut* escape_;
  unsigned long observer_ = 0;

  Coloring coloring_ = Coloring::LinkQuality;
  bool only_cells_ = false;
  bool figures_shown_ = false;
  bool figures_left_ = false;  ///< where their card is
  int top_margin_ = 0;
  std::optional<CellId> told_;
  std::vector<FoundPlace> found_;  ///< in the result that is shown

  std::optional<QPoint> mouse_;  ///< over the canvas, no button pressed
  SceneHit hovered_;
  QTimer look_soon_;

  bool animated_ = true;
  std::optional<CameraGlide> glide_;
  std::optional<CameraStand> return_to_;
  QTimer frames_;
  QElapsedTimer since_start_;
};

}  // namespace hexoderm
