#pragma once

#include "widgets/graph/graph_legend.h"
#include "widgets/graph/graph_scene.h"

#include <QPoint>
#include <QSize>
#include <algorithm>
#include <optional>

namespace hexoderm {

/// The division of a graph view's area when the whole skin is shown in it: the legend lies along the bottom, the
/// colouring button at the top, where it covers no cell if there is such a place, and the skin fills the rest.
struct GraphFit {
  /// Around the skin and the legend.
  static constexpr double kMargin_px = 12;

  /// The parts that share the area with the skin.
  struct Neighbors {
    std::optional<QSize> button;          ///< none where the button is hidden
    const GraphLegend* legend = nullptr;  ///< null: no legend is wanted
    double caption_height_px = 0;         ///< of the line above each patch; 0 where patches have no captions
  };

  GraphCamera camera;  ///< sees everything at once; a small skin is not enlarged to fill the view
  QPoint button_place;
  QRectF legend_area;  ///< empty where there is no room for the legend

  GraphFit() = default;
  /// `view`: the size of the view in pixels.
  GraphFit(const GraphScene& scene, QSize view, const Neighbors& neighbors)
      : button_place(kButtonEdge_px, kButtonEdge_px), legend_area(placeLegend(neighbors.legend, view)) {
    QRectF room(QPointF(0, 0), QSizeF(view));
    room.adjust(kMargin_px, kMargin_px + neighbors.caption_height_px, -kMargin_px, -kMargin_px);
    if (!legend_area.isEmpty()) room.setBottom(legend_area.top() - 0.5 * kMargin_px);
    camera = fittedInto(room, scene, view);
    if (!neighbors.button) return;
    if (const auto place = freePlaceFor(*neighbors.button, scene, neighbors.caption_height_px)) {
      button_place = *place;
      return;
    }
    // Beside many a skin there is room for the button; where there is not, the skin goes below it.
    constexpr double kBelowButton_px = 4;
    room.setTop(QRect(button_place, *neighbors.button).bottom() + kBelowButton_px + neighbors.caption_height_px);
    camera = fittedInto(room, scene, view);
  }

  /// The largest useful scale, in pixels per metre.
  [[nodiscard]] double largestScale(const GraphScene& scene) const {
    return std::max(camera.scale, kLargestRadius_px / scene.radius_m());
  }

 private:
  static constexpr int kButtonEdge_px = 8;
  /// A skin of one cell need not fill the window.
  static constexpr double kLargestFittedRadius_px = 40;
  static constexpr double kLargestRadius_px = 150;
  static constexpr double kMinForSkin_px = 180;  ///< height beside a legend
  static constexpr double kMaxForLegend = 0.18;  ///< share of the view's height
  /// Empty where there is no room for a legend.
  static QRectF placeLegend(const GraphLegend* legend, QSize view) {
    if (legend == nullptr) return {};
    const double width = view.width() - 2 * GraphFit::kMargin_px;
    const double height = legend->heightFor(width);
    if (height <= 0 || height > kMaxForLegend * view.height() || view.height() - height < kMinForSkin_px) return {};
    return {GraphFit::kMargin_px, view.height() - height - 0.5 * GraphFit::kMargin_px, width, height};
  }

  /// The camera of a view of this size that shows the whole skin within `room`.
  static GraphCamera fittedInto(const QRectF& room, const GraphScene& scene, QSize view) {
    GraphCamera fitted;
    fitted.size = view;
    const QRectF& bounds = scene.bounds();
    if (!bounds.isEmpty()) {
      fitted.scale =
          std::min({std::max(1.0, room.width()) / bounds.width(), std::max(1.0, room.height()) / bounds.height(),
                    kLargestFittedRadius_px / scene.radius_m()});
    }
    const QPointF off = room.center() - QPointF(0.5 * fitted.size.width(), 0.5 * fitted.size.height());
    fitted.center = bounds.center() + QPointF(-off.x(), off.y()) / fitted.scale;
    return fitted;
  }

  /// Where the caption of a patch with these bounds may stand; its text can be wider than a small patch.
  static QRectF captionArea(const QRectF& patch, double height_px) {
    constexpr double kWidest = 12;  // of its heights
    return {patch.left(), patch.top() - height_px, std::max(patch.width(), kWidest * height_px), height_px};
  }

  /// A place at the top where the button covers no cell and no caption: on the left, else on the right, else in the
  /// middle.
  [[nodiscard]] std::optional<QPoint> freePlaceFor(QSize button, const GraphScene& scene,
                                                   double caption_height_px) const {
    const double reach = 1.3 * scene.radius_m() * camera.scale;
    const int view_width = static_cast<int>(camera.size.width());
    const int right = view_width - button.width() - kButtonEdge_px;
    for (const int x : {kButtonEdge_px, right, (view_width - button.width()) / 2}) {
      const QPoint place(x, kButtonEdge_px);
      const QRectF covered(place, button);
      const QRectF near = covered.adjusted(-reach, -reach, reach, reach);
      const bool covers_a_cell = std::ranges::any_of(
          scene.cells(), [&](const GraphScene::Cell& cell) { return near.contains(camera.toScreen(cell.center)); });
      const bool covers_a_caption =
          caption_height_px > 0 && std::ranges::any_of(scene.patches(), [&](const GraphScene::Patch& patch) {
            return covered.intersects(captionArea(camera.toScreen(patch.bounds), caption_height_px));
          });
      if (!covers_a_cell && !covers_a_caption) return place;
    }
    return std::nullopt;
  }
};

}  // namespace hexoderm
