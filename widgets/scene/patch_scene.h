#pragma once

#include "widgets/coloring/cell_coloring.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_items.h"
#include "widgets/scene/scene_overlays.h"
#include "widgets/style/scene_colors.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkRenderer;
class vtkRenderWindow;

namespace hexoderm {

/// The patch in 3D without Qt: cells, ports, IDs, origin, axes, the direction of gravity, and what is drawn over them
/// (SceneItem), with VTK into whatever render window it is attached to. Nothing is drawn until the window renders.
///
/// Up to SceneContent::kMaxPrismCells cells are prisms; a larger skin is drawn as its front faces only. Making a large
/// skin's content takes longer than a picture does, so it can be made elsewhere and handed over; every other setter is
/// cheap enough to be called for each new result.
class PatchScene {
 public:
  /// Direction from which the camera looks, in the patch frame: Front from +z (out of the origin cell's skin), Side
  /// from +x, Top from +y.
  enum class View { Oblique, Front, Side, Top };

  PatchScene();
  ~PatchScene();
  PatchScene(const PatchScene&) = delete;
  PatchScene& operator=(const PatchScene&) = delete;

  /// Adds the scene's renderers to the window; once. The scene must outlive the window's last rendering.
  void attachTo(vtkRenderWindow* window);

  /// Null empties the scene. The camera moves only when the set of cells has changed.
  void setContent(std::shared_ptr<const SceneContent> content);
  /// The same, making the content here and now.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setColors(const SceneColors& colors);
  void setColoring(CellColoring coloring);
  /// The newest readings; cells without one are neutral. Without the distances to a fitted surface, which are the
  /// scene's own.
  void setReadings(CellReadings readings);
  /// Known placements, drawn as outlines; null: none.
  void setTruth(std::shared_ptr<const GroundTruth> truth);
  /// A surface fitted to a patch of this reconstruction.
  void setSurface(std::optional<SurfaceEvaluation> surface);
  void setLoop(std::optional<LoopEvaluation> loop);
  /// Sets the comparison of this reconstruction with a reference, per patch.
  void setComparison(std::vector<Comparison> comparison);
  void setShown(SceneItem item, bool shown);
  [[nodiscard]] Availability availability(SceneItem item) const;
  /// Notes on the things drawn over the cells, and their enlargements.
  [[nodiscard]] const SceneNotes& notes();
  /// Outlines the cell, or draws a line along the link. One that is not in the reconstruction is not shown.
  void setSelection(std::optional<CellId> cell, std::optional<std::pair<LinkEnd, LinkEnd>> link);
  /// The cells between which is measured: one is outlined, two are joined by a line.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second);
  /// Whose gravity the arrow shows; none: the last pose of the patch.
  void setPose(std::optional<PoseId> pose);
  /// Sets the present up direction, a unit vector in the frame of the largest patch: the picture follows, so that up
  /// stays upwards while the part is turned, and the arrow of gravity with it. None: the picture stays, and the arrow
  /// is a pose's again.
  void setUp(const std::optional<Eigen::Vector3d>& up_o);
  /// Sets the up direction of the next pose: its ghost is shown beside the skin. None: no ghost.
  void setNextUp(const std::optional<Eigen::Vector3d>& up_o);
  /// How far the ghost has turned from the present orientation (0) to the next (1).
  void setGhostPhase(double phase);
  [[nodiscard]] bool showsGhost() const;
  /// The present up, else that of the pose whose gravity is shown; none without either.
  [[nodiscard]] std::optional<Eigen::Vector3d> upShown() const;
  /// The part seems to turn about gravity, counter-clockwise seen from above.
  void spin(double angle_rad);
  /// IDs and the letters of the axes; pictures that are compared go without.
  void setTextVisible(bool visible);

  /// Smooths edges after drawing (FXAA); on by default. It doubles the time of a picture in software OpenGL, where
  /// smoothEdges() does it in less.
  void setSmoothed(bool smoothed);

  /// Pixels of the window's top that something else covers: what is fitted stays below.
  void setTopMargin(int pixels);
  /// Moves the camera along its direction until everything fits into the window.
  void fit();
  void showStandardView(View view);
  /// From where is looked now; returnToKeptView() looks from there again and fits. Without a kept view it does nothing.
  void keepView();
  void returnToKeptView();
  /// Parallel instead of perspective projection; what is looked at keeps its size.
  void setParallel(bool parallel);

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y);
  [[nodiscard]] const SceneContent* content() const;
  [[nodiscard]] const CellReadings& readings() const;
  /// The values that the cells are coloured by, in the unit that is shown; for the legend.
  [[nodiscard]] std::vector<std::optional<double>> values() const;
  /// Whether the arrow is there: not without a pose, nor while it is switched off.
  [[nodiscard]] bool showsGravity() const;

  [[nodiscard]] vtkRenderer* renderer() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
