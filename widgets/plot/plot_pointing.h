#pragma once

#include "widgets/plot/plot_data.h"
#include "widgets/plot/plot_picture.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_item.h>
#include <qwt_scale_map.h>
#include <QApplication>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QObject>
#include <QPainter>
#include <QPixmap>
#include <QPointF>
#include <QRubberBand>
#include <QString>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

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
  PlotPointing(QwtPlot* plot, const PlotData& data, PlotPicture::Marks& marks, Selection& selection)
      : plot_(plot), data_(data), marks_(marks), selection_(selection) {
    plot->canvas()->installEventFilter(this);
  }

  /// Other data is shown.
  void restart() {
    anchor_.reset();
    marks_.bin.reset();
    marks_.hovered.reset();
    pressed_at_.reset();
    band_->hide();
  }

  /// On the canvas.
  [[nodiscard]] QPointF positionOf(std::size_t point) const {
    const QwtScaleMap x = plot_->canvasMap(QwtPlot::xBottom);
    const QwtScaleMap y = plot_->canvasMap(QwtPlot::yLeft);
    const PlotPoint& shown = data_.points[point];
    if (!data_.choice.is_histogram) return {x.transform(shown.x), y.transform(shown.y)};
    return {x.transform(shown.x), y.transform(0) - 2};
  }

  /// "7", or "5:2 – 9:3" of a link.
  [[nodiscard]] QString nameOf(std::size_t point) const {
    const PlotPoint& named = data_.points[point];
    return named.link ? shortLinkName(named.link->first, named.link->second) : QString::number(named.cell.value());
  }

  /// "Cell 7: position uncertainty (95 %) 0.83 mm, …"
  [[nodiscard]] QString describe(std::size_t point) const {
    const PlotPoint& shown = data_.points[point];
    const PlotChoice& choice = data_.choice;
    const auto figure = [&](PlotFigure which, double value) {
      return tr("%1: %2").arg(plotFigureName(choice.subject, which), plotValueText(which, value));
    };
    QString text = shown.link ? tr("Link %1").arg(nameOf(point)) : tr("Cell %1").arg(nameOf(point));
    if (choice.x) text += QLatin1Char('\n') + figure(choice.x, shown.x);
    if (!choice.is_histogram && choice.y && choice.y != choice.x) text += QLatin1Char('\n') + figure(choice.y, shown.y);
    return text;
  }

 protected:
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    switch (event->type()) {
      case QEvent::MouseButtonPress:
        return onPress(*static_cast<QMouseEvent*>(event));
      case QEvent::MouseMove:
        return onMove(*static_cast<QMouseEvent*>(event));
      case QEvent::MouseButtonRelease:
        return onRelease(*static_cast<QMouseEvent*>(event));
      case QEvent::KeyPress:
        return onKey(*static_cast<QKeyEvent*>(event));
      case QEvent::ShortcutOverride:
        if (static_cast<QKeyEvent*>(event)->matches(QKeySequence::SelectAll)) event->accept();
        return false;
      case QEvent::Leave:
        mark(marks_.hovered, std::nullopt);
        return false;
      case QEvent::ToolTip: {
        const auto* help = static_cast<QHelpEvent*>(event);
        showToolTip(help->pos(), help->globalPos());
        return true;
      }
      default:
        return false;
    }
  }

 private:
  static constexpr double kNear_px = 10;  // from a point at which the mouse still means it
  static std::vector<std::size_t> allOf(const PlotData& data) {
    std::vector<std::size_t> points(data.points.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    return points;
  }
  /// Indices of the points, ordered along or up the plot; equal ones stay in the order of their IDs.
  static std::vector<std::size_t> ordered(const PlotData& data, bool by_height) {
    std::vector<std::size_t> order = allOf(data);
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return by_height ? data.points[k].y : data.points[k].x; });
    return order;
  }

  /// Where a key leads in a row of `count` things; none: it is no key for that.
  static std::optional<std::size_t> nextPlace(int key, std::optional<std::size_t> place, std::size_t count) {
    const std::size_t last = count - 1;
    switch (key) {
      case Qt::Key_Right:
      case Qt::Key_Up:
        return place ? std::min(*place + 1, last) : 0;
      case Qt::Key_Left:
      case Qt::Key_Down:
        return place ? *place - (*place > 0 ? 1 : 0) : last;
      case Qt::Key_Home:
        return 0;
      case Qt::Key_End:
        return last;
      default:
        return std::nullopt;
    }
  }

  void mark(std::optional<std::size_t>& which, std::optional<std::size_t> place) {
    if (std::exchange(which, place) != place) plot_->replot();
  }

  bool onPress(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    pressed_at_ = event.pos();
    return true;
  }

  bool onMove(const QMouseEvent& event) {
    if (!pressed_at_) {
      mark(marks_.hovered, nearest(event.pos()));
      return false;
    }
    if (!band_->isVisible() && (event.pos() - *pressed_at_).manhattanLength() < QApplication::startDragDistance()) {
      return true;
    }
    mark(marks_.hovered, std::nullopt);
    band_->setGeometry(QRect(*pressed_at_, event.pos()).normalized());
    band_->show();
    return true;
  }

  bool onRelease(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !pressed_at_) return false;
    const QRect area = QRect(*pressed_at_, event.pos()).normalized();
    const bool is_click = (event.pos() - *pressed_at_).manhattanLength() < QApplication::startDragDistance();
    const bool adds = (event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) != 0;
    pressed_at_.reset();
    band_->hide();
    if (!is_click) {
      brushArea(area, adds);
      return true;
    }
    if (const auto point = nearest(event.pos())) {
      if (adds) {
        brushPoints({*point}, true);
      } else {
        anchor_ = point;
        pick(*point);
      }
    } else if (const auto bin = binAt(event.pos())) {
      const double left = plot_->transform(QwtPlot::xBottom, data_.bins[*bin].lower);
      const double right = plot_->transform(QwtPlot::xBottom, data_.bins[*bin].upper);
      anchor_ = bin;
      brushArea(QRectF(left, 0, right - left, 1), adds);
      mark(marks_.bin, bin);
    } else {
      selection_.clear();
    }
    return true;
  }

  bool onKey(const QKeyEvent& event) {
    if (event.matches(QKeySequence::SelectAll)) {
      brushPoints(allOf(data_), false);
      return true;
    }
    if (event.key() == Qt::Key_Escape && (!selection_.brushed().empty() || selection_.cell() || selection_.link())) {
      // First what was marked last, as a rule.
      if (selection_.brushed().empty()) {
        selection_.clear();
      } else {
        selection_.brush({});
      }
      anchor_.reset();
      return true;
    }
    if ((event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0) return false;
    if (data_.points.empty() || !nextPlace(event.key(), std::nullopt, 1)) return false;
    const bool extends = (event.modifiers() & Qt::ShiftModifier) != 0;
    if (data_.choice.is_histogram) {
      goThroughBins(event.key(), extends);
    } else {
      goThroughPoints(event.key(), extends);
    }
    return true;
  }

  void showToolTip(const QPoint& at, const QPoint& global) {
    QString text;
    if (const auto point = nearest(at)) {
      text = describe(*point);
    } else if (const auto bin = binAt(at)) {
      const ValueBin& shown = data_.bins[*bin];
      const QString what =
          data_.choice.subject == PlotSubject::Cells ? tr("%1 cells from %2 to %3") : tr("%1 links from %2 to %3");
      text = what.arg(QString::number(shown.count), plotValueText(data_.choice.x, shown.lower),
                      plotValueText(data_.choice.x, shown.upper));
    }
    if (text.isEmpty()) text = plot_->toolTip();
    if (text.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(global, text, plot_->canvas());
    }
  }

  [[nodiscard]] std::optional<std::size_t> nearest(const QPointF& at) const {
    if (data_.choice.is_histogram) return std::nullopt;
    std::optional<std::size_t> found;
    double least = kNear_px;
    for (std::size_t k = 0; k < data_.points.size(); ++k) {
      const QPointF away = positionOf(k) - at;
      const double distance = std::hypot(away.x(), away.y());
      if (distance >= least) continue;
      least = distance;
      found = k;
    }
    return found;
  }

  [[nodiscard]] std::optional<std::size_t> binAt(const QPointF& at) const {
    if (!data_.choice.is_histogram) return std::nullopt;
    return binOf(data_.bins, plot_->canvasMap(QwtPlot::xBottom).invTransform(at.x()));
  }

  void pick(std::size_t point) {
    const PlotPoint& picked = data_.points[point];
    if (picked.link) {
      selection_.selectLink(picked.link->first, picked.link->second);
    } else {
      selection_.selectCell(picked.cell);
    }
  }

  void brushArea(const QRectF& area, bool adds) {
    std::vector<std::size_t> inside;
    for (std::size_t k = 0; k < data_.points.size(); ++k) {
      const QPointF at = positionOf(k);
      // A bar is brushed by what of its width is in the rectangle.
      const bool is_in =
          data_.choice.is_histogram ? at.x() >= area.left() && at.x() <= area.right() : area.contains(at);
      if (is_in) inside.push_back(k);
    }
    brushPoints(inside, adds);
  }

  void brushPoints(const std::vector<std::size_t>& points, bool adds) {
    std::vector<CellId> cells = adds ? selection_.brushed() : std::vector<CellId>();
    for (const std::size_t point : points) {
      for (const CellId cell : data_.cellsOf(data_.points[point])) cells.push_back(cell);
    }
    selection_.brush(std::move(cells));
  }

  void goThroughPoints(int key, bool extends) {
    const bool by_height = key == Qt::Key_Up || key == Qt::Key_Down;
    const std::vector<std::size_t> order = ordered(data_, by_height);
    const auto placeOf = [&](std::size_t point) {
      return static_cast<std::size_t>(std::ranges::find(order, point) - order.begin());
    };
    const std::optional<std::size_t> picked = data_.pickedIn(selection_);
    const std::optional<std::size_t> place = picked ? std::optional(placeOf(*picked)) : std::nullopt;
    const std::size_t next = *nextPlace(key, place, order.size());
    if (!extends || !anchor_) anchor_ = picked && extends ? *picked : order[next];
    pick(order[next]);
    if (!extends) return;
    const auto [from, to] = std::minmax({placeOf(*anchor_), next});
    brushPoints(
        {order.begin() + static_cast<std::ptrdiff_t>(from), order.begin() + static_cast<std::ptrdiff_t>(to) + 1},
        false);
  }

  void goThroughBins(int key, bool extends) {
    const std::size_t next = *nextPlace(key, marks_.bin, data_.bins.size());
    if (!extends || !anchor_) anchor_ = next;
    const auto [from, to] = std::minmax(*anchor_, next);
    std::vector<std::size_t> inside;
    for (std::size_t k = 0; k < data_.points.size(); ++k) {
      const auto bin = binOf(data_.bins, data_.points[k].x);
      if (bin && *bin >= from && *bin <= to) inside.push_back(k);
    }
    brushPoints(inside, false);
    mark(marks_.bin, next);
  }

  QwtPlot* plot_;
  const PlotData& data_;
  PlotPicture::Marks& marks_;
  Selection& selection_;
  QRubberBand* band_ = new QRubberBand(QRubberBand::Rectangle, plot_->canvas());
  std::optional<QPoint> pressed_at_;
  std::optional<std::size_t> anchor_;  ///< place in the order along, or bin, from which Shift extends
};

}  // namespace hexoderm
