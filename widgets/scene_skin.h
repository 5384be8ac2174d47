#pragma once

#include "widgets/cell_coloring.h"
#include "widgets/scene_colors.h"
#include "widgets/scene_content.h"

#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// The cells in the scene: prisms or front faces, their colours, ports and origin; and which of them a pixel shows.
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
  void setColoring(CellColoring coloring);
  void setReadings(CellReadings readings);
  void setSurfaceDistances(std::unordered_map<CellId, double> distance_m);
  void setColors(const SceneColors& colors);
  void setPortsVisible(bool visible);
  /// Of every cell's front face, in the order of the layout.
  [[nodiscard]] const std::vector<Rgb>& frontColors() const;
  [[nodiscard]] CellColoring coloring() const;
  [[nodiscard]] const CellReadings& readings() const;

  /// The cell at a pixel of the window (origin lower left); none beside the skin.
  [[nodiscard]] std::optional<CellId> pick(double x, double y) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
