#include "app/window/main_window/main_window.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/translation.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QTextStream>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstring>

namespace {

using namespace hexoderm;

// Exit codes as hexoderm-cli has them.
constexpr int kUsage = 2;
constexpr int kBadInput = 3;
constexpr int kStorage = 5;

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

/// Lets the demo's robot take its poses, then takes the picture, as the command line asks.
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
    if (controller.liveSession().isDemo() && static_cast<int>(controller.session()->poses().size()) < poses_) {
      if (!controller.poseGuide().isRobotOn()) controller.poseGuide().setRobot(true);
      return;
    }
    done_ = true;
    controller.poseGuide().setRobot(false);
    controller.liveSession().setAutomatic(false);
    if (picture_.isEmpty()) return;
    // The views draw what they have just been given when the events before this one are through.
    QTimer::singleShot(0, this, [this] {
      QCoreApplication::exit(
          window_.picture().save(picture_, "PNG")
              ? 0
              : complain(QCoreApplication::translate("main", "The picture %1 could not be written.").arg(picture_),
                         kStorage));
    });
  }

  MainWindow& window_;
  int poses_;
  QString picture_;
  bool done_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  installStyle();
  QCoreApplication::setOrganizationName(QStringLiteral("Hexoderm"));
  QCoreApplication::setApplicationName(QStringLiteral("hexoderm"));
  prepareSoftwareOpenGl(isAsked(argc, argv, "--software-opengl"));
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  // As in Qt 6: dense screens are followed, by their exact scale.
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
#endif
  QApplication app(argc, argv);
  QCoreApplication::setApplicationVersion(QStringLiteral(HEXODERM_VERSION));

  installTranslations(app, languageFromArguments(app.arguments()));

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::translate("main", "Finds out where every cell of a robot's artificial skin is."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("FILE"),
                               QCoreApplication::translate("main", "A session or calibration to open."),
                               QStringLiteral("[FILE]"));
  const QCommandLineOption demo(QStringLiteral("demo"), QCoreApplication::translate("main", "Start the demo skin."));
  const QCommandLineOption poses(QStringLiteral("poses"),
                                 QCoreApplication::translate("main", "Let the demo take N poses at once."),
                                 QStringLiteral("N"), QStringLiteral("0"));
  const QCommandLineOption theme(QStringLiteral("theme"),
                                 QCoreApplication::translate("main", "light, dark or system, for this time."),
                                 QStringLiteral("THEME"));
  const QCommandLineOption language(QStringLiteral("language"),
                                    QCoreApplication::translate("main", "en, de or system, for this time."),
                                    QStringLiteral("LANGUAGE"));
  const QCommandLineOption screenshot(
      QStringLiteral("screenshot"),
      QCoreApplication::translate("main", "Save a picture of the window after the first result, and quit."),
      QStringLiteral("FILE"));
  const QCommandLineOption software_opengl(
      QStringLiteral("software-opengl"),
      QCoreApplication::translate("main", "Draw in 3D without the graphics card, for this time."));
  parser.addOptions({demo, poses, theme, language, screenshot, software_opengl});
  parser.process(app);

  if (parser.positionalArguments().size() > 1) {
    return complain(QCoreApplication::translate("main", "One file at a time; see --help."), kUsage);
  }
  if (parser.isSet(demo) && !parser.positionalArguments().isEmpty()) {
    return complain(QCoreApplication::translate("main", "Give either --demo or a file, not both."), kUsage);
  }
  bool is_number = false;
  const int pose_count = parser.value(poses).toInt(&is_number);
  if (!is_number || pose_count < 0 || pose_count > 1000) {
    return complain(QCoreApplication::translate("main", "--poses takes a number from 0 to 1000."), kUsage);
  }
  if (pose_count > 0 && !parser.isSet(demo)) {
    return complain(QCoreApplication::translate("main", "--poses goes with --demo."), kUsage);
  }
  const std::optional<ThemeChoice> choice = themeChoiceFromName(parser.value(theme));
  if (parser.isSet(theme) && !choice) {
    return complain(QCoreApplication::translate("main", "--theme takes light, dark or system."), kUsage);
  }
  if (parser.isSet(language) && !isLanguageChoice(parser.value(language))) {
    return complain(QCoreApplication::translate("main", "--language takes en, de or system."), kUsage);
  }
  if (parser.isSet(screenshot) && !parser.isSet(demo) && parser.positionalArguments().isEmpty()) {
    return complain(QCoreApplication::translate("main", "--screenshot needs a file or --demo to show."), kUsage);
  }

  applyTextFactor(Preferences().textFactor());
  MainWindow window;
  if (choice) window.setThemeChoice(*choice, false);
  window.show();
  const Script script(window, pose_count, parser.value(screenshot));
  if (parser.isSet(demo)) window.startDemo();
  if (!parser.positionalArguments().isEmpty()) window.openFile(parser.positionalArguments().front());
  return QApplication::exec();
}
