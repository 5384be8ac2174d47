#include "widgets/capture/coverage_view.h"

#include "hexoderm/solve/metrics/pose_coverage.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

/// Of a result that another pose would help until a third direction was seen, as the assessment of a real one has it.
PoseCoverage coverageWith(const std::vector<Eigen::Vector3d>& ups, std::size_t disabled = 99) {
  auto result = sampleX17();
  result->assessment.remedy = ups.size() < 3 ? Remedy::TakePose : Remedy::Nothing;
  result->poses.clear();
  for (std::size_t k = 0; k < ups.size(); ++k) {
    const PoseId id(static_cast<std::uint32_t>(k + 1));
    result->patches[0].gravity.push_back({id, ups[k].normalized(), 0.01});
    PoseSummary pose;
    pose.pose = id;
    pose.label = Message::verbatim("label " + toString(id));
    result->poses.push_back(pose);
  }
  PoseCoverage coverage = coverageOf(*result);
  if (disabled < ups.size()) {
    coverage.seen[disabled].enabled = false;
    --coverage.enabled;
  }
  return coverage;
}

class CoverageViewTest : public testing::Test {
 protected:
  void SetUp() override {
    view.resize(320, 360);
    view.show();
    ASSERT_TRUE(test::waitUntilExposed(view));
  }
  QColor colorAt(const Eigen::Vector3d& up, const QPoint& beside = {}) {
    const QImage image = view.grab().toImage();
    return image.pixelColor((view.placeOf(up).toPoint() + beside) * image.devicePixelRatio());
  }

  CoverageView view;
};

TEST_F(CoverageViewTest, DrawsEveryPoseOnItsDiscAndADisabledOneHollow) {
  const std::vector<Eigen::Vector3d> ups = {{0, 0, 1}, {0.2, 0.3, -0.9}};
  view.setCoverage(coverageWith({}));
  const QImage before = view.grab().toImage();
  view.setCoverage(coverageWith(ups));
  EXPECT_NE(view.grab().toImage(), before);
  EXPECT_LT(view.placeOf(ups[0]).x(), view.width() / 2.0);
  EXPECT_GT(view.placeOf(ups[1].normalized()).x(), view.width() / 2.0);
  const QColor full = linkStroke(EdgeQuality::Fully, Theme::Light).color;
  EXPECT_EQ(colorAt(ups[0], {-5, 0}), full);
  EXPECT_EQ(colorAt(ups[1].normalized(), {-5, 0}), full);
  view.setCoverage(coverageWith(ups, 0));
  EXPECT_EQ(colorAt(ups[0], {-5, 0}), Colors::of(Theme::Light).panel);
}

TEST_F(CoverageViewTest, AClickPicksThePoseUnderIt) {
  view.setCoverage(coverageWith({{0, 0, 1}, {0.2, 0.3, -0.9}}));
  QSignalSpy picked(&view, &CoverageView::posePicked);
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.placeOf(Eigen::Vector3d(0.2, 0.3, -0.9).normalized()).toPoint());
  ASSERT_EQ(picked.count(), 1);
  EXPECT_EQ(view.pickedPose(), PoseId(2));
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(2, 2));
  EXPECT_EQ(picked.count(), 1) << "beside the poses nothing is picked";
  const QImage before = view.grab().toImage();
  view.setPickedPose(PoseId(1));
  EXPECT_NE(view.grab().toImage(), before) << "what is picked elsewhere is outlined";
  EXPECT_EQ(picked.count(), 1);
}

TEST_F(CoverageViewTest, ArrowKeysGoRoundThePoses) {
  view.setCoverage(coverageWith({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
  QSignalSpy picked(&view, &CoverageView::posePicked);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_EQ(view.pickedPose(), PoseId(1));
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_EQ(view.pickedPose(), PoseId(1));
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_EQ(view.pickedPose(), PoseId(3));
  EXPECT_EQ(picked.count(), 5);
}

TEST_F(CoverageViewTest, ShowsNextAndPresentDirectionAndHidesThemAgain) {
  view.setCoverage(coverageWith({{0, 0, 1}}));
  const QImage before = view.grab().toImage();
  view.setNext(Eigen::Vector3d(0.3, 0.2, -0.9).normalized());
  const QImage with_next = view.grab().toImage();
  EXPECT_NE(with_next, before);
  const Eigen::Vector3d now = Eigen::Vector3d(-0.5, 0.4, 0.7).normalized();
  view.setCurrent(now);
  EXPECT_NE(view.grab().toImage(), with_next);
  view.setCurrent(std::nullopt);
  EXPECT_EQ(view.grab().toImage(), with_next);
  view.setNext(std::nullopt);
  EXPECT_EQ(view.grab().toImage(), before);
}

TEST_F(CoverageViewTest, WithoutASkinItSaysSoAndDrawsNoValue) {
  view.setEmptyHint("No poses yet.");
  const QImage empty = view.grab().toImage();
  const QRgb below_limit = linkStroke(EdgeQuality::Partially, Theme::Light).color.rgb();
  const QRgb undefined = linkStroke(EdgeQuality::Undefined, Theme::Light).color.rgb();
  for (int y = 0; y < empty.height(); ++y) {
    for (int x = 0; x < empty.width(); ++x) {
      ASSERT_NE(empty.pixel(x, y), below_limit) << x << ' ' << y;
      ASSERT_NE(empty.pixel(x, y), undefined) << x << ' ' << y;
    }
  }
  view.setEmptyHint({});
  EXPECT_NE(view.grab().toImage(), empty);
}

TEST_F(CoverageViewTest, SaysInWordsWhatItShows) {
  view.setCoverage(coverageWith({{1, 0, 0}, {0, 1, 0}}));
  EXPECT_THAT(
      view.accessibleDescription(),
      HasTexts({"2 poses", "fully defined", "facing the ceiling or the floor: the third value is 0.00, needs 0.50"}));
  view.setCoverage(coverageWith({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}));
  EXPECT_TRUE(view.accessibleDescription().contains("No direction is missing"));
}

TEST_F(CoverageViewTest, NamesNoOtherCellWhereTheNextPoseGivesWhatIsMissing) {
  view.setCoverage(coverageWith({{1, 0, 0}, {0, 1, 0}}));
  view.setNext(Eigen::Vector3d::UnitZ());
  EXPECT_THAT(view.accessibleDescription(),
              HasText("A third direction is missing (value 0.00, needs 0.50); the next pose is one."));
  view.setNext(Eigen::Vector3d(1, 1, 0).normalized());  // helps otherwise: no second instruction beside it
  EXPECT_THAT(view.accessibleDescription(), HasText("A third direction is not seen yet: its value is 0.00, of 0.50."));
  EXPECT_FALSE(view.accessibleDescription().contains("facing the ceiling or the floor"));
  view.setNext(Eigen::Vector3d::UnitZ());
  view.setNext(std::nullopt);
  EXPECT_TRUE(view.accessibleDescription().contains("facing the ceiling or the floor"));
}

TEST_F(CoverageViewTest, FitsIntoSmallPlacesAndLooksDifferentInTheDark) {
  view.resize(180, 230);
  view.setCoverage(coverageWith({{0, 0, 1}, {0, 0.1, -1}}));
  EXPECT_TRUE(QRectF(view.rect()).contains(view.placeOf(Eigen::Vector3d::UnitZ())));
  EXPECT_TRUE(QRectF(view.rect()).contains(view.placeOf(-Eigen::Vector3d::UnitZ())));
  const QImage light = view.grab().toImage();
  view.setPalette(qtPalette(Theme::Dark));
  EXPECT_NE(view.grab().toImage(), light);
}

}  // namespace
}  // namespace hexoderm
