// Does to the real window what a child at the keyboard would: seeded random clicks, drags, wheels, keys, actions,
// resizes, dialogs opened and closed; on a skin of 1,260 cells and on the demo. Fails if the window takes no events for
// longer than a limit, or of course if it crashes.
//   monkey [--minutes M] [--seed N] [--limit-ms L] [--discount-load]

#include "app/window/main_window/main_window.h"
#include "hexoderm/session/session_store.h"
#include "tests/monkey/watchdog.h"
#include "tests/support/newcomer.h"
#include "tests/support/simulated_skins.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDesktopServices>
#include <QDialog>
#include <QDir>
#include <QDrag>
#include <QFileDialog>
#include <QPointer>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <utility>

namespace {

using namespace hexoderm;

/// Nothing outside of this process is started.
class SwallowUrls : public QObject {
  Q_OBJECT
 public slots:
  void take(const QUrl& /*url*/) {}
};

class Monkey : public QObject {
 public:
  Monkey(MainWindow& window, test::Watchdog& watchdog, QString large_session, std::uint64_t seed)
      : window_(window), watchdog_(watchdog), large_session_(std::move(large_session)), random_(seed) {
    actSoon();
  }

  [[nodiscard]] std::uint64_t acts() const { return acts_; }
  [[nodiscard]] const std::map<QString, int>& counts() const { return counts_; }

 private:
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }

  /// Each time by a timer of its own: one whose slot runs an event loop would not fire in it.
  void actSoon() {
    constexpr int kPause_ms = 12;
    QTimer::singleShot(kPause_ms, this, &Monkey::act);
  }

  void act() {
    actSoon();
    if (acting_) {
      // QTest lets events through in the middle of a key; only what lasts waits for an answer in a loop of its own.
      constexpr int kPatience = 20;
      if (++waited_ == kPatience) closeWhatWaits();
      // Things that do not close like this are clicked.
      if (waited_ < 2 * kPatience) return;
    }
    waited_ = 0;
    const bool is_nested = std::exchange(acting_, true);
    ++acts_;
    if (!closeFileDialogs()) any();
    acting_ = is_nested;
  }

  void closeWhatWaits() {
    QWidget* popup = QApplication::activePopupWidget();
    QPointer<QWidget> modal = QApplication::activeModalWidget();
    if (popup) popup->close();
    if (modal) modal->close();
    // A drag of text lasts until it is dropped or given up, also while a menu or a dialog is open.
    QDrag::cancel();
  }

  /// In file dialogs the monkey chooses no file: it would write anywhere.
  bool closeFileDialogs() {
    for (QWidget* top : QApplication::topLevelWidgets()) {
      auto* dialog = qobject_cast<QFileDialog*>(top);
      if (!dialog || !dialog->isVisible()) continue;
      begin(QStringLiteral("cancel a file dialog"));
      dialog->reject();
      return true;
    }
    return false;
  }

  void any() {
    struct Deed {
      int weight;
      void (Monkey::*act)();
    };
    static const std::vector<Deed> kDeeds = {{30, &Monkey::click},   {8, &Monkey::drag},      {10, &Monkey::wheel},
                                             {22, &Monkey::key},     {20, &Monkey::trigger},  {3, &Monkey::resize},
                                             {4, &Monkey::closeTop}, {1, &Monkey::openLarge}, {2, &Monkey::type}};
    int total = 0;
    for (const Deed& deed : kDeeds) total += deed.weight;
    int at = below(total);
    for (const Deed& deed : kDeeds) {
      at -= deed.weight;
      if (at < 0) {
        (this->*deed.act)();
        return;
      }
    }
  }

  void begin(const QString& what) {
    watchdog_.setDoing(what);
    ++counts_[what.section(QLatin1Char(' '), 0, 0)];
  }

  /// The window or a dialog of it; what is in front is likelier.
  QWidget* someTop() {
    if (auto* popup = QApplication::activePopupWidget(); popup && chance(0.8)) return popup;
    std::vector<QWidget*> tops;
    for (QWidget* top : QApplication::topLevelWidgets()) {
      if (top->isVisible() && top->windowHandle() && (top->isWindow())) tops.push_back(top);
    }
    if (auto* active = QApplication::activeWindow(); active && chance(0.5)) return active;
    if (tops.empty()) return &window_;
    std::sort(tops.begin(), tops.end(), [](QWidget* a, QWidget* b) { return a->winId() < b->winId(); });
    return tops[static_cast<std::size_t>(below(static_cast<int>(tops.size())))];
  }
  QPoint somewhere(const QWidget& widget) {
    return {below(std::max(1, widget.width())), below(std::max(1, widget.height()))};
  }
  static QString nameOf(QWidget* top, const QPoint& at) {
    const QWidget* child = top->childAt(at);
    const QWidget* named = child ? child : top;
    while (named && named->objectName().isEmpty()) named = named->parentWidget();
    return QStringLiteral("%1 in %2")
        .arg(child ? child->metaObject()->className() : top->metaObject()->className(),
             named ? named->objectName() : QString());
  }
  Qt::KeyboardModifiers someModifiers() {
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    if (chance(0.2)) modifiers |= Qt::ControlModifier;
    if (chance(0.15)) modifiers |= Qt::ShiftModifier;
    return modifiers;
  }

  void click() {
    QWidget* top = someTop();
    if (!top->windowHandle()) return;
    const QPoint at = somewhere(*top);
    const Qt::MouseButton button = chance(0.9) ? Qt::LeftButton : Qt::RightButton;
    begin(QStringLiteral("click on %1").arg(nameOf(top, at)));
    QPointer<QWindow> handle(top->windowHandle());
    // The clicked widget may be gone before the button comes up, so every event checks that there is still a window.
    for (int k = chance(0.1) ? 2 : 1; k > 0; --k) {
      if (handle) QTest::mousePress(handle, button, Qt::NoModifier, at);
      if (handle) QTest::mouseRelease(handle, button, Qt::NoModifier, at);
    }
  }
  void drag() {
    QWidget* top = someTop();
    QPointer<QWindow> handle(top->windowHandle());
    if (!handle) return;
    QPoint at = somewhere(*top);
    begin(QStringLiteral("drag from %1").arg(nameOf(top, at)));
    QTest::mousePress(handle, Qt::LeftButton, Qt::NoModifier, at);
    const QPoint step(below(41) - 20, below(41) - 20);
    for (int k = 0; k < 6 && handle; ++k) QTest::mouseMove(handle, at += step);
    if (handle) QTest::mouseRelease(handle, Qt::LeftButton, Qt::NoModifier, at);
  }
  void wheel() {
    QWidget* top = someTop();
    const QPoint at = somewhere(*top);
    QWidget* target = top->childAt(at) ? top->childAt(at) : top;
    begin(QStringLiteral("wheel on %1").arg(nameOf(top, at)));
    const QPoint delta(0, chance(0.5) ? 120 : -120);
    QWheelEvent event(target->mapFrom(top, at), top->mapToGlobal(at), {}, delta, Qt::NoButton,
                      chance(0.2) ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(target, &event);
  }
  void key() {
    static const std::vector<int> kKeys = {
        Qt::Key_Tab,  Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Space,  Qt::Key_Up,       Qt::Key_Down,
        Qt::Key_Left, Qt::Key_Right,   Qt::Key_Home,   Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Delete,
        Qt::Key_F1,   Qt::Key_A,       Qt::Key_F,      Qt::Key_G,      Qt::Key_H,      Qt::Key_R,        Qt::Key_T,
        Qt::Key_Z,    Qt::Key_Y,       Qt::Key_1,      Qt::Key_2,      Qt::Key_3,      Qt::Key_4,        Qt::Key_5,
        Qt::Key_6,    Qt::Key_7,       Qt::Key_Comma,  Qt::Key_E,      Qt::Key_K,      Qt::Key_S,        Qt::Key_O};
    const int code = kKeys[static_cast<std::size_t>(below(static_cast<int>(kKeys.size())))];
    const Qt::KeyboardModifiers modifiers = someModifiers();
    QWidget* top = QApplication::activePopupWidget();
    if (!top) top = QApplication::activeWindow() ? QApplication::activeWindow() : &window_;
    begin(QStringLiteral("key %1 with focus on %2")
              .arg(QKeySequence(code | static_cast<int>(modifiers)).toString(),
                   QApplication::focusWidget() ? QApplication::focusWidget()->objectName() : QString()));
    QPointer<QWindow> handle(top->windowHandle());
    // QTest::keyRelease() would release Ctrl after the key, in a window that may have gone with it.
    QString text;
    if (!(modifiers & (Qt::ControlModifier | Qt::AltModifier))) {
      if (const char letter = QTest::keyToAscii(static_cast<Qt::Key>(code))) text = QLatin1Char(letter);
    }
    for (const bool pressed : {true, false}) {
      if (handle) QTest::simulateEvent(handle, pressed, code, modifiers, text, false);
    }
  }
  void type() {
    const QPointer<QWidget> focus = QApplication::focusWidget();
    if (!focus) return;
    begin(QStringLiteral("type into %1 %2").arg(focus->metaObject()->className(), focus->objectName()));
    for (const QChar digit : QString::number(below(2000))) {
      if (focus) QTest::keyPress(focus, digit.toLatin1());
      if (focus) QTest::keyRelease(focus, digit.toLatin1());
    }
  }
  void trigger() {
    const QList<QAction*> actions = window_.QWidget::actions();
    QAction* action = actions[below(actions.size())];
    if (!action->isEnabled()) return;
    begin(QStringLiteral("action %1").arg(action->objectName()));
    action->trigger();
  }
  void resize() {
    const QSize size(900 + below(900), 560 + below(500));
    begin(QStringLiteral("resize to %1x%2").arg(size.width()).arg(size.height()));
    window_.resize(size);
  }
  void closeTop() {
    QWidget* top = someTop();
    if (top == &window_) return;
    begin(QStringLiteral("close %1").arg(top->objectName()));
    top->close();
  }
  void openLarge() {
    begin(QStringLiteral("open 1,260 cells"));
    window_.openFile(large_session_);
  }

  MainWindow& window_;
  test::Watchdog& watchdog_;
  QString large_session_;
  std::mt19937_64 random_;
  bool acting_ = false;
  int waited_ = 0;  ///< turns for which something waited for an answer
  std::uint64_t acts_ = 0;
  std::map<QString, int> counts_;
};

void report(const Monkey& monkey, const test::Watchdog& watchdog, const std::vector<test::Stall>& counted) {
  std::cout << monkey.acts() << " acts, " << watchdog.beats() << " beats, longest stall " << watchdog.worst().wall_ms
            << " ms: " << watchdog.worst().doing.toStdString() << '\n';
  for (const auto& [what, count] : monkey.counts()) std::cout << "  " << what.toStdString() << ": " << count << '\n';
  for (const test::Stall& stall : counted) {
    std::cout << "  stall of " << stall.wall_ms << " ms (without a processor for " << stall.queue_ms
              << "): " << stall.doing.toStdString() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Newcomer newcomer;
  QApplication application(argc, argv);
  QApplication::setQuitOnLastWindowClosed(false);
  QCommandLineParser parser;
  const QCommandLineOption minutes(QStringLiteral("minutes"), QString(), QStringLiteral("M"), QStringLiteral("20"));
  const QCommandLineOption seed(QStringLiteral("seed"), QString(), QStringLiteral("N"), QStringLiteral("1"));
  const QCommandLineOption limit(QStringLiteral("limit-ms"), QString(), QStringLiteral("L"), QStringLiteral("100"));
  const QCommandLineOption discount_load(QStringLiteral("discount-load"));
  parser.addOptions({minutes, seed, limit, discount_load});
  parser.process(application);

  QSettings().setValue(QStringLiteral("paths/last"), newcomer.folder());
  QDir::setCurrent(newcomer.folder());
  SwallowUrls swallow;
  QDesktopServices::setUrlHandler(QStringLiteral("file"), &swallow, "take");
  applyTextFactor(1);
  const QString large = newcomer.folder() + QStringLiteral("/large.hexo");
  writeSessionStore(test::simulatedSession(test::bentSheet(30, 42), 3, 20), large.toStdString());
  const double limit_ms = parser.value(limit).toDouble();
  bool failed = false;
  {
    MainWindow window;
    window.actions().quit->setEnabled(false);
    window.show();
    window.openFile(large);
    // The first result is made once, at the start, and is not judged.
    if (!QTest::qWaitFor([&] { return window.controller().reconstruction() != nullptr; }, 60000)) {
      std::cerr << "monkey: the session was not opened\n";
      return EXIT_FAILURE;
    }
    // Nor are its first pictures; nothing says when the last of them is drawn.
    QTest::qWait(1000);
    test::Watchdog watchdog(limit_ms);
    const Monkey monkey(window, watchdog, large, parser.value(seed).toULongLong());
    QTimer::singleShot(static_cast<int>(60000 * parser.value(minutes).toDouble()), &application, [] {
      // Out of a menu's loop too.
      for (QWidget* top : QApplication::topLevelWidgets()) {
        if (qobject_cast<QDialog*>(top) || top == QApplication::activePopupWidget()) top->close();
      }
      QCoreApplication::quit();
    });
    QApplication::exec();
    std::vector<test::Stall> counted = watchdog.stalls();
    if (parser.isSet(discount_load)) {
      std::erase_if(counted, [&](const test::Stall& stall) { return stall.wall_ms - stall.queue_ms <= limit_ms; });
    }
    report(monkey, watchdog, counted);
    failed = !counted.empty() || monkey.acts() == 0;
  }
  std::cout << (failed ? "failed: the window stalled for more than " : "passed: no stall of more than ") << limit_ms
            << " ms\n";
  return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

#include "monkey.moc"
