// Pictures of the real window in every step and of its dialogs, see packaging/screenshots.sh. Fails if a text is cut
// off or lies over another, or if the window is larger than it should be. Of sessions that are named: the 3D view alone
// as the window draws it when the file is opened, to be shown to people who are asked which cell is bad
// (blind_test.py).
#include "app/window/main_window/main_window.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/translation.h"
#include "tests/screenshots/screenshot_tour.h"
#include "tests/support/newcomer.h"
#include "tests/support/qt_wait.h"
#include "widgets/patch/patch_view.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QTextStream>
namespace {

using namespace hexoderm;

constexpr int kUsage = 2;

int complain(const QString& message, int code) {
  QTextStream(stderr) << "hexoderm-screenshots: " << message << '\n';
  return code;
}

/// The 3D view alone of each session: FOLDER/NAME.png.
int takePictures(const QString& folder, const QStringList& sessions, ThemeChoice theme, const QSize& size) {
  for (const QString& path : sessions) {
    MainWindow window;  // as after a start, whatever was seen before
    window.setThemeChoice(theme, false);
    window.resize(size);
    window.show();
    window.openFile(path);
    const SessionController& controller = window.controller();
    const QString name = QFileInfo(path).fileName();
    if (!test::waitUntil([&] {
          return controller.work().activity().isEmpty() && !controller.isSolving() && controller.reconstruction() &&
                 controller.file().name() == name;
        })) {
      return complain(QStringLiteral("%1 gives no result.").arg(path), 1);
    }
    window.showChanges();
    static_cast<void>(window.picture());  // settles all
    auto* view = window.findChild<PatchView*>();
    view->drawNow();
    const QString file = QDir(folder).filePath(name.section(QLatin1Char('.'), 0, 0) + QStringLiteral(".png"));
    if (!QDir().mkpath(folder) || !view->grab().save(file)) {
      return complain(QStringLiteral("%1 could not be written.").arg(file), 1);
    }
    window.close();
  }
  return 0;
}

}  // namespace
int main(int argc, char** argv) {
  const Newcomer newcomer;
  QApplication app(argc, argv);

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Takes pictures of Hexoderm's window on a tour through the demo."));
  parser.addHelpOption();
  parser.addPositionalArgument(QStringLiteral("DIR"), QStringLiteral("The folder for the pictures."));
  parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Sessions: the 3D view alone of each."),
                               QStringLiteral("[FILE...]"));
  const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("The window's size in pixels."),
                                QStringLiteral("WxH"), QStringLiteral("1280x800"));
  const QCommandLineOption width(QStringLiteral("width"),
                                 QStringLiteral("Wider pictures are made smaller; 0: they are left as they are."),
                                 QStringLiteral("PIXELS"), QStringLiteral("0"));
  const QCommandLineOption language(QStringLiteral("language"), QStringLiteral("en or de."), QStringLiteral("LANGUAGE"),
                                    QStringLiteral("en"));
  const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light or dark."), QStringLiteral("THEME"),
                                 QStringLiteral("light"));
  const QCommandLineOption text(QStringLiteral("text"), QStringLiteral("Size of the text in per cent."),
                                QStringLiteral("PERCENT"), QStringLiteral("100"));
  parser.addOptions({size, width, language, theme, text});
  parser.process(app);

  const QStringList arguments = parser.positionalArguments();
  if (arguments.isEmpty()) return complain(QStringLiteral("A folder, please; see --help."), kUsage);
  const QStringList sides = parser.value(size).split(QLatin1Char('x'));
  const QSize window_size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
  if (window_size.isEmpty()) return complain(QStringLiteral("--size takes a size, for example 1280x800."), kUsage);
  bool is_number = false;
  const int largest_width_px = parser.value(width).toInt(&is_number);
  if (!is_number || largest_width_px < 0) return complain(QStringLiteral("--width takes a number of pixels."), kUsage);
  const std::optional<ThemeChoice> choice = themeChoiceFromName(parser.value(theme));
  if (!choice) return complain(QStringLiteral("--theme takes light or dark."), kUsage);
  const int text_percent = parser.value(text).toInt(&is_number);
  if (!is_number || text_percent < 50 || text_percent > 300)
    return complain(QStringLiteral("--text takes a size from 50 to 300 per cent."), kUsage);
  if (!isLanguageChoice(parser.value(language))) return complain(QStringLiteral("--language takes en or de."), kUsage);

  const QString texts_language = installTranslations(app, parser.value(language));
  applyTextFactor(text_percent / 100.0);
  if (arguments.size() > 1) {
    const QString folder = arguments.front() + QLatin1Char('/') + parser.value(theme);
    return takePictures(folder, arguments.mid(1), *choice, window_size);
  }
  MainWindow window;
  window.setThemeChoice(*choice, false);
  const QString prefix =
      texts_language + QLatin1Char('-') +
      (window.theme() == Theme::Dark ? QStringLiteral("dark-") : QStringLiteral("light-")) + parser.value(size) +
      (text_percent == 100 ? QString() : QStringLiteral("-text%1").arg(text_percent)) +
      (window.devicePixelRatioF() == 1 ? QString()
                                       : QStringLiteral("-scale%1").arg(qRound(100 * window.devicePixelRatioF())));
  const QStringList problems =
      ScreenshotTour(window, QDir(arguments.front()), prefix, largest_width_px).run(window_size);
  for (const QString& problem : problems) complain(problem, 0);
  return problems.isEmpty() ? 0 : 1;
}
