#include "app/window/log/bug_report.h"

#include "app/window/log/event_log.h"
#include "app/window/session/session_controller.h"
#include "widgets/patch/scene_widget.h"

#include <vtkVersion.h>
#include <QDir>
#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QRegularExpression>
#include <QScreen>
#include <QStringList>
#include <QSysInfo>
#include <QWidget>

namespace hexoderm {
namespace {

constexpr std::size_t kLogLines = 200;

/// Asked from the context that draws, so that nothing is made again for it.
QString graphicsText(QWidget& window) {
  auto* view = window.findChild<SceneWidget*>();
  if (!view || !view->makeCurrent()) return QStringLiteral("none");
  const auto ask = [functions = view->context().functions()](GLenum name) {
    return QString::fromLatin1(reinterpret_cast<const char*>(functions->glGetString(name)));
  };
  const QString words = QStringLiteral("%1, OpenGL %2").arg(ask(GL_RENDERER), ask(GL_VERSION));
  view->context().doneCurrent();
  return words;
}

QString screensText(const QWidget& window) {
  QStringList words;
  for (const QScreen* screen : QGuiApplication::screens()) {
    words << QStringLiteral("%1x%2 at scale %3, %4 dpi")
                 .arg(screen->geometry().width())
                 .arg(screen->geometry().height())
                 .arg(screen->devicePixelRatio())
                 .arg(screen->logicalDotsPerInch(), 0, 'f', 0);
  }
  return QStringLiteral("%1; window %2x%3, text %4 pt")
      .arg(words.join(QStringLiteral("; ")))
      .arg(window.width())
      .arg(window.height())
      .arg(QGuiApplication::font().pointSizeF());
}

QString sessionText(const SessionController& controller) {
  if (controller.isEmpty()) return QStringLiteral("nothing is open");
  QStringList words = {controller.file().name()};
  if (controller.liveSession().isDemo()) words << QStringLiteral("demo");
  if (controller.liveSession().source().isRunning()) {
    words << QStringLiteral("connected to %1: %2")
                 .arg(controller.liveSession().source().address(),
                      QString::fromStdString(controller.liveSession().source().status().message.english()));
  }
  if (controller.session()) words << QStringLiteral("%1 poses").arg(controller.session()->poses().size());
  if (const Reconstruction* result = controller.reconstruction().get()) {
    words << QStringLiteral("%1 cells, %2 links, %3 patches, %4 findings")
                 .arg(result->cellCount())
                 .arg(result->linkCount())
                 .arg(result->patches.size())
                 .arg(result->findings.size())
          << QStringLiteral("solver %1").arg(QString::fromStdString(result->solver))
          << QString::fromStdString(result->assessment.reason.english());
  }
  return words.join(QStringLiteral("; "));
}

}  // namespace

QString withoutHome(QString text, const QString& home) {
  if (home.size() < 2) return text;
  const QRegularExpression whole_name(QRegularExpression::escape(home) + QStringLiteral("(?![\\w.-])"));
  return text.replace(whole_name, QStringLiteral("~"));
}

QString composeBugReport(const EventLog& log, const SessionController& controller, QWidget& window) {
  const auto line = [](const char* name, const QString& value) {
    return QStringLiteral("%1: %2\n").arg(QLatin1String(name), value);
  };
  QString report = line("Hexoderm", QStringLiteral(HEXODERM_VERSION));
  report += line("Qt", QLatin1String(qVersion()));
  report += line("VTK", QString::fromLatin1(vtkVersion::GetVTKVersion()));
  report += line("Graphics", graphicsText(window));
  report += line("Software OpenGL asked for",
                 qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE") ? QStringLiteral("yes") : QStringLiteral("no"));
  report += line("System", QStringLiteral("%1, %2, %3")
                               .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(),
                                    QGuiApplication::platformName()));
  report += line("Screen", screensText(window));
  report += line("Session", sessionText(controller));
  report += QStringLiteral("\nThe last %1 lines of the log:\n").arg(kLogLines);
  for (const LogLine& entry : log.newest(kLogLines)) report += asFileLine(entry) + QLatin1Char('\n');
  return withoutHome(report, QDir::homePath());
}

}  // namespace hexoderm
