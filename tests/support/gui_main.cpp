// main() of the tests of widgets: an application with the surface format that VTK needs. Listing tests needs no
// display.

#include "widgets/opengl_info.h"

#include <gtest/gtest.h>
#include <QApplication>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  hexoderm::prepareOpenGl();
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
