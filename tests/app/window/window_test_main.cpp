// main() of the tests of the window: settings and standard folders that are neither the user's nor those of the same
// tests run beside these. Listing tests needs no display.

#include "tests/support/newcomer.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDir>
#include <QFile>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // Caches of fonts and shaders stay where they are: making them takes seconds.
  if (qEnvironmentVariableIsEmpty("XDG_CACHE_HOME")) {
    qputenv("XDG_CACHE_HOME", QFile::encodeName(QDir::home().filePath(".cache")));
  }
  const hexoderm::Newcomer newcomer;
  qputenv("HOME", QFile::encodeName(newcomer.folder()));
  const QApplication application(argc, argv);
  hexoderm::applyTextFactor(1);
  return RUN_ALL_TESTS();
}
