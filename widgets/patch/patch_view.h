#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/scene_items.h"

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

class vtkCamera;

namespace hexoderm {

class ScaleRanges;
class Selection;

/// The patch in 3D: true hexagonal prisms with ports, IDs, origin and gravity, in the colours that are chosen, with
/// overlays and live readings. What is under the mouse and what is picked is outlined and has its figures on a card;
/// the camera turns to what is sought (Selection::sought). It computes nothing itself; without OpenGL it says so in
/// words and stays empty.
///
/// Large skins are prepared on another thread; until that is done, the previous picture stays.
class PatchView : public QWidget {
  Q_OBJECT

 public:
  using StandardView = hexoderm::StandardView;
  /// Larger skins take longer than a few milliseconds to prepare.
  static constexpr std::size_t kMaxCellsAtOnce = 1500;

  /// `selection` must outlive the view.
  explicit PatchView(Selection* selection, QWidget* parent = nullptr);
  ~PatchView() override;

  /// Null shows an empty scene with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// What is going on while there is no skin, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited);
  /// What the colours of the cells mean, as the menu has it.
  void setColoring(Coloring coloring);
  [[nodiscard]] Coloring coloring() const;
  /// Ranges of scales that the operator fixes, here or elsewhere; they must outlive the view. Without them the view has
  /// some of its own.
  void setScaleRanges(ScaleRanges* ranges);
  /// Results and truths about the reconstruction that is shown. They stay until they are set anew.
  void setOverlays(const PatchOverlays& overlays);
  [[nodiscard]] const PatchOverlays& overlays() const;
  /// The enlargement of the differences with another calibration; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor);
  /// As they are drawn; none: nothing is.
  [[nodiscard]] std::optional<double> shiftFactor() const;
  /// Null without OpenGL. Whoever moves it asks for a picture with redraw().
  [[nodiscard]] vtkCamera* camera() const;
  /// Draws soon.
  void redraw();
  /// The present moment of a connected skin and the picked pose. Each call lets the picture follow the part a little
  /// further; may come 20 times a second.
  void setMoment(const PatchMoment& moment);
  [[nodiscard]] const PatchMoment& moment() const;
  /// Points at a value on the scale of the colours, for example that of the cell under the mouse, and says whose it is;
  /// none points at that of the picked cell again.
  void setMarkedValue(std::optional<double> value, const QString& word = {});
  /// On: somebody obeys turnRequested(), so that a button, Shift and the arrow keys turn the part instead of the
  /// picture.
  void setTurnable(bool turnable);
  /// Off: nothing moves by itself.
  void setAnimated(bool animated);
  [[nodiscard]] bool isAnimating() const;
  /// Keeps a card with all figures of what is picked over the picture, and its neighbours to go to; the card follows
  /// what is picked, until Esc.
  void setMetricsShown(bool shown);
  [[nodiscard]] bool areMetricsShown() const;

  /// Everything that was set is in the picture, or will be at its next drawing.
  [[nodiscard]] bool isUpToDate() const;
  /// Calls `then` as soon as everything that was set is in the picture: at once, except while a large skin is being
  /// prepared. Never after the view has gone.
  void whenUpToDate(std::function<void()> then);
  /// Blocks until everything that was set is in the picture. For pictures that are taken without an operator.
  void waitUntilUpToDate();
  /// Draws at once and as smoothly as possible, instead of in the next turns of the event loop.
  void drawNow();
  /// The scene as drawn, without the buttons on top; while a large skin is being prepared, as it was before.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();
  void showStandardView(hexoderm::StandardView view);
  /// Remembers the direction of view while the picture follows the part; afterwards the whole patch is seen from there
  /// again.
  void keepView();
  void returnToKeptView();
  /// Brings the cell into the middle of the picture, without turning.
  void centerOn(hexoderm::CellId cell);
  /// Puts screenshot() on the clipboard.
  void copyPicture();

 signals:
  /// The operator chose a colouring.
  void coloringPicked(hexoderm::Coloring coloring);
  /// "Save picture of the 3D view…" was chosen: the window asks for a path and saves screenshot().
  void pictureRequested();
  /// The part should be turned until this direction of the largest patch's frame points up; at most 20 times a second.
  void turnRequested(Eigen::Vector3d up_o);
  /// The cells are coloured by something else, whoever asked for it.
  void coloringChanged(hexoderm::Coloring coloring);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  /// The menu key; the right button of the mouse opens the menu when it is let go.
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
