#pragma once

#include <QObject>

class QCoreApplication;

namespace hexoderm {

/// Whoever scrolls a panel or a dialog must not change the number or the choice that happens to lie below the mouse: as
/// long as there is one of these, the wheel turns a field, a list to choose from or a slider only where that has the
/// keyboard's focus, and does not bring the focus there. Elsewhere it scrolls what is around.
class WheelGuard : public QObject {
 public:
  /// Watches all widgets of the application, those that come later too.
  explicit WheelGuard(QCoreApplication& application);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hexoderm
