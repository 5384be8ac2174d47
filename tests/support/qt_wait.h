#pragma once

#include "tests/support/patience.h"

#include <QTest>
#include <QWidget>

namespace hexoderm::test {

inline constexpr int kPatience_ms = static_cast<int>(std::chrono::milliseconds(kPatience).count());

/// Lets the event loop run until it is so; false if it never comes.
template <class Condition>
bool waitUntil(Condition condition) {
  return QTest::qWaitFor(condition, kPatience_ms);
}
inline bool waitUntilExposed(QWidget& window) { return QTest::qWaitForWindowExposed(&window, kPatience_ms); }
inline bool waitUntilActive(QWidget& window) { return QTest::qWaitForWindowActive(&window, kPatience_ms); }

}  // namespace hexoderm::test
