#include "app/window/files/session_paths.h"
#include "app/window/main_window/main_window.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/translation.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/freed_memory.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/parallel.h"
#include "widgets/words/words.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QTextStream>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace {

using namespace hexoderm;

// Exit codes as hexoderm-cli has them.
constexpr int kUsage = 2;
constexpr int kBadInput = 3;
constexpr int kNoDisplay = 4;
constexpr int kDevice = 4;
constexpr int kStorage = 5;

struct Main {
  Q_DECLARE_TR_FUNCTIONS(main)
};

int complain(const QString& message, int code) {
  QTextStream(stderr) << "hexoderm: " << message << '\n';
  return code;
}

/// The help is in the language, too, so it is looked for before the arguments are parsed.
QString languageFromArguments(const QStringList& arguments) {
  const int at = arguments.indexOf(QStringLiteral("--language"));
  if (at >= 0 && at + 1 < arguments.size()) return arguments[at + 1];
  const QString prefix = QStringLiteral("--language=");
  for (const QString& argument : arguments) {
    if (argument.startsWith(prefix)) return argument.mid(prefix.size());
  }
  return Preferences().language();
}

/// Whether an option is given, for options that are needed before there is an application that could parse them.
bool isAsked(int argc, char** argv, const char* option) {
  return std::any_of(argv + 1, argv + argc,
                     [option](const char* argument) { return std::strcmp(argument, option) == 0; });
}

/// Lets the demo's robot take its poses, then takes the picture, as the command line asks. The robot is asked once:
/// when it stops, there are so many poses, or it could not take more.
class Script : public QObject {
 public:
  Script(MainWindow& window, int poses, const QString& picture) : window_(window), poses_(poses), picture_(picture) {
    connect(&window_.controller(), &SessionController::changed, this, &Script::step, Qt::QueuedConnection);
    connect(&window_.controller(), &SessionController::failed, this, [this](const QString& message) {
      if (!picture_.isEmpty()) QCoreApplication::exit(complain(message, kBadInput));
    });
  }

 private:
  void step() {
    SessionController& controller = window_.controller();
    if (done_ || !controller.reconstruction() || controller.isSolving() || !controller.work().activity().isEmpty())
      return;
    if (!controller.isCurrent()) return;
    if (controller.liveSession().isDemo() && poses_ > 0 && !is_robot_asked_) {
      is_robot_asked_ = true;
      controller.liveSession().letRobotTake(static_cast<std::size_t>(poses_));
    }
    if (controller.liveSession().isRobotOn()) return;
    done_ = true;
    controller.liveSession().setAutomatic(false);
    if (picture_.isEmpty()) return;
    // The views draw what they have just been given when the events before this one are through.
    QTimer::singleShot(0, this, [this] { QCoreApplication::exit(finish()); });
  }

  /// Returns the exit code.
  int finish() {
    if (!window_.picture().save(picture_, "PNG")) {
      return complain(Main::tr("The picture %1 could not be written.").arg(picture_), kStorage);
    }
    const Session* session = window_.controller().session();
    const int taken = session == nullptr ? 0 : static_cast<int>(session->poses().size());
    if (taken >= poses_) return 0;
    return complain(Main::tr("The robot took %1 of %2 poses, and stopped.").arg(taken).arg(poses_), kDevice);
  }

  MainWindow& window_;
  int poses_;
  QString picture_;
  bool is_robot_asked_ = false;
  bool done_ = false;
};

/// What the program takes on its command line, in the language of the application that there is.
struct Arguments {
  QCommandLineParser parser;
  QCommandLineOption help = parser.addHelpOption();
  QCommandLineOption version = parser.addVersionOption();
  QCommandLineOption demo = add("demo", Main::tr("Start the demo skin."));
  QCommandLineOption poses = add("poses", Main::tr("Let the demo take N poses at once."), "N", "0");
  QCommandLineOption theme = add("theme", Main::tr("light, dark or system, for this time."), "THEME");
  QCommandLineOption language = add("language", Main::tr("en, de or system, for this time."), "LANGUAGE");
  QCommandLineOption screenshot =
      add("screenshot", Main::tr("Save a picture of the window after the first result, and quit."), "FILE");
  QCommandLineOption software_opengl =
      add("software-opengl", Main::tr("Draw in 3D without the graphics card, for this time."));

  Arguments() {
    parser.setApplicationDescription(Main::tr("Finds out where every cell of a robot's artificial skin is."));
    parser.addPositionalArgument(QStringLiteral("FILE"), Main::tr("A session or calibration to open."),
                                 QStringLiteral("[FILE]"));
  }

 private:
  QCommandLineOption add(const char* name, const QString& what, const char* value = "", const char* at_first = "") {
    QCommandLineOption option(QLatin1String(name), what, QLatin1String(value), QLatin1String(at_first));
    parser.addOption(option);
    return option;
  }
};

/// The line for a user without a display, in his language, as long as the application is not there yet.
QByteArray& noDisplayLine() {
  static QByteArray line;
  return line;
}

/// What can be answered without a display: help and version. Also prepares noDisplayLine().
std::optional<int> answerWithoutDisplay(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  installTranslations(app, languageFromArguments(QCoreApplication::arguments()));
  noDisplayLine() = Main::tr(
                        "The window needs a display, and none can be reached: set DISPLAY, or "
                        "use hexoderm-cli.")
                        .toLocal8Bit();
  Arguments arguments;
  // Options of Qt's own are not known yet; a mistake is told by the application that knows them.
  static_cast<void>(arguments.parser.parse(QCoreApplication::arguments()));
  QTextStream out(stdout);
  if (arguments.parser.isSet(arguments.version)) {
    out << QCoreApplication::applicationName() << ' ' << QCoreApplication::applicationVersion() << '\n';
    return 0;
  }
  if (!arguments.parser.isSet(arguments.help) && !isAsked(argc, argv, "--help-all")) return std::nullopt;
  out << arguments.parser.helpText();
  return 0;
}

/// Qt aborts where there is no display, after some lines of its own. This ends the program in order, with one line.
std::unique_ptr<QApplication> connectToDisplay(int& argc, char** argv) {
  const auto take = [](QtMsgType type, const QMessageLogContext& /*context*/, const QString& /*text*/) {
    if (type != QtFatalMsg) return;
    std::fprintf(stderr, "hexoderm: %s\n", noDisplayLine().constData());
    std::_Exit(kNoDisplay);
  };
  const QtMessageHandler before = qInstallMessageHandler(take);
  auto app = std::make_unique<QApplication>(argc, argv);
  qInstallMessageHandler(before);
  return app;
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  const CoresInUse thread_of_the_window(1);  // it never waits for what is solved
  QCoreApplication::setOrganizationName(QStringLiteral("Hexoderm"));
  QCoreApplication::setApplicationName(QStringLiteral("hexoderm"));
  QCoreApplication::setApplicationVersion(QStringLiteral(HEXODERM_VERSION));
  if (const std::optional<int> answered = answerWithoutDisplay(argc, argv)) return *answered;

  installStyle();
  prepareSoftwareOpenGl(isAsked(argc, argv, "--software-opengl"));
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  // As in Qt 6: dense screens are followed, by their exact scale.
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
#endif
  const std::unique_ptr<QApplication> app = connectToDisplay(argc, argv);
  // The name by which a desktop finds the icon of a window under Wayland, where a window brings none.
  QGuiApplication::setDesktopFileName(QStringLiteral("hexoderm"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/hexoderm/icons/hexoderm.svg")));
  installTranslations(*app, languageFromArguments(QCoreApplication::arguments()));

  Arguments arguments;
  QCommandLineParser& parser = arguments.parser;
  parser.process(*app);

  const QStringList files = parser.positionalArguments();
  bool is_number = false;
  const int pose_count = parser.value(arguments.poses).toInt(&is_number);
  const std::optional<ThemeChoice> choice = themeChoiceFromName(parser.value(arguments.theme));
  const bool is_demo = parser.isSet(arguments.demo);
  const std::pair<bool, QString> mistakes[] = {
      {files.size() > 1, Main::tr("One file at a time; see --help.")},
      {is_demo && !files.isEmpty(), Main::tr("Give either --demo or a file, not both.")},
      {!is_number || pose_count < 0 || pose_count > 1000, Main::tr("--poses takes a number from 0 to 1000.")},
      {pose_count > 0 && !is_demo, Main::tr("--poses goes with --demo.")},
      {parser.isSet(arguments.theme) && !choice, Main::tr("--theme takes light, dark or system.")},
      {parser.isSet(arguments.language) && !isLanguageChoice(parser.value(arguments.language)),
       Main::tr("--language takes en, de or system.")},
      {parser.isSet(arguments.screenshot) && !is_demo && files.isEmpty(),
       Main::tr("--screenshot needs a file or --demo to show.")}};
  for (const auto& [is_made, text] : mistakes) {
    if (is_made) return complain(text, kUsage);
  }

  const QString file = files.value(0);
  const QString picture = parser.value(arguments.screenshot);
  try {
    const KeptFile input(toPath(file));
    requireReplaceable(toPath(picture), ("--screenshot " + picture).toStdString());
  } catch (const InvalidArgument& error) {
    return complain(words(error), kUsage);
  } catch (const StorageError& error) {
    return complain(words(error), kStorage);
  }

  applyTextFactor(Preferences().textFactor());
  MainWindow window;
  if (choice) window.setThemeChoice(*choice, false);
  window.show();
  const Script script(window, pose_count, picture);
  if (is_demo) window.startDemo();
  if (!file.isEmpty()) window.openFile(file);
  return QApplication::exec();
}
