#pragma once

#include <QPointer>
#include <vector>

class QWidget;

namespace hexoderm {

/// The large parts of the window in reading order, for the keyboard: F6 goes from part to part, and Tab through all
/// controls, part by part and within a part in the order of the layout. Order and stops are looked up at every key, as
/// controls come and go with the operator's work. The widget that gets the focus is scrolled into view.
class FocusOrder {
 public:
  /// No part lies in another.
  void add(QWidget* pane) { panes_.push_back({pane, nullptr}); }
  /// Moves to the next or previous part that has a stop: to the place where it was left, else to its beginning. From
  /// outside all parts it moves to the first one. False if there is no stop.
  bool moveToPane(bool forward);
  /// Moves to the next or previous control; from outside all parts, and from the ends, around.
  bool moveToControl(bool forward);
  /// Notes that a widget has got the focus, by any means.
  void noteFocus(QWidget* widget);

 private:
  struct Pane {
    QPointer<QWidget> widget;
    QPointer<QWidget> last;  ///< the widget of this part that had the focus last
  };
  std::vector<Pane> panes_;
};

/// Scrolls everything around a widget so that it is seen.
void bringIntoView(QWidget* widget);

}  // namespace hexoderm
