#pragma once

#include "widgets/graph/graph_camera.h"
#include "widgets/graph/graph_scene.h"

#include <QPoint>
#include <QSize>
#include <optional>

namespace hexoderm {

class GraphLegend;

/// The division of a graph view's area when the whole skin is shown in it: the legend lies along the bottom, the
/// colouring button at the top, where it covers no cell if there is such a place, and the skin fills the rest.
class GraphFit {
 public:
  /// Around the skin and the legend.
  static constexpr double kMargin_px = 12;

  /// The parts that share the area with the skin.
  struct Neighbors {
    std::optional<QSize> button;          ///< none where the button is hidden
    const GraphLegend* legend = nullptr;  ///< null: no legend is wanted
    double caption_height_px = 0;         ///< of the line above each patch; 0 where patches have no captions
  };

  GraphFit() = default;
  /// `view`: the size of the view in pixels.
  GraphFit(const GraphScene& scene, QSize view, const Neighbors& neighbors);

  /// Sees everything at once. A small skin is not enlarged to fill the view.
  [[nodiscard]] const GraphCamera& camera() const { return camera_; }
  [[nodiscard]] QPoint buttonPlace() const { return button_place_; }
  /// Empty where there is no room for the legend.
  [[nodiscard]] const QRectF& legendArea() const { return legend_area_; }
  /// The largest useful scale, in pixels per metre.
  [[nodiscard]] double largestScale(const GraphScene& scene) const;

 private:
  GraphCamera camera_;
  QPoint button_place_;
  QRectF legend_area_;
};

}  // namespace hexoderm
