// main() of the tests of the window: settings and standard folders that are neither the user's nor those of the same
// tests run beside these. Listing tests needs no display.

#include "app/window/settings/preferences.h"
#include "app/window/settings/theme.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // Caches of fonts and shaders stay where they are: making them takes seconds.
  if (qEnvironmentVariableIsEmpty("XDG_CACHE_HOME")) {
    qputenv("XDG_CACHE_HOME", QFile::encodeName(QDir::home().filePath(".cache")));
  }
  const QTemporaryDir home;
  qputenv("HOME", QFile::encodeName(home.path()));
  hexoderm::installStyle();
  const QApplication application(argc, argv);
  QCoreApplication::setOrganizationName("HexodermTests");
  QCoreApplication::setApplicationName("main_window_test");
  QStandardPaths::setTestModeEnabled(true);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home.path());
  hexoderm::applyTextFactor(1);
  return RUN_ALL_TESTS();
}
