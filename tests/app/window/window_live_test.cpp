#include "hexoderm/device/sources/wire_source.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/app/window/window_test.h"
#include "tests/support/failing_disk.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/patch/patch_view.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QTcpServer>
#include <QTcpSocket>

namespace hexoderm {
namespace {

/// A skin that turns within moments.
const QString kQuickSkin = QStringLiteral("sim:x17?speed=20");

class WindowLiveTest : public WindowTest {
 protected:
  /// Fills in the dialog as a person does; what it is about is left to the test.
  QDialog* openConnectDialog(const QString& kind, const QString& address) {
    press(Qt::Key_K, Qt::ControlModifier);
    auto* dialog = waitForDialog<QDialog>("connectDialog");
    if (dialog == nullptr) return nullptr;
    dialog->findChild<QComboBox*>("connectKind")->setCurrentText(kind);
    auto* edit = dialog->findChild<QComboBox*>("connectAddress")->lineEdit();
    edit->selectAll();
    QTest::keyClicks(edit, address);
    return dialog;
  }
  void connectQuickSkin(const QString& path) {
    window_->connectTo({kQuickSkin, path});
    ASSERT_TRUE(waitForPoses(1)) << message().toStdString();
  }
  static Session read(const QString& path) { return readSessionStore(path.toStdString()); }
  /// Waits until nothing waits to be written any more.
  bool waitUntilKept() {
    return waitUntil([this] {
      return controller().file().isKept() && !controller().file().isWriting() &&
             !controller().file().hasUnsavedChanges();
    });
  }
  QString writeSimulatedStore(const QString& name, std::size_t poses) {
    SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
    writeSessionStore(simulateSession(skin, poses), pathTo(name).toStdString());
    return pathTo(name);
  }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

TEST_F(WindowLiveTest, ASimulatedSkinIsConnectedAndEveryPoseIsInItsFile) {
  QDialog* dialog = openConnectDialog("Simulated skin", "x17?speed=20");
  ASSERT_NE(dialog, nullptr);
  const QString path = pathTo("arm.hexo");
  dialog->findChild<QLineEdit*>("connectPath")->setText(path);
  keepPicture(dialog->grab().toImage(), "connect-light");
  click(dialog->findChild<QPushButton*>("connectButton"));
  ASSERT_TRUE(waitForPoses(1)) << message().toStdString();
  EXPECT_EQ(controller().file().name(), "arm.hexo");
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  EXPECT_EQ(text("liveState"), "Streaming");
  EXPECT_FALSE(find<QWidget>("liveStrip")->isVisible()) << "nothing is wrong, and the step's panel says more";
  EXPECT_TRUE(text("sourceStatus").contains("Streaming")) << text("sourceStatus").toStdString();
  ASSERT_TRUE(waitForMessage("Pose 1 captured")) << message().toStdString();

  EXPECT_EQ(find<QPushButton>("bannerButton")->text(), "Let the robot take the poses");
  press(Qt::Key_A);
  ASSERT_NO_FATAL_FAILURE(turnBy([this] { press(Qt::Key_T); }));
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(2)) << message().toStdString();
  ASSERT_TRUE(waitForMessage("Pose 2 captured")) << message().toStdString();
  EXPECT_EQ(controller().reconstruction()->assessment.level, VerdictLevel::Usable);
  keepPicture(window_->picture(), "live-light");
  action("actionThemeDark")->trigger();
  keepPicture(window_->picture(), "live-dark");

  action("actionDisconnect")->trigger();
  EXPECT_TRUE(waitUntil([this] { return !action("actionCapture")->isEnabled(); }));
  EXPECT_FALSE(find<QWidget>("liveStrip")->isVisible());
  EXPECT_EQ(posesShown(), 2U);
  EXPECT_EQ(action("actionCapture")->toolTip(), "No skin is connected");
  EXPECT_EQ(text("captureWhat"), "No skin is connected.");
  EXPECT_EQ(text("captureWait"), "No skin is connected, so no pose can be taken.");
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 2U);
  EXPECT_EQ(read(path).neighbors(), controller().session()->neighbors());
}

TEST_F(WindowLiveTest, SpaceCapturesAtOnceAndWhatIsUndoneIsUndoneInTheFileToo) {
  const QString path = pathTo("arm.hexo");
  ASSERT_NO_FATAL_FAILURE(connectQuickSkin(path));
  press(Qt::Key_A);
  EXPECT_FALSE(controller().liveSession().isAutomatic());
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(2)) << message().toStdString();
  EXPECT_TRUE(waitForMessage("It repeats pose 1")) << message().toStdString();
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 1U);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(2));
  clickRow("poseView", 0);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  clickRow("poseView", 1);
  press(Qt::Key_Delete, Qt::ShiftModifier);
  ASSERT_TRUE(waitForPoses(1));
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitUntilKept());
  const Session kept = read(path);
  ASSERT_EQ(kept.poses().size(), 2U);
  EXPECT_TRUE(kept.poses()[0].disabled);
  EXPECT_EQ(kept.poses()[1].capture->id, PoseId(2));
}

TEST_F(WindowLiveTest, AWrongAddressIsRefusedInWords) {
  QDialog* dialog = openConnectDialog("Network, TCP", "localhost");
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->findChild<QPushButton*>("connectButton")->isEnabled());
  const QString note = dialog->findChild<QLabel*>("connectNote")->text();
  EXPECT_TRUE(note.contains("tcp://HOST:PORT")) << note.toStdString();
  QTest::keyClicks(dialog->findChild<QComboBox*>("connectAddress")->lineEdit(), ":7700");
  EXPECT_TRUE(dialog->findChild<QPushButton*>("connectButton")->isEnabled());

  auto* path = dialog->findChild<QLineEdit*>("connectPath");
  path->setText(writeFile("taken.hexo", "something"));
  EXPECT_FALSE(dialog->findChild<QPushButton*>("connectButton")->isEnabled()) << "nothing is replaced";
  path->setText(pathTo("arm.session.json"));
  EXPECT_FALSE(dialog->findChild<QPushButton*>("connectButton")->isEnabled());
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([&] { return window_->findChild<QDialog*>("connectDialog") == nullptr; }));
  EXPECT_FALSE(controller().liveSession().source().isRunning());
}

TEST_F(WindowLiveTest, TheAddressOfALargeSkinIsCheckedAsItIsTyped) {
  QDialog* dialog = openConnectDialog("Simulated skin", "sheet:99x99");
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->findChild<QPushButton*>("connectButton")->isEnabled());
  QTest::keyClicks(dialog->findChild<QComboBox*>("connectAddress")->lineEdit(), "99");
  EXPECT_FALSE(dialog->findChild<QPushButton*>("connectButton")->isEnabled());
  const QString note = dialog->findChild<QLabel*>("connectNote")->text();
  EXPECT_TRUE(note.contains("100000 cells")) << note.toStdString();
}

TEST_F(WindowLiveTest, ADeviceThatIsNotThereIsSaidAndItsAddressCanBeCorrectedOrGivenUp) {
  // Nobody listens at port 1.
  ASSERT_NO_FATAL_FAILURE(connectByDialog("Network, TCP", "127.0.0.1:1", pathTo("arm.hexo")));
  ASSERT_TRUE(waitUntil([this] { return text("liveText").contains("refused"); })) << text("liveText").toStdString();
  EXPECT_EQ(text("liveState"), "Connecting");
  EXPECT_TRUE(text("sourceStatus").contains("Connecting")) << text("sourceStatus").toStdString();
  keepPicture(window_->picture(), "live-refused");
  // Every wait is longer than the one before; those of more than a second are counted down.
  for (const char* left : {"next try in 2 s", "next try in 1 s"}) {
    ASSERT_TRUE(waitUntil([&] { return text("liveText").contains(left); })) << text("liveText").toStdString();
  }
  EXPECT_EQ(find<QPushButton>("bannerButton")->text(), "Correct the address…");
  clickBanner();
  auto* dialog = waitForDialog<QDialog>("connectDialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->findChild<QComboBox*>("connectAddress")->currentText(), "127.0.0.1:1");
  dialog->reject();
  ASSERT_TRUE(waitUntil([this] { return window_->findChild<QDialog*>("connectDialog") == nullptr; }));
  EXPECT_TRUE(controller().liveSession().source().isRunning());
  click(find<QPushButton>("liveDisconnect"));
  EXPECT_FALSE(controller().liveSession().source().isRunning());
  EXPECT_FALSE(QFile::exists(pathTo("arm.hexo"))) << "nothing was captured";
}

TEST_F(WindowLiveTest, LossesAndSilenceOfADeviceAreSaid) {
  QTcpServer server;
  ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
  window_->connectTo({QStringLiteral("tcp://127.0.0.1:%1").arg(server.serverPort()), pathTo("arm.hexo"), false});
  ASSERT_TRUE(waitUntil([&] { return server.hasPendingConnections(); }));
  QTcpSocket* device = server.nextPendingConnection();
  device->write(
      "{\"hello\": {\"device\": \"my skin\", \"cell_model\": \"hex-bma150\"}}\n"
      "{\"topology\": {\"id\": 1, \"cells\": [{\"id\": 1, \"ports\": [{\"port\": 2, \"cell\": 2, \"cell_port\": 3}]},"
      " {\"id\": 2, \"ports\": [{\"port\": 3, \"cell\": 1, \"cell_port\": 2}]}]}}\n");
  // Until the window has shown it, however busy the computer is.
  ASSERT_TRUE(waitUntil([&, k = 0]() mutable {
    device->write(QStringLiteral("{\"samples\": {\"sequence\": %1, \"time_us\": %2, \"cells\": [1, 2], "
                                 "\"acceleration_g\": [0, 0, 1, 0, 0, 1]}}\n")
                      .arg(2 * k + (k < 40 ? 0 : 6))
                      .arg(10000 * k)
                      .toUtf8());
    ++k;
    device->flush();
    return text("liveState") == "Streaming" && text("lossesStatus") == "6 samples lost";
  })) << text("liveText").toStdString()
      << text("lossesStatus").toStdString();
  EXPECT_TRUE(find<QLabel>("lossesStatus")->isVisible());
  QElapsedTimer timer;
  timer.start();
  ASSERT_TRUE(waitUntil([this] { return text("liveState") == "Silent"; })) << text("liveText").toStdString();
  // A busy computer may show it late; when it is said is the source's, and that leaves a fifth of the second.
  EXPECT_LE(WireOptions().silent_after, std::chrono::milliseconds(800));
  RecordProperty("silent_shown_after_ms", static_cast<int>(timer.elapsed()));
  device->abort();
  server.close();
  ASSERT_TRUE(waitUntil([this] { return text("liveState") == "Connecting"; })) << text("liveText").toStdString();
  EXPECT_NE(controller().session(), nullptr) << "the session stays";
}

TEST_F(WindowLiveTest, APoseThatLacksReadingsIsTakenAgainByTheButtonOnTop) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const Session whole = simulateSession(skin, 5);
  Session session(whole.model(), whole.neighbors());
  for (const SessionPose& pose : whole.poses()) {
    auto capture = std::make_shared<PoseCapture>(*pose.capture);
    const bool is_last = session.poses().size() + 1 == whole.poses().size();
    if (!is_last) std::erase_if(capture->samples, [](const GravitySample& s) { return s.cell == CellId(7); });
    session.addPose({std::move(capture), false});
  }
  writeSessionStore(session, pathTo("arm.hexo").toStdString());
  window_->openFile(pathTo("arm.hexo"));
  ASSERT_TRUE(waitForPoses(5));
  const Assessment& assessment = controller().reconstruction()->assessment;
  ASSERT_EQ(assessment.remedy, Remedy::RetakePoses) << assessment.reason.english();
  ASSERT_EQ(assessment.retake.front(), PoseId(1));
  EXPECT_FALSE(action("actionRetake")->isEnabled());
  EXPECT_EQ(action("actionRetake")->toolTip(), "No skin is connected");

  controller().liveSession().setAutomatic(false);
  window_->connectTo({kQuickSkin, {}, true});
  auto* button = find<QPushButton>("bannerButton");
  ASSERT_TRUE(waitUntil([&] { return button->text() == "Take pose 1 again"; })) << button->text().toStdString();
  ASSERT_NO_FATAL_FAILURE(turnBy([&] { click(button); }));
  EXPECT_EQ(controller().liveSession().recapturing(), PoseId(1));
  EXPECT_EQ(button->text(), "Don't take pose 1 again");
  const auto before = controller().session()->poses()[0].capture;
  press(Qt::Key_Space);
  ASSERT_TRUE(waitUntil([&] { return controller().session()->poses()[0].capture != before; }));
  ASSERT_TRUE(waitForPoses(5));
  EXPECT_EQ(controller().session()->poses()[0].capture->id, PoseId(1));
  EXPECT_EQ(controller().session()->poses()[0].capture->samples.size(), 17U);
  ASSERT_TRUE(waitUntil([&] { return button->text() == "Take pose 2 again"; })) << button->text().toStdString();
  click(button);
  EXPECT_EQ(controller().liveSession().recapturing(), PoseId(2));
  click(button);
  EXPECT_EQ(controller().liveSession().recapturing(), std::nullopt);
}

TEST_F(WindowLiveTest, WhatCanNotBeWrittenWaitsUntilItCan) {
  const QString path = pathTo("later/arm.hexo");
  window_->connectTo({kQuickSkin, path, false});
  ASSERT_TRUE(waitForPoses(1)) << message().toStdString();
  ASSERT_TRUE(waitForMessage("arm.hexo")) << message().toStdString();
  EXPECT_TRUE(controller().file().hasUnsavedChanges());
  EXPECT_EQ(text("savedStatus"), "not on disk");
  EXPECT_EQ(find<QPushButton>("messageButton")->text(), "Try again");
  keepPicture(window_->picture(), "live-stuck");
  ASSERT_TRUE(QDir(folder_.path()).mkdir("later"));
  click(find<QPushButton>("messageButton"));
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  EXPECT_EQ(read(path).poses().size(), 1U);
}

TEST_F(WindowLiveTest, AFullDiskLosesNoPose) {
  const QString path = pathTo("arm.hexo");
  ASSERT_NO_FATAL_FAILURE(connectQuickSkin(path));
  ASSERT_TRUE(waitForMessage("Pose 1 captured")) << message().toStdString();
  {
    const test::NoFileGrows full;
    press(Qt::Key_Space);
    ASSERT_TRUE(waitForMessage("Not on disk yet")) << message().toStdString();
    EXPECT_EQ(controller().session()->poses().size(), 2U);
    EXPECT_TRUE(controller().file().hasUnsavedChanges());
    EXPECT_EQ(read(path).poses().size(), 1U) << "what was captured before is intact";
  }
  // The next change tries again too, and the message goes.
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 2U);
}

TEST_F(WindowLiveTest, ConnectionsMayEndAtAnyMoment) {
  for (int k = 0; k < 9; ++k) {
    window_->connectTo({kQuickSkin, pathTo(QStringLiteral("arm%1.hexo").arg(k)), false});
    if (k % 3 == 1) QCoreApplication::processEvents();
    if (k % 2 == 1) controller().liveSession().disconnectSource();
  }
  ASSERT_NO_FATAL_FAILURE(connectQuickSkin(pathTo("last.hexo")));
  EXPECT_EQ(controller().file().name(), "last.hexo");
  press(Qt::Key_Space);
  window_.reset();
  EXPECT_GE(read(pathTo("last.hexo")).poses().size(), 1U);
}

TEST_F(WindowLiveTest, CaptureGoesOnInAnUnfinishedSession) {
  const QString path = writeSimulatedStore("unfinished.hexo", 1);
  window_->openFile(path);
  ASSERT_TRUE(waitForPoses(1));
  clickRow("poseView", 0);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  ASSERT_TRUE(waitUntilKept());
  EXPECT_TRUE(read(path).poses()[0].disabled) << "the file is kept up without saving";

  window_->connectTo({"sim:ring8?speed=20", {}, true});
  ASSERT_TRUE(waitForMessage("other cells")) << message().toStdString();
  EXPECT_FALSE(controller().liveSession().source().isRunning());

  window_->connectTo({kQuickSkin, {}, true});
  ASSERT_TRUE(waitForPoses(2)) << message().toStdString();
  EXPECT_EQ(controller().session()->poses()[1].capture->id, PoseId(2));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 2U);
}

TEST_F(WindowLiveTest, ASessionThatIsOpenElsewhereIsReadAndSaysSo) {
  const QString path = writeSimulatedStore("arm.hexo", 2);
  const SessionStore elsewhere = SessionStore::open(path.toStdString());
  window_->openFile(path);
  ASSERT_TRUE(waitForPoses(2));
  ASSERT_TRUE(waitForMessage("will not be kept in this file")) << message().toStdString();
  EXPECT_FALSE(controller().file().isKept());
}

TEST_F(WindowLiveTest, TheDemoCanBeSavedAsASessionThatKeepsEveryChange) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(0));
  press(Qt::Key_S, Qt::ControlModifier);
  const QString path = pathTo("demo.hexo");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 1U);
  EXPECT_NE(read(path).truth(), nullptr);
}

TEST_F(WindowLiveTest, ASkinThatFallsSilentIsToldAboveTheRobotAndItsLastReadingsGo) {
  QTcpServer server;
  ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
  window_->connectTo({QStringLiteral("tcp://127.0.0.1:%1").arg(server.serverPort()), pathTo("arm.hexo"), false});
  ASSERT_TRUE(waitUntil([&] { return server.hasPendingConnections(); }));
  QTcpSocket* device = server.nextPendingConnection();
  device->write(
      "{\"hello\": {\"device\": \"my robot\", \"cell_model\": \"hex-bma150\", \"can_turn\": true}}\n"
      "{\"topology\": {\"id\": 1, \"cells\": [{\"id\": 1, \"ports\": [{\"port\": 2, \"cell\": 2, \"cell_port\": 3}]},"
      " {\"id\": 2, \"ports\": [{\"port\": 3, \"cell\": 1, \"cell_port\": 2}]}]}}\n");
  auto* stillness = find<StillnessView>("stillnessView");
  auto* patch = window_->findChild<PatchView*>();
  ASSERT_TRUE(stillness && patch);
  // Until the robot is at work and its readings are shown.
  ASSERT_TRUE(waitUntil([&, tick = 0]() mutable {
    device->write(QStringLiteral("{\"samples\": {\"time_us\": %1, \"cells\": [1, 2], "
                                 "\"acceleration_g\": [0, 0, 1, 0, 0, 1]}}\n")
                      .arg(10000 * tick++)
                      .toUtf8());
    device->flush();
    QAction* robot = action("actionRobot");
    if (robot->isEnabled() && !robot->isChecked()) robot->trigger();
    return !stillness->trace().points().empty() && patch->moment().readings &&
           text("bannerSentence").startsWith("The robot is taking pose");
  })) << text("bannerSentence").toStdString();

  ASSERT_TRUE(waitUntil([this] { return text("bannerSentence").startsWith("The skin does not send any more"); }))
      << text("bannerSentence").toStdString();
  EXPECT_TRUE(controller().poseGuide().isRobotOn()) << "it goes on when the skin does";
  EXPECT_EQ(find<QPushButton>("bannerButton")->text(), action("actionConnect")->iconText());
  EXPECT_TRUE(stillness->trace().points().empty());
  EXPECT_EQ(patch->moment().readings, nullptr);
  EXPECT_FALSE(patch->moment().up_o.has_value());
  click(find<QPushButton>("bannerButton"));
  auto* dialog = waitForDialog<QDialog>("connectDialog");
  ASSERT_NE(dialog, nullptr);
  dialog->reject();
}

}  // namespace
}  // namespace hexoderm
