#pragma once

#include "hexoderm/reconstruction/figures/overlays.h"
#include "widgets/scene/patch_overlays.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/scene/scene_items.h"
#include "widgets/style/scene_colors.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// The overlays that were drawn, with their enlargements, for the words beside them. Absent: not drawn.
struct SceneNotes {
  std::vector<CellId> not_placed;  ///< origins of the patches that stand beside the largest
  bool frames = false;             ///< drawn about these
  std::optional<double> ellipsoid_factor;
  std::optional<double> shift_factor;
  std::optional<double> loop_factor;
  std::optional<double> distance_factor;  ///< enlargement of the lines from the fitted surface to the cells
  bool truth = false;
  bool tree = false;
  bool links = false;
};

/// The things that are drawn over the cells: frames about patches that are not placed, links, tree, uncertainty, truth,
/// fitted surface, loop gap, differences, and the line of a measurement. Each kind is made anew only when it is drawn
/// after a change; setters cost nothing.
class SceneOverlays {
 public:
  /// More would be neither told apart nor quick.
  static constexpr std::size_t kMaxCells = 5000;
  static constexpr std::size_t kMaxEllipsoids = 2000;

  explicit SceneOverlays(vtkRenderer* renderer);
  ~SceneOverlays();

  void setContent(std::shared_ptr<const SceneContent> content);
  void setColors(const SceneColors& colors);
  void setShown(SceneItem item, bool shown);
  void setOverlays(const PatchOverlays& overlays);
  /// The enlargement of the differences; none: as far as they can be told apart.
  void setShiftFactor(std::optional<double> factor);
  /// A line between the centres of two cells of a patch, or outlines about cells of two patches or the first alone.
  void setMeasured(std::optional<CellId> first, std::optional<CellId> second);

  /// Availability of the items that are drawn here; the others are always available.
  [[nodiscard]] Availability availability(SceneItem item) const;
  [[nodiscard]] const SceneNotes& notes();
  /// Brings what is drawn up to date; called before each rendering.
  /// True if something is drawn otherwise than before.
  bool update();
  /// Points of all that is drawn but measurements and frames; after update().
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;
  /// What lies in front of the plane is cut away, but for arrows and what is measured, which are seen through
  /// everything.
  void setCut(const std::optional<SceneCut>& cut);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
