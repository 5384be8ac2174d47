#pragma once

#include "widgets/scene/label_choice.h"
#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// The cells' IDs, upright to the viewer, on faces that look at the camera and are large enough to be read.
class SceneLabels {
 public:
  explicit SceneLabels(vtkRenderer* renderer);
  ~SceneLabels();

  /// Null shows nothing.
  void setContent(const std::shared_ptr<const SceneContent>& content);
  void setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors);
  void setVisible(bool visible);
  /// IDs of cells that are cut away are not drawn.
  void setCut(const std::optional<SceneCut>& cut);
  /// Before each rendering: which are seen, how large, and where.
  void update(const std::array<int, 2>& window_size, int dpi);

  /// Those drawn last.
  [[nodiscard]] const std::vector<PlacedLabel>& drawn() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
