// The reference data, opened in the window as a user would open it.

#include "hexoderm/reconstruction/advice/assess.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/util/units.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

const QString kData = QStringLiteral(HEXODERM_REFERENCE_DATA);

class WindowReferenceTest : public WindowTest {
 protected:
  void open(const QString& path) {
    window_->openFile(kData + path);
    ASSERT_TRUE(waitUntil([&] { return controller().file().name() == QFileInfo(path).fileName(); }))
        << message().toStdString();
    ASSERT_TRUE(waitUntilIdle());
  }
};

TEST_F(WindowReferenceTest, EverySimulatedSessionOpensAndIsSolvedAsWellAsOthersDo) {
  struct Vector {
    const char* name;
    std::size_t cells;
    std::size_t poses;
    double orientation_deg;  ///< twice what another implementation got
  };
  for (const Vector& vector : {Vector{"x17_cyl_p2", 17, 2, 5.4}, Vector{"x17_ideal_p3", 17, 3, 0.01},
                               Vector{"plane25_p3", 25, 3, 1.2}, Vector{"ring8_p6", 8, 6, 0.7}}) {
    ASSERT_NO_FATAL_FAILURE(open(QStringLiteral("/vectors/%1.session.json").arg(vector.name)));
    ASSERT_TRUE(waitForPoses(vector.poses)) << vector.name;
    EXPECT_EQ(controller().reconstruction()->cellCount(), vector.cells) << vector.name;
    const std::vector<Comparison> comparisons =
        compareToTruth(*controller().reconstruction(), *controller().session()->truth());
    ASSERT_EQ(comparisons.size(), 1U) << vector.name;
    EXPECT_LT(toDegrees(comparisons[0].orientation_rms_rad), vector.orientation_deg) << vector.name;
    EXPECT_FALSE(find<QWidget>("messageBar")->isVisible()) << vector.name << ": " << message().toStdString();
  }
}

TEST_F(WindowReferenceTest, ADeadSensorIsTheFirstFindingAndIsShownByTheBanner) {
  ASSERT_NO_FATAL_FAILURE(open("/vectors/x17_dead_sensor_p6.session.json"));
  const Finding* worst = worstFinding(*controller().reconstruction());
  ASSERT_NE(worst, nullptr);
  EXPECT_THAT(worst->cells, testing::Contains(CellId(7))) << worst->message.english();
  EXPECT_EQ(find<QPushButton>("bannerButton")->text(), "Show what does not fit");
  clickBanner();
  EXPECT_EQ(window_->selection().cell(), CellId(7));
}

TEST_F(WindowReferenceTest, ARealTumFileIsShownAsACalibration) {
  ASSERT_NO_FATAL_FAILURE(open("/real/tum_skin_config.xml"));
  EXPECT_EQ(controller().session(), nullptr);
  EXPECT_EQ(controller().reconstruction()->cellCount(), 4U);
  EXPECT_TRUE(action("actionExport")->isEnabled());
}

TEST_F(WindowReferenceTest, WhatHexodermDoesNotReadIsSaidAndNamed) {
  for (const char* name : {"icub_left_forearm_V2.txt", "xsens_static_poses_part1.csv"}) {
    window_->openFile(kData + "/real/" + name);
    ASSERT_TRUE(waitForMessage(name)) << message().toStdString();
    EXPECT_TRUE(message().contains("none of the files")) << message().toStdString();
    EXPECT_TRUE(controller().isEmpty());
  }
}

}  // namespace
}  // namespace hexoderm
