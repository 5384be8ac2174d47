#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <memory>
#include <vector>

class vtkRenderer;

namespace hexoderm {

/// The cells' IDs, upright to the viewer, on faces that look at the camera and are large enough to be read.
class SceneLabels {
 public:
  /// More could not be told apart.
  static constexpr std::size_t kMaxLabelledCells = 200;

  explicit SceneLabels(vtkRenderer* renderer);
  ~SceneLabels();
  SceneLabels(const SceneLabels&) = delete;
  SceneLabels& operator=(const SceneLabels&) = delete;

  /// Null shows nothing.
  void setContent(const std::shared_ptr<const SceneContent>& content);
  void setColors(const std::vector<Rgb>& front_colors, const SceneColors& colors);
  void setVisible(bool visible);
  /// Before each rendering: which are seen, how large, and where.
  void update(const std::array<int, 2>& window_size, int dpi);

 private:
  struct Label;
  vtkRenderer* renderer_;
  std::vector<std::unique_ptr<Label>> labels_;
  double side_m_ = 0;
  bool visible_ = true;
};

}  // namespace hexoderm
