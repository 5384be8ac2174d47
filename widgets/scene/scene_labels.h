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

/// The cells' IDs, upright to the viewer, on faces that look at the camera and are large enough to be read; and the ID
/// of the picked cell on a plate, wherever it is: filled where the cell is seen, and with a dashed edge where it is
/// seen from behind or covered.
class SceneLabels {
 public:
  explicit SceneLabels(vtkRenderer* renderer);
  ~SceneLabels();
  SceneLabels(const SceneLabels&) = delete;
  SceneLabels& operator=(const SceneLabels&) = delete;

  /// Null shows nothing.
  void setContent(const std::shared_ptr<const SceneContent>& content);
  void setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors);
  /// The picked cell's ID is drawn all the same, unless `with_picked` is false.
  void setVisible(bool visible, bool with_picked = true);
  void setPicked(std::optional<CellId> cell);
  /// The index of the picked cell in the layout, if it is there.
  [[nodiscard]] std::optional<std::size_t> picked() const;
  /// IDs of cells that are cut away are not drawn.
  void setCut(const std::optional<SceneCut>& cut);
  /// Before each rendering: which are seen, how large, and where. `is_picked_covered`: something lies before the picked
  /// cell.
  void update(const std::array<int, 2>& window_size, int dpi, bool is_picked_covered = false);

  /// Those drawn last; the picked one, if there is one, is the first.
  [[nodiscard]] std::vector<PlacedLabel> drawn() const;
  /// The picked cell's ID was drawn as that of a cell that is not seen.
  [[nodiscard]] bool isPickedBehind() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
