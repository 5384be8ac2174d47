// Pictures of the real window in every step and of its dialogs, see packaging/screenshots.sh. Fails if a text is cut
// off or lies over another, or if the window is larger than it should be.

#include "app/window/main_window/main_window.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/translation.h"
#include "tests/screenshots/screenshot_tour.h"
#include "tests/support/newcomer.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTextStream>

namespace {

using namespace hexoderm;

constexpr int kUsage = 2;

int complain(const QString& message, int code) {
  QTextStream(stderr) << "hexoderm-screenshots: " << message << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  const Newcomer newcomer;
  QApplication app(argc, argv);

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Takes pictures of Hexoderm's window on a tour through the demo."));
  parser.addHelpOption();
  parser.addPositionalArgument(QStringLiteral("DIR"), QStringLiteral("The folder for the pictures."));
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

  if (parser.positionalArguments().size() != 1)
    return complain(QStringLiteral("One folder, please; see --help."), kUsage);
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
  MainWindow window;
  window.setThemeChoice(*choice, false);
  const QString prefix =
      texts_language + QLatin1Char('-') +
      (window.theme() == Theme::Dark ? QStringLiteral("dark-") : QStringLiteral("light-")) + parser.value(size) +
      (text_percent == 100 ? QString() : QStringLiteral("-text%1").arg(text_percent)) +
      (window.devicePixelRatioF() == 1 ? QString()
                                       : QStringLiteral("-scale%1").arg(qRound(100 * window.devicePixelRatioF())));
  const QStringList problems =
      ScreenshotTour(window, QDir(parser.positionalArguments().front()), prefix, largest_width_px).run(window_size);
  for (const QString& problem : problems) complain(problem, 0);
  return problems.isEmpty() ? 0 : 1;
}
