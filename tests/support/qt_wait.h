#pragma once

#include "tests/support/patience.h"

#include <QtTest>
#include <QtWidgets>
#include <stdexcept>

namespace hexoderm::test {

inline constexpr int kPatience_ms = static_cast<int>(std::chrono::milliseconds(kPatience).count());

/// Lets the event loop run until it is so; false if it never comes.
template <class Condition>
bool waitUntil(Condition condition) {
  return QTest::qWaitFor(condition, kPatience_ms);
}
inline bool waitUntilExposed(QWidget& window) { return QTest::qWaitForWindowExposed(&window, kPatience_ms); }
inline bool waitUntilActive(QWidget& window) { return QTest::qWaitForWindowActive(&window, kPatience_ms); }

/// Lets the event loop turn until what was posted, or put off to a coming turn, has been done: for a look at what must
/// not have happened. Turns are counted, not time: each ends with a timer of its own, timers end in the order in which
/// they are due however busy the computer is, and the program puts nothing that it draws off for longer than half of
/// these turns (10 ms).
inline void letTurnsPass() {
  constexpr int kTurns = 20;
  constexpr int kTurn_ms = 1;
  for (int turn = 0; turn < kTurns; ++turn) {
    QEventLoop loop;
    QTimer::singleShot(kTurn_ms, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
  }
}

/// A part of a widget by its kind and, of several, its name; throws, which ends the test, if it is not there.
template <class T>
T* part(const QObject& owner, const QString& name = {}) {
  T* found = owner.findChild<T*>(name);
  if (found == nullptr) throw std::runtime_error("there is no " + name.toStdString() + " of the kind");
  return found;
}

/// The mouse moves there with these buttons down. QTest::mouseMove() moves the display's own pointer instead, of which
/// the display tells when it finds the time: perhaps after a button has been released.
inline void moveMouse(QWidget* widget, const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton,
                      Qt::KeyboardModifiers keys = {}) {
  QMouseEvent move(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, buttons, keys);
  QApplication::sendEvent(widget, &move);
}
/// Turns the wheel there; whether somebody took it.
inline bool turnWheel(QWidget* widget, const QPoint& at, int delta) {
  QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(widget, &event);
  return event.isAccepted();
}
inline void dragMouse(QWidget* widget, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {},
                      Qt::MouseButton button = Qt::LeftButton, int steps = 2) {
  QTest::mousePress(widget, button, keys, from);
  for (int k = 1; k <= steps; ++k) moveMouse(widget, from + (to - from) * k / steps, button, keys);
  QTest::mouseRelease(widget, button, keys, to);
}

}  // namespace hexoderm::test
