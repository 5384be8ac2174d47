// The sessions of tests/data/vectors, opened in the window as a user would open them.

#include "hexoderm/reconstruction/advice/assess.h"
#include "hexoderm/reconstruction/evaluation/evaluation.h"
#include "hexoderm/util/units.h"
#include "tests/app/window/window_test.h"
#include "tests/support/paths.h"

namespace hexoderm {
namespace {

class WindowVectorsTest : public WindowTest {
 protected:
  void open(const QString& name) {
    window_->openFile(QStringLiteral(HEXODERM_TEST_DATA "/vectors/%1.session.json").arg(name));
    ASSERT_TRUE(waitUntil([&] { return controller().file().name() == name + ".session.json"; }))
        << message().toStdString();
    ASSERT_TRUE(waitUntilIdle());
  }
};

TEST_F(WindowVectorsTest, EverySimulatedSessionOpensAndIsSolvedAsWellAsOthersDo) {
  struct Vector {
    const char* name;
    std::size_t cells;
    std::size_t poses;
    double orientation_deg;  ///< twice what another implementation got
  };
  for (const Vector& vector : {Vector{"x17_cyl_p2", 17, 2, 5.4}, Vector{"x17_ideal_p3", 17, 3, 0.01},
                               Vector{"plane25_p3", 25, 3, 1.2}, Vector{"ring8_p6", 8, 6, 0.7}}) {
    ASSERT_NO_FATAL_FAILURE(open(vector.name));
    ASSERT_TRUE(waitForPoses(vector.poses)) << vector.name;
    EXPECT_EQ(controller().reconstruction()->cellCount(), vector.cells) << vector.name;
    const std::vector<Comparison> comparisons =
        compareToTruth(*controller().reconstruction(), *controller().session()->truth());
    ASSERT_EQ(comparisons.size(), 1U) << vector.name;
    EXPECT_LT(toDegrees(comparisons[0].orientation_rms_rad), vector.orientation_deg) << vector.name;
    EXPECT_FALSE(find<QWidget>("messageBar")->isVisible()) << vector.name << ": " << message().toStdString();
  }
}

TEST_F(WindowVectorsTest, ADeadSensorIsTheFirstFindingAndIsShownByTheBanner) {
  ASSERT_NO_FATAL_FAILURE(open("x17_dead_sensor_p6"));
  const Finding* worst = worstFinding(*controller().reconstruction());
  ASSERT_NE(worst, nullptr);
  EXPECT_THAT(worst->cells, testing::Contains(CellId(7))) << worst->message.english();
  EXPECT_EQ(find<QPushButton>("bannerButton")->text(), "Show what does not fit");
  clickBanner();
  EXPECT_EQ(window_->selection().cell(), CellId(7));
}

}  // namespace
}  // namespace hexoderm
