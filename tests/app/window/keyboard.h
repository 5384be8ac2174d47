#pragma once

#include "tests/app/window/window_test.h"

namespace hexoderm {

/// The window with nobody at the mouse: everything a test does here is a key, sent to where keys go.
class KeyboardTest : public WindowTest {
 protected:
  /// Sends a key to the popup, dialog or window that has the keyboard, like the window system.
  static void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyPress(static_cast<QWidget*>(nullptr), Qt::Key(code), modifiers);
    // The key may have closed what it was pressed in.
    if (QGuiApplication::focusWindow()) QTest::keyRelease(static_cast<QWidget*>(nullptr), Qt::Key(code), modifiers);
  }
  static void keys(const QString& text) {
    for (const QChar& letter : text) QTest::keyClick(static_cast<QWidget*>(nullptr), letter.toLatin1());
  }
  static QString focusName() { return nameOf(QApplication::focusWidget()); }
  static QString nameOf(const QWidget* widget) {
    if (!widget) return "nothing";
    return QStringLiteral("%1 \"%2\" %3")
        .arg(widget->metaObject()->className(), widget->objectName(), widget->accessibleName());
  }

  /// It, or what covers it and is a part of it.
  static bool isSeen(const QWidget* widget) {
    if (!widget->visibleRegion().isEmpty()) return true;
    const QList<QWidget*> parts = widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    return std::any_of(parts.begin(), parts.end(),
                       [](const QWidget* part) { return !part->isWindow() && isSeen(part); });
  }
  /// The widget with the focus is on the screen, not hidden or scrolled away.
  static void expectFocusIsSeen() {
    const QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    EXPECT_TRUE(isSeen(focus)) << nameOf(focus).toStdString() << " has the focus and is not seen";
  }

  /// Tab until a widget of this name has the focus.
  void tabTo(const QString& name, int code = Qt::Key_Tab) {
    tabUntil([&](const QWidget* focus) { return focus->objectName() == name; }, name, code);
  }
  /// Tab until the button with these words has the focus, and presses it.
  void pressButton(const QString& words) {
    ASSERT_NO_FATAL_FAILURE(tabUntil(
        [&](const QWidget* focus) {
          const auto* button = qobject_cast<const QAbstractButton*>(focus);
          return button && button->text() == words;
        },
        words));
    key(Qt::Key_Space);
  }

  /// Everything at which Tab stops, once round.
  std::vector<QWidget*> tabStops() {
    std::vector<QWidget*> stops;
    constexpr int kMax = 200;
    for (int k = 0; k < kMax; ++k) {
      key(Qt::Key_Tab);
      QWidget* focus = QApplication::focusWidget();
      expectFocusIsSeen();
      if (!stops.empty() && focus == stops.front()) return stops;
      stops.push_back(focus);
    }
    ADD_FAILURE() << "Tab does not come round";
    return stops;
  }

  /// After a dialog has closed: the window has the keyboard again, where it was.
  void comeBack() {
    ASSERT_TRUE(waitUntil([] { return QApplication::activeModalWidget() == nullptr; }));
    ASSERT_NO_FATAL_FAILURE(activateWindow());
    const QWidget* focus = window_->focusWidget();
    EXPECT_TRUE(waitUntil([&] { return focus == nullptr || QApplication::focusWidget() == focus; }))
        << "the keyboard is at " << focusName().toStdString();
  }

 private:
  template <class IsIt>
  void tabUntil(IsIt is_it, const QString& what, int code = Qt::Key_Tab) {
    constexpr int kMax = 120;
    QStringList passed;
    for (int k = 0; k < kMax; ++k) {
      key(code, code == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
      ASSERT_NO_FATAL_FAILURE(expectFocusIsSeen());
      const QWidget* focus = QApplication::focusWidget();
      if (is_it(focus)) return;
      const auto* button = qobject_cast<const QAbstractButton*>(focus);
      passed << focusName() + (button ? ' ' + button->text() : QString());
    }
    FAIL() << "Tab does not lead to " << what.toStdString() << "; it passes\n" << passed.join('\n').toStdString();
  }
};

}  // namespace hexoderm
