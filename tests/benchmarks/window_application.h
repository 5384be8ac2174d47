#pragma once

#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"

#include <QApplication>
#include <QEventLoop>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

namespace hexoderm {

/// The application of a benchmark that measures the real window: with a home of its own, and as everybody's settings
/// are at first.
class WindowApplication {
 public:
  WindowApplication(int& argc, char** argv, const char* name) : application_(styled(home_, argc), argv) {
    QCoreApplication::setOrganizationName(QStringLiteral("HexodermBenchmarks"));
    QCoreApplication::setApplicationName(QLatin1String(name));
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home_.path());
    applyTextFactor(1);
  }

  [[nodiscard]] const QApplication& application() const { return application_; }
  [[nodiscard]] QString home() const { return home_.path(); }

 private:
  /// What has to be done before there is an application.
  static int& styled(const QTemporaryDir& home, int& argc) {
    qputenv("HOME", QFile::encodeName(home.path()));
    installStyle();
    return argc;
  }

  QTemporaryDir home_;
  QApplication application_;
};

/// Lets the window go on for a while.
inline void letPass(int ms) {
  QEventLoop loop;
  QTimer::singleShot(ms, &loop, &QEventLoop::quit);
  loop.exec();
}

}  // namespace hexoderm
