#pragma once

#include "widgets/controls/step_panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLayout>
#include <QPointer>
#include <QScrollArea>
#include <QWidget>
#include <algorithm>
#include <vector>

namespace hexoderm {

/// Scrolls everything around a widget so that it is seen.
inline void bringIntoView(QWidget* widget) {
  // Widgets that have just come or gone have not moved the others yet; inner layouts ask outer ones for room.
  constexpr int kNested = 4;
  for (int k = 0; k < kNested; ++k) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  for (QWidget* outer = widget->parentWidget(); outer; outer = outer->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(outer)) area->ensureWidgetVisible(widget);
  }
}

/// Leads the keyboard through the large parts of the window: from part to part, and through all controls, part by part
/// and within a part in the order of the layout. Order and stops are looked up at every key, as controls come and go
/// with the operator's work. The widget that gets the focus is scrolled into view.
class FocusOrder : public QObject {
 public:
  /// `panes`: the parts in the order in which they are read; none lies in another.
  explicit FocusOrder(const std::vector<QWidget*>& panes) {
    for (QWidget* pane : panes) panes_.push_back({pane, nullptr});
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*old*/, QWidget* now) {
      for (Pane& pane : panes_) {
        if (now && pane.widget && isIn(now, pane.widget)) pane.last = now;
      }
    });
    qApp->installEventFilter(this);
  }

  /// Moves to the next or previous part that has a stop: to the place where it was left, else to its beginning. From
  /// outside all parts it moves to the first one. False if there is no stop.
  bool moveToPane(bool forward) {
    const QWidget* now = QApplication::focusWidget();
    const auto count = static_cast<int>(panes_.size());
    int at = forward ? count - 1 : 0;
    for (int k = 0; now && k < count; ++k) {
      const Pane& pane = panes_[static_cast<std::size_t>(k)];
      if (pane.widget && isIn(now, pane.widget)) at = k;
    }
    for (int k = 0; k < count; ++k) {
      at = (at + (forward ? 1 : count - 1)) % count;
      const Pane& pane = panes_[static_cast<std::size_t>(at)];
      const Widgets stops = stopsOf(pane.widget);
      const auto entrance = std::find_if(stops.begin(), stops.end(), takesFocus);
      if (entrance == stops.end()) continue;
      const bool was_left = pane.last && takesFocus(pane.last) && isIn(pane.last, pane.widget);
      return focus(was_left ? pane.last.data() : *entrance, forward);
    }
    return false;
  }

  /// Moves to the next or previous control; from outside all parts, and from the ends, around.
  bool moveToControl(bool forward) {
    Widgets stops;
    for (const Pane& pane : panes_) {
      const Widgets of_pane = stopsOf(pane.widget);
      stops.insert(stops.end(), of_pane.begin(), of_pane.end());
    }
    if (!forward) std::reverse(stops.begin(), stops.end());
    const auto now = std::find(stops.begin(), stops.end(), QApplication::focusWidget());
    if (now != stops.end()) std::rotate(stops.begin(), now + 1, stops.end());
    const auto next = std::find_if(stops.begin(), stops.end(), takesFocus);
    return next != stops.end() && focus(*next, forward);
  }

  /// Space presses the button that has the focus before it captures a pose.
  bool eventFilter(QObject* watched, QEvent* event) override {
    // The heading of the step that is open has nothing to be pressed for.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
        !watched->property(StepPanel::kIsOpen).toBool() &&
        (qobject_cast<QAbstractButton*>(watched) || qobject_cast<QComboBox*>(watched) ||
         qobject_cast<QAbstractSpinBox*>(watched))) {
      event->accept();
      return true;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  using Widgets = std::vector<QWidget*>;
  static bool isIn(const QWidget* widget, const QWidget* pane) { return widget == pane || pane->isAncestorOf(widget); }
  /// Tab stops there when it can be seen and used.
  static bool isStop(const QWidget* widget) {
    // A widget that stands for another, as the line within a box does, is no stop of its own.
    return (widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy();
  }

  static bool takesFocus(const QWidget* widget) { return isStop(widget) && widget->isVisible() && widget->isEnabled(); }
  static void addOf(const QLayout& layout, Widgets& widgets) {
    for (int k = 0; k < layout.count(); ++k) {
      QLayoutItem* item = layout.itemAt(k);
      if (item->widget()) widgets.push_back(item->widget());
      if (item->layout()) addOf(*item->layout(), widgets);
    }
  }

  /// The children in the order of their layout; those that no layout holds come last.
  static Widgets childrenInOrder(const QWidget& widget) {
    Widgets children;
    if (const auto* dock = qobject_cast<const QDockWidget*>(&widget)) {
      children = {dock->titleBarWidget(), dock->widget()};
    } else if (widget.layout()) {
      addOf(*widget.layout(), children);
    }
    for (QObject* child : widget.children()) {
      auto* other = qobject_cast<QWidget*>(child);
      if (other && std::find(children.begin(), children.end(), other) == children.end()) children.push_back(other);
    }
    return children;
  }

  /// Also those that can't take the focus now: the one that has it may just be disappearing.
  static void addStops(QWidget* widget, Widgets& stops) {
    if (isStop(widget)) stops.push_back(widget);
    for (QWidget* child : childrenInOrder(*widget)) {
      // A part that was taken out of the window has an order of its own.
      if (child && !child->isWindow()) addStops(child, stops);
    }
  }

  static Widgets stopsOf(QWidget* pane) {
    Widgets stops;
    if (pane && !pane->isWindow()) addStops(pane, stops);
    return stops;
  }

  static bool focus(QWidget* widget, bool forward) {
    widget->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    bringIntoView(widget);
    return true;
  }

  struct Pane {
    QPointer<QWidget> widget;
    QPointer<QWidget> last;  ///< the widget of this part that had the focus last
  };
  std::vector<Pane> panes_;
};

}  // namespace hexoderm
