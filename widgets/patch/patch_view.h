#pragma once

#include "hexoderm/device/sample_frame.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/coloring/cell_coloring.h"
#include "widgets/scene/scene_items.h"
#include "widgets/style/palette.h"

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hexoderm {

class Selection;

/// The patch in 3D: true hexagonal prisms with ports, IDs, origin and gravity, coloured by what is chosen, and what is
/// known beside them: readings, truth, a fitted surface, a loop's gap, differences to another calibration. Shows what
/// it is given and nothing else; without OpenGL it says so in words and stays empty.
///
/// Large skins are prepared on another thread; until that is done, the picture before stays.
class PatchView : public QWidget {
  Q_OBJECT

 public:
  enum class StandardView { Front, Side, Top };
  /// Larger skins take longer than a few milliseconds to prepare.
  static constexpr std::size_t kMaxCellsAtOnce = 1500;

  /// `selection` must outlive the view.
  explicit PatchView(Selection* selection, QWidget* parent = nullptr);
  ~PatchView() override;

  /// Null shows an empty scene with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setTheme(Theme theme);
  /// Which pose's gravity the arrow shows; the last one by default.
  void setPose(std::optional<PoseId> pose);
  /// Sets the cells' present readings (or those of a picked pose), for the colours; empty: none. May come many times a
  /// second.
  void setReadings(const std::vector<CellSample>& samples, const std::vector<CellTemperature>& temperatures = {});
  /// Known placements, of simulated skins; null: none.
  void setTruth(std::shared_ptr<const GroundTruth> truth);
  // Results about the reconstruction that is shown. They stay until they are set anew: whoever shows another
  // reconstruction has to bring them up to date or take them back.
  void setSurface(std::optional<SurfaceEvaluation> surface);
  void setLoop(std::optional<LoopEvaluation> loop);
  void setComparison(std::vector<Comparison> comparison);

  /// Sets the present up direction, a unit vector in the frame of the largest patch: the picture turns as the part is
  /// turned. None: it stays. Cheap: may be called 20 times a second.
  void setCurrentUp(const std::optional<Eigen::Vector3d>& up_o);
  /// Sets the up direction of the next pose, shown by a ghost beside the skin that turns there. None: no ghost.
  void setNextUp(const std::optional<Eigen::Vector3d>& up_o);
  /// How far the part is to be turned there, in words ("90°"), to stand beside the ghost; empty: it says nothing.
  void setNextTurn(const QString& angle);
  /// Whether turnRequested() is obeyed: then a button, Shift and the arrow keys turn the part instead of the picture.
  void setTurnable(bool turnable);
  /// Off: nothing moves by itself.
  void setAnimated(bool animated);
  [[nodiscard]] bool isAnimating() const;

  /// Everything that was set is in the picture, or will be at its next drawing.
  [[nodiscard]] bool isUpToDate() const;
  /// Calls `then` as soon as everything that was set is in the picture: at once, except while a large skin is being
  /// prepared. Never after the view has gone.
  void whenUpToDate(std::function<void()> then);
  /// Waits until it is, as long as preparing takes. For pictures that nobody watches being taken.
  void waitUntilUpToDate();
  /// Draws what was set, as smooth as it gets, instead of in the next turns of the event loop.
  void drawNow();
  /// The scene as drawn, without the buttons on top; while a large skin is being prepared, as it was before.
  [[nodiscard]] QImage screenshot();

 public slots:
  void fit();
  void showStandardView(hexoderm::PatchView::StandardView view);
  /// For the time in which the picture follows the part: afterwards it is seen again, all of it, from where it was seen
  /// before.
  void keepView();
  void returnToKeptView();

 signals:
  /// "Save picture of the 3D view…" was chosen: the window asks for a path and saves screenshot().
  void pictureRequested();
  /// The part should be turned until this direction of the largest patch's frame points up; at most 20 times a second.
  void turnRequested(Eigen::Vector3d up_o);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
