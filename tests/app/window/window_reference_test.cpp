// Recordings of others, opened in the window as a user would open them.

#include "tests/app/window/window_test.h"
#include "tests/support/paths.h"

namespace hexoderm {
namespace {

const QString kData = QStringLiteral(HEXODERM_REFERENCE_DATA);

using WindowReferenceTest = WindowTest;

TEST_F(WindowReferenceTest, ARealTumFileIsShownAsACalibration) {
  ASSERT_NO_FATAL_FAILURE(openFile(kData + "/real/tum_skin_config.xml"));
  EXPECT_EQ(controller().session(), nullptr);
  EXPECT_EQ(controller().reconstruction()->cellCount(), 4U);
  EXPECT_TRUE(action("actionExport")->isEnabled());
}

TEST_F(WindowReferenceTest, WhatHexodermDoesNotReadIsSaidAndNamed) {
  for (const char* name : {"icub_left_forearm_V2.txt", "xsens_static_poses_part1.csv"}) {
    window_->openFile(kData + "/real/" + name);
    ASSERT_TRUE(waitForMessage(name));
    EXPECT_TRUE(message().contains("none of the files")) << message().toStdString();
    EXPECT_TRUE(controller().isEmpty());
  }
}

}  // namespace
}  // namespace hexoderm
