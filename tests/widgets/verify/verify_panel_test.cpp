#include "widgets/verify/verify_panel.h"

#include "tests/widgets/verify/verify_panel_fixture.h"

namespace hexoderm::verify_panel_test {
namespace {

TEST_F(VerifyPanelTest, SaysWhyAPoseCannotBeHeldOut) {
  auto* run = find<QPushButton>("holdOutRun");
  EXPECT_FALSE(run->isEnabled());
  EXPECT_EQ(sentence("holdOut"), "There is no skin yet.");
  EXPECT_EQ(run->toolTip().toStdString(), "There is no skin yet.");
  panel_->setAwaited("Opening arm.hexo…");
  EXPECT_EQ(sentence("holdOut"), "Opening arm.hexo…");
  panel_->setAwaited({});
  EXPECT_EQ(sentence("holdOut"), "There is no skin yet.");
  panel_->setReconstruction(skin());
  panel_->setHasReadings(false);
  EXPECT_FALSE(run->isEnabled());
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("A calibration file holds no readings"));
  auto none = skin();
  none->poses.clear();
  panel_->setHasReadings(true);
  panel_->setReconstruction(none);
  EXPECT_FALSE(find<QComboBox>("holdOutPose")->isEnabled());
  EXPECT_EQ(sentence("holdOut"), "Takes 4 poses that are not disabled, and there is none yet.");
  // Of four poses one is disabled: it can be predicted from the three others, but none of these from two.
  auto four = skin();
  four->poses.pop_back();
  panel_->setReconstruction(four);
  EXPECT_FALSE(run->isEnabled());
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("besides this one there are 2"));
  auto* pose = find<QComboBox>("holdOutPose");
  ASSERT_TRUE(pose->isEnabled()) << "another one may do";
  pose->setFocus();
  QTest::keyClick(pose, Qt::Key_Up);
  EXPECT_EQ(pose->currentData().toUInt(), 3U);
  EXPECT_TRUE(run->isEnabled());
  panel_->setReconstruction(skin());
  EXPECT_TRUE(run->isEnabled());
}

TEST_F(VerifyPanelTest, AsksForThePoseThatIsChosenAndKeepsTheChoice) {
  panel_->setReconstruction(skin());
  std::vector<PoseId> asked;
  QObject::connect(panel_, &VerifyPanel::holdOutRequested, [&](PoseId pose) { asked.push_back(pose); });
  auto* pose = find<QComboBox>("holdOutPose");
  EXPECT_EQ(pose->itemText(0).toStdString(), "Pose 1 · standing");
  EXPECT_EQ(pose->itemText(2).toStdString(), "Pose 3 · facing wall · disabled");
  pose->setCurrentIndex(1);
  panel_->setReconstruction(skin());
  QTest::mouseClick(find<QPushButton>("holdOutRun"), Qt::LeftButton);
  EXPECT_THAT(asked, testing::ElementsAre(PoseId(2)));
}

TEST_F(VerifyPanelTest, HoldOutHasAVerdictAndMetricsThatPick) {
  panel_->setReconstruction(skin());
  panel_->showHoldOut(heldOut(HoldOutAgreement::AsStated, 0.4));
  EXPECT_EQ(sentence("holdOut"),
            "As good as stated. The other 5 poses predict pose 3 to 0.40° (rms over 17 cells); 0.50° were expected.");
  HoldOutResult coarse = heldOut(HoldOutAgreement::AsStated, 0.4);
  coarse.detectable_rad = 5 * kDegree;
  coarse.coarse = true;
  panel_->showHoldOut(coarse);
  EXPECT_THAT(sentence("holdOut"), testing::StartsWith("As good as stated, but a coarse check"));
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("bent by less than about 5.00° would not show"));
  HoldOutResult turned = heldOut(HoldOutAgreement::FarWorse, 0.4);
  turned.turning_rad_s2 = 10;
  turned.turned = true;
  turned.expected_turning_rad_s2 = 1.7;
  panel_->showHoldOut(turned);
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("turned while it was read: 10.0 rad/s², of a still hand 1.7"));
  panel_->showHoldOut(heldOut(HoldOutAgreement::FarWorse, 2));
  EXPECT_THAT(sentence("holdOut"), testing::Not(testing::HasSubstr("turned")));
  EXPECT_THAT(sentence("holdOut"), testing::StartsWith("Far worse than stated"));
  EXPECT_THAT(sentence("holdOut"), testing::HasSubstr("Worst: cell 8, 6.00°."));
  auto* table = find<QTableView>("holdOutTable");
  ASSERT_TRUE(table->isVisible());
  EXPECT_EQ(table->model()->rowCount(), 17);
  table->selectRow(4);
  EXPECT_EQ(selection_.cell(), CellId(5));
  QTest::mouseClick(find<QToolButton>("holdOutByLink"), Qt::LeftButton);
  EXPECT_EQ(table->model()->rowCount(), 1);
  table->selectRow(0);
  EXPECT_TRUE(selection_.link().has_value());

  panel_->setReconstruction(skin());
  EXPECT_EQ(sentence("holdOut"), "The session has changed since: run it again.");
  EXPECT_FALSE(table->isVisible());
}

TEST_F(VerifyPanelTest, LongWorkShowsItselfAndCanBeCancelled) {
  panel_->setReconstruction(skin());
  std::vector<VerifyCheck> cancelled;
  QObject::connect(panel_, &VerifyPanel::cancelRequested, [&](VerifyCheck check) { cancelled.push_back(check); });
  panel_->setRunning(VerifyCheck::HoldOut, true);
  auto* cancel = find<QPushButton>("holdOutCancel");
  EXPECT_FALSE(find<QPushButton>("holdOutRun")->isEnabled());
  ASSERT_TRUE(test::waitUntil([&] { return cancel->isVisible(); }));
  EXPECT_EQ(sentence("holdOut"), "");
  QTest::mouseClick(cancel, Qt::LeftButton);
  EXPECT_THAT(cancelled, testing::ElementsAre(VerifyCheck::HoldOut));
  panel_->setRunning(VerifyCheck::HoldOut, false);
  EXPECT_FALSE(cancel->isVisible());
  EXPECT_TRUE(find<QPushButton>("holdOutRun")->isEnabled());
}

TEST_F(VerifyPanelTest, WhatFailsTakesItsEarlierResultOutOfTheOtherViews) {
  panel_->setReconstruction(skin());
  std::optional<SurfaceEvaluation> surface;
  std::optional<LoopEvaluation> shown_loop;
  std::vector<Comparison> comparisons;
  QObject::connect(panel_, &VerifyPanel::surfaceShown, [&](const auto& shown) { surface = shown; });
  QObject::connect(panel_, &VerifyPanel::loopShown, [&](const auto& shown) { shown_loop = shown; });
  QObject::connect(panel_, &VerifyPanel::comparisonShown, [&](const auto& shown) { comparisons = shown; });
  panel_->showSurfaces({cylinder()}, {});
  panel_->showLoops({loop(false, 0.01)});
  panel_->showComparison({Comparison{}}, "earlier.hexo");
  ASSERT_TRUE(surface && shown_loop && comparisons.size() == 1);
  panel_->showFailure(VerifyCheck::Surface, "No.");
  panel_->showFailure(VerifyCheck::Loops, "No.");
  panel_->showFailure(VerifyCheck::Comparison, "No.");
  EXPECT_FALSE(surface);
  EXPECT_FALSE(shown_loop);
  EXPECT_TRUE(comparisons.empty());
}

TEST_F(VerifyPanelTest, FitsBesideThe3DViewOfASmallWindowInBothThemes) {
  panel_->setReconstruction(skin());
  panel_->showHoldOut(heldOut(HoldOutAgreement::Worse, 0.9));
  panel_->showLoops({loop(false, 0.0034), loop(true, 0.0012)});
  find<QComboBox>("surfaceKind")->setCurrentText("Cylinder");
  panel_->showSurfaces({cylinder()}, {});
  panel_->showComparison({}, "other.calibration.json");
  panel_->checkOldCalibration("arm.calibration.json");
  panel_->showOldCalibration(changedSkin(), "arm.calibration.json");
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    theme_.set(theme);
    QCoreApplication::processEvents();
    EXPECT_LE(panel_->minimumSizeHint().width(), 280);
    keep(theme == Theme::Light ? "verify-panel-light" : "verify-panel-dark");
  }
}

}  // namespace
}  // namespace hexoderm::verify_panel_test
