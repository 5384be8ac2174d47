// Sessions that are undone, saved and connected in any order are whole in their files, and nothing of one skin is left
// for the next.
#include "app/window/files/session_paths.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> poseIds(const Session& session) {
  std::vector<std::uint32_t> ids;
  for (const SessionPose& pose : session.poses()) ids.push_back(pose.capture->id.value());
  return ids;
}

class WindowKeepingTest : public WindowTest {
 protected:
  void SetUp() override {
    QDir(unsavedFolder()).removeRecursively();
    QFile::remove(unsavedFolder());
    WindowTest::SetUp();
  }
  void TearDown() override {
    window_.reset();
    QDir(unsavedFolder()).removeRecursively();
    QFile::remove(unsavedFolder());
  }

  static Session simulated(std::size_t poses) {
    SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
    return simulateSession(skin, poses, 20);
  }
  void open(const QString& name, const Session& session) {
    const std::string path = pathTo(name).toStdString();
    name.endsWith(".hexo") ? writeSessionStore(session, path) : writeSessionJson(session, path);
    controller().openFile(pathTo(name));
    ASSERT_TRUE(waitUntil([&] { return controller().name() == name; })) << message().toStdString();
    ASSERT_TRUE(waitForPoses(session.poses().size())) << message().toStdString();
  }
  static Session read(const QString& path) { return readSessionStore(path.toStdString()); }
  /// The scratch file of a session that came from NAME.session.json; empty if there is none.
  static QString scratchOf(const QString& name) {
    const QFileInfoList files = QDir(unsavedFolder()).entryInfoList({name + "-*.hexo"}, QDir::Files);
    return files.isEmpty() ? QString() : files.front().absoluteFilePath();
  }
  bool waitUntilWritten() {
    return waitUntil([this] { return controller().activity().isEmpty() && !controller().isWriting(); });
  }
};

TEST_F(WindowKeepingTest, APoseThatWasDeletedBeforeTheScratchFileComesBackInItToo) {
  ASSERT_NO_FATAL_FAILURE(open("three.session.json", simulated(3)));
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
  ASSERT_NO_FATAL_FAILURE(open("three.session.json", simulated(3)));
  clickRow("poseView", 0);
  press(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(2));
  const QString path = pathTo("kept.hexo");
  controller().saveSession(path);
  ASSERT_TRUE(waitUntil([this] { return controller().isKept(); }));
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

TEST_F(WindowKeepingTest, ACaptureThatWasUndoneBeforeSavingComesBackInTheFile) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(1));
  const QString path = pathTo("kept.hexo");
  controller().saveSession(path);
  ASSERT_TRUE(waitUntil([this] { return controller().isKept(); }));
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_THAT(poseIds(read(path)), ElementsAre(1U, 2U));
}

TEST_F(WindowKeepingTest, ASessionGetsItsScratchFileAlthoughTheOneBeforeGotNone) {
  ASSERT_TRUE(QDir().mkpath(QFileInfo(unsavedFolder()).absolutePath()));
  QFile in_the_way(unsavedFolder());
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  ASSERT_NO_FATAL_FAILURE(open("first.session.json", simulated(2)));
  controller().setPoseDisabled(0, true);
  ASSERT_TRUE(waitForMessage("kept in memory only")) << message().toStdString();
  ASSERT_TRUE(in_the_way.remove());
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_EQ(scratchOf("first"), QString()) << "it was said to be kept in memory only";

  ASSERT_NO_FATAL_FAILURE(open("second.session.json", simulated(2)));
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntilWritten());
  ASSERT_FALSE(scratchOf("second").isEmpty());
  EXPECT_TRUE(read(scratchOf("second")).poses()[1].disabled);
}

TEST_F(WindowKeepingTest, WhatChangesBetweenTwoSavesIsInBothFiles) {
  ASSERT_NO_FATAL_FAILURE(open("four.session.json", simulated(4)));
  const QString first = pathTo("first.hexo");
  const QString second = pathTo("second.hexo");
  // Nothing is saved before the event loop runs again.
  controller().saveSession(first);
  controller().setPoseDisabled(0, true);
  controller().saveSession(second);
  controller().setPoseDisabled(1, true);
  ASSERT_TRUE(waitUntil([&] { return controller().sessionPath() == second; }));
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

TEST_F(WindowKeepingTest, AReasonComesBackWithWhatItIsFor) {
  Session session = simulated(2);
  session.setPoseDisabled(0, true, "someone leaned on the arm");
  ASSERT_NO_FATAL_FAILURE(open("why.hexo", session));
  controller().setPoseDisabled(0, false);
  controller().undoStack()->undo();
  EXPECT_EQ(controller().session()->poses()[0].why_disabled, "someone leaned on the arm");
  ASSERT_TRUE(waitUntilWritten());
  EXPECT_TRUE(read(pathTo("why.hexo")).poses()[0].disabled);
  EXPECT_EQ(read(pathTo("why.hexo")).poses()[0].why_disabled, "someone leaned on the arm");
}

TEST_F(WindowKeepingTest, TheNextSkinIsAskedNothingThatTheLastWasAsked) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().saveSession(pathTo("arm.hexo"));
  ASSERT_TRUE(waitUntil([this] { return controller().isKept(); }));
  controller().setRobot(true);
  controller().setLiveMode(true);
  controller().lightCell(CellId(3));
  ASSERT_TRUE(controller().isRobotOn() && controller().isLiveMode() && controller().litCell());
  // A skin that is never there.
  ConnectRequest request;
  request.address = QStringLiteral("replay:") + pathTo("none.skinrec");
  request.continue_session = true;
  controller().connectTo(request);
  EXPECT_FALSE(controller().isRobotOn());
  EXPECT_FALSE(controller().isLiveMode());
  EXPECT_EQ(controller().litCell(), std::nullopt);
  ASSERT_TRUE(waitUntil([this] { return !controller().live().isRunning(); }));
  EXPECT_FALSE(action("actionLiveMode")->isChecked());
}

TEST_F(WindowKeepingTest, ATurnByHandEndsTheRobotsRunForAllToSee) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().setRobot(true);
  ASSERT_TRUE(action("actionRobot")->isChecked());
  controller().turnTo(Eigen::Vector3d::UnitX());
  EXPECT_FALSE(controller().isRobotOn());
  EXPECT_FALSE(action("actionRobot")->isChecked());
}

}  // namespace
}  // namespace hexoderm
