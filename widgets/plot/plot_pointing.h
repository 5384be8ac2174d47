#pragma once

#include "widgets/plot/plot_data.h"

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

class QKeyEvent;
class QMouseEvent;
class QRubberBand;
class QwtPlot;

namespace hexoderm {

/// Mouse and keyboard on a plot's canvas: what is under the mouse, picking, and brushing.
///
/// A click picks the nearest point; beside all it clears. A rectangle brushes the points in it; with Shift or Ctrl they
/// are added. Left and Right go from point to point along the plot, Up and Down by height, Home and End to the first
/// and the last along; with Shift all on the way are brushed. In a histogram the keys go from bar to bar, and brush
/// what is in it. Ctrl+A brushes everything, Esc nothing.
class PlotPointing : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  PlotPointing(QwtPlot* plot, const PlotData& data, Selection& selection, QObject* parent = nullptr);

  /// Other data is shown.
  void restart();
  /// On the canvas.
  [[nodiscard]] QPointF positionOf(std::size_t point) const;
  /// "7", or "5:2 – 9:3" of a link.
  [[nodiscard]] QString nameOf(std::size_t point) const;
  /// "Cell 7: position uncertainty (95 %) 0.83 mm, …"
  [[nodiscard]] QString describe(std::size_t point) const;

 signals:
  void pointedAt(const std::optional<std::size_t>& point);
  void binReached(const std::optional<std::size_t>& bin);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool onPress(const QMouseEvent& event);
  bool onMove(const QMouseEvent& event);
  bool onRelease(const QMouseEvent& event);
  bool onKey(const QKeyEvent& event);
  void showToolTip(const QPoint& at, const QPoint& global);
  [[nodiscard]] std::optional<std::size_t> nearest(const QPointF& at) const;
  [[nodiscard]] std::optional<std::size_t> binAt(const QPointF& at) const;
  void pick(std::size_t point);
  void brushArea(const QRectF& area, bool adds);
  void brushPoints(const std::vector<std::size_t>& points, bool adds);
  void goThroughPoints(int key, bool extends);
  void goThroughBins(int key, bool extends);
  /// The point that is picked, if it is shown.
  [[nodiscard]] std::optional<std::size_t> pickedPoint() const;

  QwtPlot* plot_;
  const PlotData& data_;
  Selection& selection_;
  QRubberBand* band_;
  std::optional<QPoint> pressed_at_;
  std::optional<std::size_t> anchor_;  ///< place in the order along, or bin, from which Shift extends
  std::optional<std::size_t> bin_;
};

}  // namespace hexoderm
