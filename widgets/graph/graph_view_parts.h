#pragma once

// Private to graph_view*.cpp: what a GraphView consists of, and how it answers the hand.

#include "widgets/graph/graph_coloring_button.h"
#include "widgets/graph/graph_painter.h"
#include "widgets/graph/graph_picture.h"
#include "widgets/graph/graph_view.h"

#include <QPixmap>
#include <QTimer>

namespace hexoderm {

class FindCellField;
class Selection;

namespace graph_view {

inline constexpr double kFitMargin_px = 12;
inline constexpr int kButtonEdge_px = 8;
/// A skin of one cell need not fill the window.
inline constexpr double kLargestFittedRadius_px = 40;
inline constexpr double kLargestRadius_px = 150;
inline constexpr double kGrasp_px = 7;
inline constexpr double kKeyZoom = 1.25;
/// Where the view is smaller, it is all graph and no button; its menu is still there.
inline constexpr QSize kLeastForButton(220, 150);
inline constexpr double kLeastForSkin_px = 180;  // beside a legend
/// Of the view's height, for the legend.
inline constexpr double kMostForLegend = 0.18;
/// More are drawn in a turn of the event loop of their own.
inline constexpr std::size_t kMostCellsAtOnce = 300;

/// A cell or a link under the mouse.
struct Hit {
  std::optional<std::size_t> cell;
  std::optional<std::size_t> link;
  friend bool operator==(const Hit&, const Hit&) = default;
  [[nodiscard]] bool isNothing() const { return !cell && !link; }
};

}  // namespace graph_view

struct GraphView::Parts {
  Parts(GraphView* owner, Selection* shared);

  GraphView* view;
  Selection* selection;
  std::shared_ptr<const GraphScene> scene = std::make_shared<GraphScene>();
  std::shared_ptr<const GraphPaint> paint = std::make_shared<GraphPaint>();
  GraphCamera camera;
  FindCellField* finder;        ///< a child of the view
  GraphColoringButton* button;  ///< likewise
  QList<QAction*> link_actions;
  QList<QAction*> cell_actions;
  Theme theme = Theme::Light;
  QRectF legend_area;        ///< empty where there is no room for it
  bool follows_size = true;  ///< until somebody zooms or pans
  bool shows_focus = false;  ///< for those who came by keyboard
  graph_view::Hit hovered;
  std::optional<QPoint> pressed_at;
  bool panning = false;
  QPointF last_mouse;
  QPixmap sheet;  ///< all but what is picked, so that picking and pointing cost nothing
  bool sheet_is_current = false;
  QTimer draw_soon;

  void repaintSheet();
  /// Colours anew, after what they depend on has changed.
  void recolor();
  /// Finds room for button and legend.
  void arrange();

  /// As everything is seen at once.
  [[nodiscard]] GraphCamera fitted() const;
  void fitCamera();
  void zoom(double factor, const QPointF& about);
  void pan(const QPointF& by_px);
  void bringIntoView(const QPointF& sheet_point);

  [[nodiscard]] graph_view::Hit hitAt(const QPointF& position) const;
  void pick(const graph_view::Hit& hit);
  [[nodiscard]] graph_view::Hit picked() const;
  void movePicked(const QPointF& direction);
  void onPicked();
  [[nodiscard]] static QPointF middleOf(const GraphScene::Link& link);
  void describe();
  void hover(const graph_view::Hit& hit);
  [[nodiscard]] QString toolTipOf(const graph_view::Hit& hit) const;
  void showMenu(const graph_view::Hit& hit, const QPoint& global_position);

  [[nodiscard]] GraphStyle style() const;
  [[nodiscard]] GraphMarks marks() const;
  [[nodiscard]] GraphPicture picture() const;
  void drawHint(QPainter& painter) const;
  void drawSheet();
  /// Unless a sheet that takes long is drawn soon, for then the one of before is shown until it is there.
  void drawSheetUnlessSoon();
  void drawHighlights(QPainter& painter) const;
  /// What the outlines about these cover.
  [[nodiscard]] QRect regionOf(const graph_view::Hit& hit) const;

 private:
  void placeLegend();
  [[nodiscard]] double captionSpace() const;
  /// What the skin may fill, but for the button.
  [[nodiscard]] QRectF fitRoom() const;
  /// At the top, where it covers no cell and no caption: left, else right, else between; none where there is no such
  /// place.
  [[nodiscard]] std::optional<QPoint> freeForButton(const GraphCamera& fitted) const;
  [[nodiscard]] GraphCamera fittedInto(const QRectF& room) const;
};

}  // namespace hexoderm
