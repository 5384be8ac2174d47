// main() of the tests of widgets: an application. Listing tests needs no display.

#include <gtest/gtest.h>
#include <QApplication>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  QApplication::setStyle(QStringLiteral("Fusion"));  // the same on every desktop
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
