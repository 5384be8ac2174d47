#include "app/window/main_window/main_window.h"

#include "app/window/files/session_paths.h"
#include "tests/app/window/window_test.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/controls/view_mark.h"

namespace hexoderm {
namespace {

using MainWindowTest = WindowTest;

TEST_F(MainWindowTest, KeysGoToTheButtonOrFieldThatHasTheFocus) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  find<QAbstractButton>("stepHead1")->setFocus(Qt::TabFocusReason);
  press(Qt::Key_Space);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(posesShown(), 1U) << "the step was to be opened";
  clickRow("poseView", 0);
  press(Qt::Key_F, Qt::ControlModifier);
  auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(field, nullptr);
  QTest::keyClicks(field, "12");
  EXPECT_EQ(window_->selection().cell(), CellId(12));
  QTest::keyClick(field, Qt::Key_Home);
  QTest::keyClick(field, Qt::Key_Delete);
  EXPECT_EQ(field->text(), "2");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_FALSE(controller().session()->poses()[0].disabled);
}

TEST_F(MainWindowTest, FourKeysLeadFromTheStartToAnExportedCalibrationWithinAMinute) {
  // The speed is that at which a newcomer sees it.
  QSettings().setValue("demo/source", "sim:x17");
  press(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return action("actionRobot")->isEnabled(); }));
  press(Qt::Key_B);
  EXPECT_TRUE(controller().liveSession().isRobotOn());
  ASSERT_TRUE(waitUntil([this] { return !controller().liveSession().isRobotOn(); }));
  // By the skin's clock: a busy computer is no fault of the window.
  const double rate_hz = controller().session()->model().accelerometer.rate_hz;
  EXPECT_LT(static_cast<double>(controller().liveSession().source().status().frames) / rate_hz, 60);
  ASSERT_TRUE(waitUntilIdle());
  openExportDialog();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  ASSERT_TRUE(waitForMessage("Exported to "));
}

TEST_F(MainWindowTest, TheRobotTakesAllPosesAfterTheFirstAndNoneIsSkippedWhenThereAreEnough) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(0));
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().nextPose().has_value(); }));
  const auto isAsked = [this] { return action("actionTurn")->isEnabled() && action("actionSkipPose")->isEnabled(); };
  for (const char* name : {"actionTurn", "actionSkipPose"}) {
    EXPECT_FALSE(action(name)->isEnabled()) << name;
    EXPECT_THAT(action(name)->toolTip(), HasText("Any way up"));
  }
  EXPECT_TRUE(action("actionRobot")->isEnabled());
  controller().liveSession().captureNow();
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntil(isAsked));

  ASSERT_TRUE(waitUntil([this] { return bannerButton().startsWith("Let the simulated"); }));
  clickBanner();
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isRobotOn(); }));
  EXPECT_EQ(bannerButton(), "Stop the robot");
  ASSERT_TRUE(waitUntil([this] { return !controller().liveSession().isRobotOn(); }));
  ASSERT_TRUE(waitUntilIdle());
  ASSERT_TRUE(waitUntil([&] { return !isAsked(); }));
  EXPECT_FALSE(controller().liveSession().wantsMorePoses());
  EXPECT_EQ(bannerButton(), "Export…");
  EXPECT_FALSE(controller().reconstruction()->assessment.wantsPose())
      << posesShown() << " poses: " << controller().reconstruction()->assessment.reason;
  expectDisabled("actionSkipPose", "enough poses");
  EXPECT_TRUE(waitUntil([this] { return action("actionTurn")->isEnabled(); }))
      << "for a result that is better than good";
}

TEST_F(MainWindowTest, APoseIsTakenAgainInItsPlaceAndEverythingIsUndone) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  const auto first = controller().session()->poses()[0].capture;
  EXPECT_FALSE(action("actionRecapture")->isEnabled());
  clickRow("poseView", 0);
  press(Qt::Key_R);
  EXPECT_EQ(controller().liveSession().recapturing(), PoseId(1));
  ASSERT_TRUE(waitForMessage("takes the place of pose 1"));
  press(Qt::Key_R);
  EXPECT_TRUE(waitUntil([this] { return find<QWidget>("messageBar")->isHidden(); })) << "it is called off";
  press(Qt::Key_R);
  ASSERT_TRUE(waitForMessage("takes the place of pose 1"));
  press(Qt::Key_Space);
  ASSERT_TRUE(waitUntil([&] { return controller().session()->poses()[0].capture != first; }));
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(controller().liveSession().recapturing(), std::nullopt);
  ASSERT_TRUE(waitForMessage("Pose 1 captured"));
  EXPECT_TRUE(waitUntil([this] { return find<QWidget>("messageBar")->isHidden(); }))
      << "there is nothing to call off any more: " << message().toStdString();
  EXPECT_THAT(message(), Not(HasText("repeats pose 1")));
  for (int k = 0; k < 3; ++k) press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(0));
  EXPECT_FALSE(action("actionUndo")->isEnabled());
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
}

TEST_F(MainWindowTest, LiveModeShowsTheMomentUnmistakablyAndGoesBackToTheResult) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  const auto* mark = find<ViewMark>("middleMark");
  EXPECT_FALSE(mark->content().has_value());
  std::size_t moments = 0;
  std::shared_ptr<const Reconstruction> moment;
  QObject::connect(&controller().liveMode(), &LiveMode::momentSolved, window_.get(), [&](const auto& solved) {
    ++moments;
    moment = solved;
  });
  press(Qt::Key_L);
  ASSERT_TRUE(waitUntil([&] { return moments >= 5 && mark->content().has_value(); }));
  EXPECT_EQ(moment->poses.size(), 1U);
  EXPECT_EQ(moment->solver, "tree");
  EXPECT_TRUE(mark->content()->has_frame);
  EXPECT_THAT(mark->content()->words, HasText("Live"));
  EXPECT_TRUE(mark->isVisible());
  EXPECT_TRUE(find<ViewMark>("sideMark")->isVisible());

  int results = 0;
  QObject::connect(&controller(), &SessionController::reconstructionChanged, window_.get(), [&] { ++results; });
  press(Qt::Key_L);
  EXPECT_FALSE(controller().liveMode().isOn());
  EXPECT_EQ(posesShown(), 2U);
  EXPECT_EQ(results, 0) << "the result is the same as before";
  EXPECT_TRUE(waitUntil([&] { return !mark->content(); }));
  EXPECT_FALSE(mark->isVisible());
}

TEST_F(MainWindowTest, LiveModeSaysOnceThatTheMomentCanNotBeSolved) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  SolverOptions impossible;
  impossible.class_threshold = -1;
  controller().setSolverOptions(impossible);
  QSignalSpy noticed(&controller(), &SessionController::noticed);
  QSignalSpy moments(&controller().liveSession().source(), &LiveSource::previewChanged);
  controller().liveMode().setOn(true);
  ASSERT_TRUE(waitUntil([&] { return !noticed.isEmpty(); }));
  EXPECT_THAT(noticed[0][0].toString(), HasText("can't be solved"));
  const int before = moments.size();
  ASSERT_TRUE(waitUntil([&] { return moments.size() > before + 10; }));
  EXPECT_EQ(noticed.size(), 1);
}

TEST_F(MainWindowTest, WhatWasNotSavedIsInAScratchFileUntilItIsGivenUp) {
  QDir(unsavedFolder()).removeRecursively();
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_FALSE(controller().file().isKept());
  EXPECT_TRUE(controller().file().hasUnsavedChanges());
  const auto files = [] { return QDir(unsavedFolder()).entryInfoList({"*.hexo"}, QDir::Files); };
  ASSERT_TRUE(waitUntil([&] { return !controller().file().isWriting() && files().size() == 1; }));
  EXPECT_EQ(readSessionStore(files().front().filePath().toStdString()).poses().size(), 2U);
  controller().undoStack()->setClean();
  window_.reset();
  EXPECT_TRUE(files().isEmpty()) << "closed knowingly";
}

TEST_F(MainWindowTest, WhatIsPickedInTheGraphOrATableIsPickedElsewhere) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  showTab("Links");
  clickRow("linkView", 3);
  ASSERT_TRUE(window_->selection().link().has_value());
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(1)));
  EXPECT_EQ(window_->selection().cell(), CellId(1));
  EXPECT_TRUE(find<QTableView>("linkView")->selectionModel()->selectedRows().isEmpty());
  const auto* directions = window_->findChild<CoverageView*>();
  clickRow("poseView", 1);
  EXPECT_EQ(directions->pickedPose(), PoseId(2));
  find<QTableView>("poseView")->clearSelection();
  EXPECT_EQ(directions->pickedPose(), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
