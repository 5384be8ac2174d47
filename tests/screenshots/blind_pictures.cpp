// Pictures of patches as the window draws them when a file is opened, without the words beside them: the 3D view alone,
// to be shown to people who are asked which cell is bad. See blind_test.py.

#include "app/window/main_window/main_window.h"
#include "app/window/settings/translation.h"
#include "tests/support/color_vision.h"
#include "tests/support/newcomer.h"
#include "widgets/patch/patch_view.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTextStream>

namespace {

using namespace hexoderm;

constexpr int kUsage = 2;

int complain(const QString& message, int code) {
  QTextStream(stderr) << "hexoderm-blind-pictures: " << message << '\n';
  return code;
}

struct Eyes {
  const char* name;
  ColorMatrix matrix;
};
const std::array<Eyes, 4> kEyes = {{{"all-colours", kAllColours},
                                    {"protanopia", kProtanopia},
                                    {"deuteranopia", kDeuteranopia},
                                    {"tritanopia", kTritanopia}}};

QImage seenBy(const ColorMatrix& eyes, const QImage& picture) {
  QImage seen = picture.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      const QColor color = seen.pixelColor(x, y);
      const Rgb other = hexoderm::seenBy(eyes, {color.redF(), color.greenF(), color.blueF()});
      seen.setPixelColor(x, y, QColor::fromRgbF(other[0], other[1], other[2]));
    }
  }
  return seen;
}

bool waitForResult(MainWindow& window, const QString& path) {
  constexpr int kPatience_ms = 60000;
  QElapsedTimer timer;
  timer.start();
  SessionController& controller = window.controller();
  const auto is_there = [&] {
    return controller.work().activity().isEmpty() && !controller.isSolving() && controller.reconstruction() &&
           controller.file().name() == QFileInfo(path).fileName();
  };
  while (!is_there()) {
    if (timer.elapsed() > kPatience_ms) return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 20);
  }
  window.showChanges();
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const Newcomer newcomer;
  QApplication app(argc, argv);

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Takes pictures of patches as the window draws them."));
  parser.addHelpOption();
  parser.addPositionalArgument(QStringLiteral("DIR"), QStringLiteral("The folder for the pictures."));
  parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Sessions."), QStringLiteral("FILE..."));
  const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light or dark."), QStringLiteral("THEME"),
                                 QStringLiteral("light"));
  parser.addOption(theme);
  parser.process(app);
  const QStringList arguments = parser.positionalArguments();
  if (arguments.size() < 2) return complain(QStringLiteral("A folder and a session, please; see --help."), kUsage);
  const std::optional<ThemeChoice> choice = themeChoiceFromName(parser.value(theme));
  if (!choice) return complain(QStringLiteral("--theme takes light or dark."), kUsage);

  installTranslations(app, QStringLiteral("en"));
  for (const QString& path : arguments.mid(1)) {
    MainWindow window;  // as after a start, whatever was seen before
    window.setThemeChoice(*choice, false);
    window.resize(1280, 800);
    window.show();
    window.openFile(path);
    if (!waitForResult(window, path)) return complain(QStringLiteral("%1 gives no result.").arg(path), 1);
    static_cast<void>(window.picture());  // settles all
    PatchView* view = window.findChild<PatchView*>();
    view->drawNow();
    const QImage picture = view->grab().toImage();
    for (const Eyes& eyes : kEyes) {
      const QDir folder(
          QStringLiteral("%1/%2-%3").arg(arguments.front(), parser.value(theme), QString::fromLatin1(eyes.name)));
      const QString file =
          folder.filePath(QFileInfo(path).fileName().section(QLatin1Char('.'), 0, 0) + QStringLiteral(".png"));
      if (!folder.mkpath(QStringLiteral(".")) || !seenBy(eyes.matrix, picture).save(file)) {
        return complain(QStringLiteral("%1 could not be written.").arg(file), 1);
      }
    }
    window.close();
  }
  return 0;
}
