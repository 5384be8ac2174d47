#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/patch_overlays.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_items.h"
#include "widgets/style/scene_colors.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkRenderer;
class vtkRenderWindow;

namespace hexoderm {

/// The patch in 3D without Qt: cells, ports, IDs, origin, axes, the direction of gravity, and overlays (SceneItem). VTK
/// draws it into the render window that it is attached to, and only when that window renders.
///
/// A skin of up to SceneContent::kMaxPrismCells cells is drawn as prisms, a larger one as its front faces only. Making
/// a large skin's content takes longer than drawing it, so it can be made on another thread and handed over; every
/// other setter is cheap enough to be called for each new result.
class PatchScene {
 public:
  using View = SceneCamera::View;

  PatchScene();
  ~PatchScene();

  /// Adds the scene's renderers to the window; once. The scene must outlive the window's last rendering.
  void attachTo(vtkRenderWindow* window);

  /// Null empties the scene. The camera moves only when the set of cells has changed.
  void setContent(std::shared_ptr<const SceneContent> content);
  /// Makes the content here and now, and shows it.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setColors(const SceneColors& colors);
  void setColoring(Coloring coloring);
  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range);
  /// Draws anew only the overlays that are other ones than before.
  void setOverlays(const PatchOverlays& overlays);
  [[nodiscard]] const PatchOverlays& overlays() const;
  /// The enlargement of the differences with another calibration; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor);
  /// Draws anew only what has changed since the moment before. Cells without a reading are neutral.
  void setMoment(const PatchMoment& moment);
  [[nodiscard]] const PatchMoment& moment() const;
  void setShown(SceneItem item, bool shown);
  [[nodiscard]] Availability availability(SceneItem item) const;
  /// Notes on the overlays that are drawn over the cells, with their enlargements.
  [[nodiscard]] const SceneNotes& notes();
  /// The arrow of gravity is that in the frame of this cell's patch; none, or a cell of another skin: of the largest
  /// patch. What is picked is marked over the picture, so that the scene need not be drawn anew for it.
  void setPicked(std::optional<CellId> cell);
  /// Marks these cells with a ring on their faces, those of them that the reconstruction has.
  void setBrushed(std::vector<CellId> cells);
  /// The cells between which is measured: one is outlined, two are joined by a line.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second);
  /// Turns the ghost from the present orientation (0) to the next (1).
  void setGhostPhase(double phase);
  [[nodiscard]] bool showsGhost() const;
  /// The present up, else that of the pose whose gravity is shown; none without either.
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const;
  /// Makes the part seem to turn about gravity, counter-clockwise seen from above.
  void spin(double angle_rad);
  /// IDs and the letters of the axes; pictures that are compared go without.
  void setTextVisible(bool visible);

  /// Smooths edges after drawing (FXAA); on by default. It doubles the time of a picture in software OpenGL, where
  /// smoothEdges() does it in less.
  void setSmoothed(bool smoothed);

  /// Pixels of the window's top that something else covers: what is fitted stays below.
  void setTopMargin(int pixels);
  /// The same at the bottom.
  void setBottomMargin(int pixels);
  /// Moves the camera along its direction until everything that is drawn fits into the window.
  void fit();
  void showStandardView(View view);
  /// Brings a cell into the middle of the picture without turning or zooming, if it is there.
  void centerOn(CellId cell);
  /// The view that a knob of the axes stands for, at a pixel of the window (origin lower left); where it is seen from
  /// there already, the opposite one. None beside the knobs.
  [[nodiscard]] std::optional<View> viewAt(double x, double y) const;
  /// Lights the knob at this pixel; true if that changes the picture.
  bool hoverAxes(double x, double y);
  /// Remembers the present direction; returnToKeptView() looks from there again and fits. Without a kept view it does
  /// nothing.
  void keepView();
  void returnToKeptView();
  /// Parallel instead of perspective projection; the point that is looked at keeps its size.
  void setParallel(bool parallel);

  /// Carries out a fit that was asked for, as the next rendering would.
  void fitIfDue();
  /// Cuts the scene open by a plane that faces the viewer as he looks now: `share` of the skin's depth in that
  /// direction is taken away, 0 to 1. The plane then stays where it is, so that one can look at the cut from elsewhere;
  /// another share moves it along. None: the skin is whole again.
  void setCut(std::optional<double> share);
  /// Makes the plane face the viewer as he looks now.
  void alignCut();
  [[nodiscard]] const std::optional<SceneCut>& cut() const;

  /// What the depths mean that the last picture left in the window.
  struct Depths {
    double near_m = 0;
    double far_m = 1;
    bool parallel = false;
    /// Left, bottom, right and top of the small pictures over the scene, in pixels: what lies there is not the scene's.
    std::vector<std::array<int, 4>> elsewhere;
  };
  [[nodiscard]] Depths depths() const;

  /// The cells whose IDs the last picture has.
  [[nodiscard]] std::vector<CellId> labelledCells() const;

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y);
  [[nodiscard]] const SceneContent* content() const;
  [[nodiscard]] const CellReadings& readings() const;
  /// The values that the cells are coloured by, in the unit that is shown; for the legend.
  [[nodiscard]] std::vector<std::optional<double>> values() const;
  /// The scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const;
  /// True if the arrow of gravity is there: not without a pose, nor while it is switched off.
  [[nodiscard]] bool showsGravity() const;

  [[nodiscard]] vtkRenderer* renderer() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
