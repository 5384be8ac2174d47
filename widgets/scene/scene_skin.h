#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/scene_content.h"
#include "widgets/scene/scene_cut.h"
#include "widgets/style/scene_colors.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// Both shine from the camera's side and turn with it: a soft key light from above its left shoulder, and a weaker one
/// from its right, so that what is turned away from the first is not dark. What faces the camera has its full colour.
struct SceneLights {
  static constexpr std::array<double, 3> kKeyFrom = {-0.45, 0.7, 1.0};  ///< right, up, towards the viewer
  static constexpr double kKey = 0.85;
  static constexpr std::array<double, 3> kFillFrom = {0.6, -0.35, 0.8};
  static constexpr double kFill = 0.42;
};

void addSceneLights(vtkRenderer* renderer);

/// The cells in the scene: prisms or front faces, their colours, ports, origin and signs; and which of them a pixel
/// shows.
class SceneSkin {
 public:
  /// Ports of more cells than these are specks.
  static constexpr std::size_t kMaxMarkedCells = 500;

  explicit SceneSkin(vtkRenderer* renderer);
  ~SceneSkin();

  /// Null shows nothing.
  void setContent(std::shared_ptr<const SceneContent> content);
  void setColoring(Coloring coloring);
  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range);
  void setReadings(CellReadings readings);
  void setSurfaceDistances(std::unordered_map<CellId, double> distance_m);
  void setColors(const SceneColors& colors);
  void setPortsVisible(bool visible);
  /// Cells in front of the plane are cut away; none: nothing is.
  void setCut(const std::optional<SceneCut>& cut);
  /// Colour of every cell's front face, in the order of the layout.
  [[nodiscard]] const std::vector<Rgb>& frontColors() const;
  [[nodiscard]] Coloring coloring() const;
  [[nodiscard]] const CellReadings& readings() const;
  /// Of the scale of the colouring, if that is one of a quantity and cells are shown.
  [[nodiscard]] std::optional<ScaleLegend> scale() const;

  /// Must be called before each rendering: cells are lit for the camera's position, and drawn in the visible detail.
  void update(int window_height);

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
