#pragma once

#include "app/window/toolkit/focus_order.h"

#include <QObject>
#include <vector>

namespace hexoderm {

class WindowActions;

/// Leads the keyboard from one part of the window to the next.
class Keyboard : public QObject {
  Q_OBJECT

 public:
  /// `panes`: the large parts of the window in the order in which it is read. All outlive this object.
  Keyboard(const std::vector<QWidget*>& panes, const WindowActions& actions);

  /// What Tab and Shift+Tab do, see FocusOrder::moveToControl().
  bool moveToControl(bool forward) { return panes_.moveToControl(forward); }

  /// Space presses the button that has the focus before it captures a pose.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  FocusOrder panes_;
};

}  // namespace hexoderm
