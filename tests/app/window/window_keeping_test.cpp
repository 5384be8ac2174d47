// Sessions that are undone, saved and connected in any order are whole in their files, and nothing of one skin is left
// for the next.

#include "tests/app/window/presenters/presenter_test.h"
#include "tests/support/failing_disk.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/hold_ring.h"

namespace hexoderm {
namespace {

std::vector<std::uint32_t> poseIds(const Session& session) {
  std::vector<std::uint32_t> ids;
  for (const SessionPose& pose : session.poses()) ids.push_back(pose.capture->id.value());
  return ids;
}

class WindowKeepingTest : public PresenterTest {
 protected:
  void TearDown() override {
    window_.reset();
    PresenterTest::TearDown();
    QFile::remove(unsavedFolder());
  }

  /// The scratch file of a session that came from NAME.session.json; empty if there is none.
  static QString scratchOf(const QString& name) {
    const QFileInfoList files = QDir(unsavedFolder()).entryInfoList({name + "-*.hexo"}, QDir::Files);
    return files.isEmpty() ? QString() : files.front().absoluteFilePath();
  }
  bool waitUntilWritten() {
    return waitUntil([this] { return controller().work().activity().isEmpty() && !controller().file().isWriting(); });
  }
};

TEST_F(WindowKeepingTest, APoseThatWasDeletedBeforeTheScratchFileComesBackInItToo) {
  ASSERT_NO_FATAL_FAILURE(openSession("three.session.json", simulated(3)));
  QSignalSpy noticed(&controller(), &SessionController::noticed);
  clickRow("poseView", 1);
  press(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitUntilWritten());
  const QString scratch = scratchOf("three");
  ASSERT_FALSE(scratch.isEmpty());
  EXPECT_THAT(poseIds(read(scratch)), ElementsAre(1U, 3U));
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(3));
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_TRUE(noticed.isEmpty()) << noticed.front().front().toString().toStdString();
  ASSERT_EQ(scratchOf("three"), scratch);
  EXPECT_THAT(poseIds(read(scratch)), ElementsAre(1U, 2U, 3U));
}

TEST_F(WindowKeepingTest, WhatIsUndoneAfterSavingIsUndoneInTheFile) {
  ASSERT_NO_FATAL_FAILURE(openSession("three.session.json", simulated(3)));
  clickRow("poseView", 0);
  press(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(2));
  const QString path = pathTo("kept.hexo");
  controller().file().saveSession(path);
  ASSERT_TRUE(waitUntil([this] { return controller().file().isKept(); }));
  QSignalSpy failed(&controller(), &SessionController::failed);
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(3));
  controller().setPoseDisabled(2, true);
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_TRUE(failed.isEmpty());
  const Session kept = read(path);
  ASSERT_THAT(poseIds(kept), ElementsAre(1U, 2U, 3U));
  EXPECT_TRUE(kept.poses()[2].disabled) << "the pose that is meant, and no other";
}

TEST_F(WindowKeepingTest, ASessionGetsItsScratchFileAlthoughTheOneBeforeGotNone) {
  ASSERT_TRUE(QDir().mkpath(QFileInfo(unsavedFolder()).absolutePath()));
  QFile in_the_way(unsavedFolder());
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  ASSERT_NO_FATAL_FAILURE(openSession("first.session.json", simulated(2)));
  controller().setPoseDisabled(0, true);
  ASSERT_TRUE(waitForMessage("kept in memory only"));
  ASSERT_TRUE(in_the_way.remove());
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_EQ(scratchOf("first"), QString()) << "it was said to be kept in memory only";

  // The window would ask about the first.
  controller().file().openFile(writeSession("second.session.json", simulated(2)));
  ASSERT_TRUE(waitUntil([this] { return controller().file().name() == "second.session.json"; }));
  ASSERT_TRUE(waitForPoses(2));
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntilWritten());
  ASSERT_FALSE(scratchOf("second").isEmpty());
  EXPECT_TRUE(read(scratchOf("second")).poses()[1].disabled);
}

TEST_F(WindowKeepingTest, WhatChangesBetweenTwoSavesIsInBothFiles) {
  ASSERT_NO_FATAL_FAILURE(openSession("four.session.json", simulated(4)));
  const QString first = pathTo("first.hexo");
  const QString second = pathTo("second.hexo");
  // Nothing is saved before the event loop runs again.
  controller().file().saveSession(first);
  controller().setPoseDisabled(0, true);
  controller().file().saveSession(second);
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntil([&] { return controller().file().sessionPath() == second; }));
  controller().setPoseDisabled(2, true);
  ASSERT_TRUE(waitUntilWritten());
  const auto disabled = [](const Session& session) {
    std::vector<std::uint32_t> ids;
    for (const SessionPose& pose : session.poses()) {
      if (pose.disabled) ids.push_back(pose.capture->id.value());
    }
    return ids;
  };
  EXPECT_THAT(disabled(read(second)), ElementsAre(1U, 2U, 3U));
  EXPECT_THAT(disabled(read(first)), ElementsAre(1U, 2U)) << "until the second file took over";
}

TEST_F(WindowKeepingTest, RingToneAndStatusSayCapturedWhenThePoseIsOnDiskAndNotBefore) {
  LiveSession& live = controller().liveSession();
  live.setAutomatic(false);
  window_->connectTo({"sim:x17?speed=20", pathTo("arm.hexo")});
  ASSERT_TRUE(waitForPoses(0));
  ASSERT_TRUE(waitUntilWritten());
  const auto* ring = find<HoldRing>("holdRing");
  QObject listener;
  std::vector<ToneKind> tones;
  QObject::connect(window_->findChild<CaptureTone*>(), &CaptureTone::played, &listener,
                   [&](ToneKind kind) { tones.push_back(kind); });
  // The window's own part hears of it first.
  QString word_while_written;
  QObject::connect(&live, &LiveSession::poseTaken, &listener, [&] { word_while_written = ring->content().word; });
  bool is_ring_captured = false;
  QObject::connect(&live, &LiveSession::poseKept, &listener, [&] { is_ring_captured = ring->content().captured; });
  bool was_captured_too_early = false;
  const auto saysCaptured = [&] {
    return ring->content().captured || labelText("saidStatus").contains("captured") || message().contains("captured") ||
           std::ranges::count(tones, ToneKind::Captured) > 0;
  };
  {
    const test::NoFileGrows full;
    QObject::connect(
        &live.source(), &LiveSource::holdChanged, &listener, [&, before = controller().session()->poses().size()] {
          const bool on_disk = !controller().file().hasUnsavedChanges() && !controller().file().isWriting();
          if (controller().session()->poses().size() > before && !on_disk && saysCaptured()) {
            was_captured_too_early = true;
          }
        });
    press(Qt::Key_Space);
    ASSERT_TRUE(waitForMessage("Not on disk yet"));
    EXPECT_EQ(controller().session()->poses().size(), 1U);
    ASSERT_TRUE(waitForPoses(1)) << "the work goes on";
    EXPECT_EQ(word_while_written, "Writing");
    EXPECT_EQ(labelText("savedStatus"), "not on disk");
    EXPECT_FALSE(saysCaptured()) << labelText("saidStatus").toStdString() << message().toStdString();
    EXPECT_FALSE(is_ring_captured);
    EXPECT_EQ(read(pathTo("arm.hexo")).poses().size(), 0U);
  }
  click(find<QPushButton>("messageButton"));
  ASSERT_TRUE(waitUntil([&] { return std::ranges::count(tones, ToneKind::Captured) == 1; }));
  EXPECT_TRUE(is_ring_captured);
  EXPECT_EQ(labelText("saidStatus"), "Pose 1 captured: 17 cells.");
  EXPECT_FALSE(was_captured_too_early);
  EXPECT_EQ(read(pathTo("arm.hexo")).poses().size(), 1U);
}

TEST_F(WindowKeepingTest, TheNextSkinIsAskedNothingThatTheLastWasAsked) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().file().saveSession(pathTo("arm.hexo"));
  ASSERT_TRUE(waitUntil([this] { return controller().file().isKept(); }));
  controller().liveSession().setRobot(true);
  controller().liveMode().setOn(true);
  controller().liveSession().lightCell(CellId(3));
  ASSERT_TRUE(controller().liveSession().isRobotOn() && controller().liveMode().isOn() &&
              controller().liveSession().litCell());
  // A skin that is never there.
  ConnectRequest request;
  request.address = "replay:" + pathTo("none.skinrec");
  request.continue_session = true;
  controller().liveSession().connectTo(request);
  EXPECT_FALSE(controller().liveSession().isRobotOn());
  EXPECT_FALSE(controller().liveMode().isOn());
  EXPECT_EQ(controller().liveSession().litCell(), std::nullopt);
  ASSERT_TRUE(waitUntil([this] { return !controller().liveSession().source().isRunning(); }));
  EXPECT_FALSE(action("actionLiveMode")->isChecked());
}

TEST_F(WindowKeepingTest, ATurnByHandEndsTheRobotsRunForAllToSee) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().liveSession().setRobot(true);
  ASSERT_TRUE(waitUntil([this] { return action("actionRobot")->isChecked(); }));
  controller().liveSession().turnTo(Eigen::Vector3d::UnitX());
  EXPECT_FALSE(controller().liveSession().isRobotOn());
  EXPECT_TRUE(waitUntil([this] { return !action("actionRobot")->isChecked(); }));
}

}  // namespace
}  // namespace hexoderm
