#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// Both shine from the camera's side and turn with it: one from above its left shoulder, one straight from it.
/// Together they give text, which VTK lights like a surface, its full colour.
struct SceneLights {
  static constexpr std::array<double, 3> kKeyFrom = {-0.3, 0.45, 1.0};  ///< right, up, towards the viewer
  static constexpr double kKey = 0.75;
  static constexpr double kHead = 0.4;
};

/// The cells in the scene: prisms or front faces, their colours, ports, origin and signs; and which of them a pixel
/// shows.
class SceneSkin {
 public:
  /// Ports of more cells than these are specks.
  static constexpr std::size_t kMaxMarkedCells = 500;

  explicit SceneSkin(vtkRenderer* renderer);
  ~SceneSkin();
  SceneSkin(const SceneSkin&) = delete;
  SceneSkin& operator=(const SceneSkin&) = delete;

  /// Null shows nothing.
  void setContent(std::shared_ptr<const SceneContent> content);
  void setColoring(Coloring coloring);
  /// Of the scale of the colouring; none: fitted to what is shown.
  void setFixedRange(const std::optional<ColorRange>& range);
  void setReadings(CellReadings readings);
  void setSurfaceDistances(std::unordered_map<CellId, double> distance_m);
  void setColors(const SceneColors& colors);
  void setPortsVisible(bool visible);
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
