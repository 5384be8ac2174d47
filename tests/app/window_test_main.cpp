// main() of the tests of the window: the surface format that VTK needs, settings and standard folders that are not the
// user's. Listing tests needs no display.

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setStyle(QStringLiteral("Fusion"));
  const QApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("HexodermTests"));
  QCoreApplication::setApplicationName(QStringLiteral("main_window_test"));
  QStandardPaths::setTestModeEnabled(true);
  const QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  return RUN_ALL_TESTS();
}
