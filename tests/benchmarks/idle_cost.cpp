// What the window costs while a skin streams and nothing moves, as a share of a core: the real window with a skin of 17
// cells that is held still, which the emulator sends on TCP, so that the simulation is another process; three poses are
// taken first. CPU time is that of the process, thread by thread, as Linux counts it. The command is in README.md.

#include "app/window/main_window/main_window.h"
#include "tests/support/newcomer.h"
#include "tests/support/paths.h"
#include "tests/support/picture_counter.h"
#include "tests/support/qt_wait.h"
#include "widgets/patch/scene_widget.h"

#include <unistd.h>
#include <QAction>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextStream>
#include <map>

namespace hexoderm {
namespace {

QTextStream& out() {
  static QTextStream stream(stdout);
  return stream;
}

/// User and system time of what a "stat" of /proc is about, in seconds, and its name.
std::pair<QString, double> timeIn(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QString line = QString::fromUtf8(file.readAll());
  // The name may hold anything but the last bracket.
  const auto open = line.indexOf(QLatin1Char('('));
  const auto close = line.lastIndexOf(QLatin1Char(')'));
  const QStringList fields = line.mid(close + 2).split(QLatin1Char(' '));
  constexpr int kUser = 11;  // fields 14 and 15 of proc(5)
  constexpr int kSystem = 12;
  const double ticks = fields.value(kUser).toDouble() + fields.value(kSystem).toDouble();
  return {line.mid(open + 1, close - open - 1), ticks / static_cast<double>(sysconf(_SC_CLK_TCK))};
}

std::map<QString, double> timesOfThreads() {
  std::map<QString, double> times;
  const QDir tasks(QStringLiteral("/proc/self/task"));
  for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const auto [name, seconds] = timeIn(tasks.filePath(task + QStringLiteral("/stat")));
    times[name + QLatin1Char(' ') + task] = seconds;
  }
  return times;
}

/// Counts what is painted, by the widget's class and name.
class PaintTally : public QObject {
 public:
  std::map<QString, int> painted;
  int layouts = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) ++layouts;
    if (event->type() == QEvent::Paint) {
      ++painted[QLatin1String(watched->metaObject()->className()) + QLatin1Char(' ') + watched->objectName()];
    }
    return false;
  }
};

/// Lets the device turn itself to three poses, and waits until nothing moves any more.
bool takePoses(MainWindow& window) {
  SessionController& controller = window.controller();
  const auto isIdle = [&] {
    return controller.reconstruction() && !controller.isSolving() && controller.work().activity().isEmpty();
  };
  if (!test::waitUntil([&] { return controller.liveSession().isLive() && isIdle(); })) return false;
  constexpr std::size_t kPoses = 3;
  controller.liveSession().letRobotTake(kPoses);
  if (!test::waitUntil([&] { return !controller.liveSession().isRobotOn() && isIdle(); })) return false;
  constexpr int kGhostTurns_ms = 10000;  // three times, and then it rests
  QTest::qWait(kGhostTurns_ms);
  return controller.session() && controller.session()->poses().size() >= kPoses;
}

void report(const std::map<QString, double>& before, double seconds, const PaintTally& tally, int pictures) {
  double sum = 0;
  for (const auto& [thread, time] : timesOfThreads()) {
    const auto found = before.find(thread);
    const double used = time - (found == before.end() ? 0 : found->second);
    sum += used;
    if (used / seconds >= 0.0005)
      out() << QStringLiteral("  %1 %\t%2\n").arg(100 * used / seconds, 6, 'f', 2).arg(thread);
  }
  out() << QStringLiteral("pictures of the 3D view: %1 a second; layouts: %2 a second; painted, times a second:\n")
               .arg(pictures / seconds, 0, 'f', 2)
               .arg(tally.layouts / seconds, 0, 'f', 2);
  for (const auto& [widget, times] : tally.painted) {
    if (times / seconds >= 0.2) out() << QStringLiteral("  %1\t%2\n").arg(times / seconds, 6, 'f', 2).arg(widget);
  }
  out() << QStringLiteral("the window: %1 % of a core\n").arg(100 * sum / seconds, 0, 'f', 2);
}

int measure(const QString& emulator_program, double seconds, bool shows_stillness, bool is_demo) {
  QProcess emulator;
  MainWindow window;
  window.resize(1440, 900);
  window.show();
  if (!test::waitUntilExposed(window)) return 1;
  if (is_demo) {
    window.startDemo();
  } else {
    emulator.start(emulator_program,
                   {QStringLiteral("--tcp"), QStringLiteral("0"), QStringLiteral("--patch"), QStringLiteral("x17")});
    if (!emulator.waitForReadyRead(test::kPatience_ms)) return 1;
    const QRegularExpression line(QStringLiteral("listening on (\\S+)"));
    ConnectRequest request;
    request.address = line.match(QString::fromUtf8(emulator.readAllStandardOutput())).captured(1);
    window.connectTo(request);
  }
  if (!takePoses(window)) {
    out() << "the poses were not taken\n";
    return 1;
  }
  if (shows_stillness) {
    auto* tabs = window.findChild<QTabBar*>(QStringLiteral("detailTabs"));
    tabs->setCurrentIndex(tabs->count() - 1);
    QTest::qWait(1000);
  }
  const test::PictureCounter pictures(*window.findChild<SceneWidget*>());
  const QString of_emulator = QStringLiteral("/proc/%1/stat").arg(emulator.processId());
  PaintTally tally;
  qApp->installEventFilter(&tally);
  QElapsedTimer clock;
  clock.start();
  const auto before = timesOfThreads();
  const double emulator_before = timeIn(of_emulator).second;
  QTest::qWait(static_cast<int>(1000 * seconds));
  const double passed = static_cast<double>(clock.elapsed()) / 1000;
  report(before, passed, tally, pictures.count());
  if (!is_demo) {
    out() << QStringLiteral("the emulator: %1 % of a core\n")
                 .arg(100 * (timeIn(of_emulator).second - emulator_before) / passed, 0, 'f', 2);
    window.controller().liveSession().disconnectSource();
    emulator.kill();
    emulator.waitForFinished();
  }
  return 0;
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  const hexoderm::Newcomer newcomer;
  const QApplication application(argc, argv);
  hexoderm::applyTextFactor(1);
  QCommandLineParser parser;
  parser.addHelpOption();
  const QCommandLineOption seconds(QStringLiteral("seconds"), QStringLiteral("Measure for so long."),
                                   QStringLiteral("N"), QStringLiteral("30"));
  const QCommandLineOption stillness(QStringLiteral("stillness"), QStringLiteral("With the strip of stillness open."));
  const QCommandLineOption demo(QStringLiteral("demo"),
                                QStringLiteral("The demo skin, whose simulation is in the window's process."));
  parser.addOptions({seconds, stillness, demo});
  parser.process(application);
  return hexoderm::measure(QStringLiteral(HEXODERM_EMULATOR), parser.value(seconds).toDouble(), parser.isSet(stillness),
                           parser.isSet(demo));
}
