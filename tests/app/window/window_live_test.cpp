// Skins that are connected: simulated, on a wire, and recordings, whole and broken.

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/device/sources/wire_source.h"
#include "tests/app/window/fake_device.h"
#include "tests/app/window/window_test.h"
#include "tests/support/changed_session.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/patch/patch_view.h"

namespace hexoderm {
namespace {

/// A skin that turns within moments.
const QString kQuickSkin = "sim:x17?speed=20";

class WindowLiveTest : public WindowTest {
 protected:
  /// Fills in the dialog as a person does; what it is about is left to the test.
  QDialog* openConnectDialog(const QString& kind, const QString& address) {
    press(Qt::Key_K, Qt::ControlModifier);
    auto* dialog = waitForDialog("connectDialog");
    dialog->findChild<QComboBox*>("connectKind")->setCurrentText(kind);
    typeInto(dialog->findChild<QComboBox*>("connectAddress")->lineEdit(), address);
    return dialog;
  }
  void connectQuickSkin(const QString& path) {
    window_->connectTo({kQuickSkin, path});
    ASSERT_TRUE(waitForPoses(1));
  }
  void connectDevice(bool can_turn = false) {
    window_->connectTo({device_.address(), pathTo("arm.hexo"), false});
    ASSERT_NO_FATAL_FAILURE(device_.accept());
    device_.introduce(can_turn);
  }

  FakeDevice device_;
};

TEST_F(WindowLiveTest, ASimulatedSkinIsConnectedAndWhenItIsGoneTheStepSaysSo) {
  controller().liveSession().setAutomatic(false);
  QDialog* dialog = openConnectDialog("Simulated skin", "x17?speed=20");
  const QString path = pathTo("arm.hexo");
  dialog->findChild<QLineEdit*>("connectPath")->setText(path);
  click(dialog->findChild<QPushButton*>("connectButton"));
  ASSERT_TRUE(waitUntil([this] { return controller().liveSession().isLive(); }));
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().file().name(), "arm.hexo");
  EXPECT_EQ(bannerButton(), "Let the robot take the poses");

  action("actionDisconnect")->trigger();
  EXPECT_TRUE(waitUntil([this] { return !action("actionCapture")->isEnabled(); }));
  EXPECT_EQ(action("actionCapture")->toolTip(), "No skin is connected");
  EXPECT_EQ(labelText("captureWhat"), "No skin is connected.");
  EXPECT_EQ(labelText("captureWait"), "No skin is connected, so no pose can be taken.");
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 1U);
  EXPECT_EQ(read(path).neighbors(), controller().session()->neighbors());
}

TEST_F(WindowLiveTest, AWrongAddressIsRefusedInWordsAsItIsTyped) {
  QDialog* dialog = openConnectDialog("Network, TCP", "localhost");
  auto* address = dialog->findChild<QComboBox*>("connectAddress")->lineEdit();
  const auto* button = dialog->findChild<QPushButton*>("connectButton");
  const auto expectRefused = [&](const QString& reason) {
    EXPECT_FALSE(button->isEnabled()) << reason.toStdString();
    const QString note = dialog->findChild<QLabel*>("connectNote")->text();
    EXPECT_THAT(note, HasText(reason));
  };
  expectRefused("tcp://HOST:PORT");
  QTest::keyClicks(address, ":7700");
  EXPECT_TRUE(button->isEnabled());
  auto* path = dialog->findChild<QLineEdit*>("connectPath");
  path->setText(writeFile("taken.hexo", "something"));
  EXPECT_FALSE(button->isEnabled()) << "nothing is replaced";
  path->setText(pathTo("arm.session.json"));
  EXPECT_FALSE(button->isEnabled());
  path->setText(pathTo("arm.hexo"));

  auto* kind = dialog->findChild<QComboBox*>("connectKind");
  kind->setCurrentText("Simulated skin");
  typeInto(address, "sheet:99x99");
  EXPECT_TRUE(button->isEnabled());
  QTest::keyClicks(address, "99");
  expectRefused("100000 cells");
  kind->setCurrentText("Recording");
  typeInto(address, pathTo("no.skinrec"));
  expectRefused("no.skinrec");
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntilGone("connectDialog"));
  EXPECT_FALSE(controller().liveSession().source().isRunning());
}

TEST_F(WindowLiveTest, ADeviceThatIsNotThereIsSaidAndItsAddressCanBeCorrectedOrGivenUp) {
  // Nobody listens at port 1.
  ASSERT_NO_FATAL_FAILURE(connectByDialog("Network, TCP", "127.0.0.1:1", pathTo("arm.hexo")));
  ASSERT_TRUE(waitUntil([this] { return labelText("liveText").contains("refused"); }));
  EXPECT_EQ(labelText("liveState"), "Connecting");
  EXPECT_THAT(labelText("sourceStatus"), HasText("Connecting"));
  keepPicture(window_->picture(), "live-refused");
  // Every wait is longer than the one before; those of more than a second are counted down.
  for (const char* left : {"next try in 2 s", "next try in 1 s"}) {
    ASSERT_TRUE(waitUntil([&] { return labelText("liveText").contains(left); }));
  }
  EXPECT_EQ(bannerButton(), "Correct the address…");
  clickBanner();
  auto* dialog = waitForDialog("connectDialog");
  EXPECT_EQ(dialog->findChild<QComboBox*>("connectAddress")->currentText(), "127.0.0.1:1");
  dialog->reject();
  ASSERT_TRUE(waitUntilGone("connectDialog"));
  EXPECT_TRUE(controller().liveSession().source().isRunning());
  click(find<QPushButton>("liveDisconnect"));
  EXPECT_FALSE(controller().liveSession().source().isRunning());
  EXPECT_FALSE(QFile::exists(pathTo("arm.hexo"))) << "nothing was captured";
}

TEST_F(WindowLiveTest, LossesAndSilenceOfADeviceAreSaid) {
  ASSERT_NO_FATAL_FAILURE(connectDevice());
  // Until the window has shown it, however busy the computer is.
  ASSERT_TRUE(waitUntil([this, times = 0]() mutable {
    device_.lose(++times == 10 ? 6 : 0);
    device_.hold(0.1, Eigen::Vector3d::UnitZ());
    return labelText("liveState") == "Streaming" && labelText("lossesStatus") == "6 samples lost";
  })) << labelText("lossesStatus").toStdString();
  EXPECT_TRUE(find<QLabel>("lossesStatus")->isVisible());
  device_.fallSilent();
  ASSERT_TRUE(waitUntil([this] { return labelText("liveState") == "Silent"; }));
  // A busy computer may show it late; when it is said is the source's, and that leaves a fifth of the second.
  EXPECT_LE(WireOptions().silent_after, std::chrono::milliseconds(800));
  device_.unplug();
  ASSERT_TRUE(waitUntil([this] { return labelText("liveState") == "Connecting"; }));
  EXPECT_NE(controller().session(), nullptr) << "the session stays";
}

TEST_F(WindowLiveTest, APoseThatLacksReadingsIsTakenAgainByTheButtonOnTop) {
  const auto without_7 = [](std::size_t pose, PoseCapture& capture) {
    if (pose < 4) std::erase_if(capture.samples, [](const GravitySample& s) { return s.cell == CellId(7); });
  };
  ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", withCaptures(simulated(5, {}, 100), without_7)));
  const Assessment& assessment = controller().reconstruction()->assessment;
  ASSERT_EQ(assessment.remedy, Remedy::RetakePoses) << assessment.reason.english();
  ASSERT_EQ(assessment.retake.front(), PoseId(1));
  expectDisabled("actionRetake", "No skin is connected");

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
  const QString path = writeSession("unfinished.hexo", simulated(1, {}, 100));
  ASSERT_NO_FATAL_FAILURE(openFile(path));
  ASSERT_NO_FATAL_FAILURE(disablePose(0));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_TRUE(read(path).poses()[0].disabled) << "the file is kept up without saving";

  window_->connectTo({"sim:ring8?speed=20", {}, true});
  ASSERT_TRUE(waitForMessage("other cells"));
  EXPECT_FALSE(controller().liveSession().source().isRunning());

  window_->connectTo({kQuickSkin, {}, true});
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(controller().session()->poses()[1].capture->id, PoseId(2));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 2U);
}

TEST_F(WindowLiveTest, WhatCanNotBeWrittenWaitsUntilItCan) {
  const QString path = pathTo("later/arm.hexo");
  ASSERT_NO_FATAL_FAILURE(connectQuickSkin(path));
  ASSERT_TRUE(waitForMessage("arm.hexo"));
  EXPECT_EQ(labelText("savedStatus"), "not on disk");
  ASSERT_TRUE(QDir(folder_.path()).mkdir("later"));
  click(find<QPushButton>("messageButton"));
  ASSERT_TRUE(waitForMessage("Saved to " + path));
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  EXPECT_EQ(read(path).poses().size(), 1U);
}

TEST_F(WindowLiveTest, TheDemoCanBeSavedAsASessionThatKeepsEveryChange) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(0));
  press(Qt::Key_S, Qt::ControlModifier);
  const QString path = pathTo("demo.hexo");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path));
  press(Qt::Key_Space);
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(read(path).poses().size(), 1U);
  EXPECT_NE(read(path).truth(), nullptr);
}

TEST_F(WindowLiveTest, ASkinThatFallsSilentIsToldAboveTheRobotAndItsLastReadingsGo) {
  ASSERT_NO_FATAL_FAILURE(connectDevice(true));
  auto* stillness = find<StillnessView>("stillnessView");
  auto* patch = window_->findChild<PatchView*>();
  ASSERT_TRUE(stillness && patch);
  // Until the robot is at work and its readings are shown.
  ASSERT_TRUE(waitUntil([&] {
    device_.hold(0.02, Eigen::Vector3d::UnitZ());
    QAction* robot = action("actionRobot");
    if (robot->isEnabled() && !robot->isChecked()) robot->trigger();
    return !stillness->trace().points().empty() && patch->moment().readings &&
           labelText("bannerSentence").startsWith("The robot is taking pose");
  })) << labelText("bannerSentence").toStdString();

  device_.fallSilent();
  ASSERT_TRUE(waitUntil([this] { return labelText("bannerSentence").startsWith("The skin does not send any more"); }));
  EXPECT_TRUE(controller().liveSession().isRobotOn()) << "it goes on when the skin does";
  EXPECT_EQ(bannerButton(), action("actionConnect")->iconText());
  EXPECT_TRUE(stillness->trace().points().empty());
  EXPECT_EQ(patch->moment().readings, nullptr);
  EXPECT_FALSE(patch->moment().up_o.has_value());
  click(find<QPushButton>("bannerButton"));
  auto* dialog = waitForDialog("connectDialog");
  dialog->reject();
}

/// Records a simulated skin until it has sent so many frames or a few more.
void recordSkin(const std::string& address, const std::filesystem::path& path, int frames) {
  struct Counter final : SkinListener {
    void onSkin(const SkinDescription& /*skin*/) override {}
    void onFrame(const SampleFrame& /*frame*/) override { ++count; }
    void onStatus(const SourceStatus& /*status*/) override {}
    void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}
    std::atomic<int> count = 0;
  } counter;
  StreamRecorder recorder(path, counter);
  const auto source = openSkinSource(address);
  source->start(recorder);
  EXPECT_TRUE(test::waitUntil([&] { return counter.count >= frames; }));
  source->stop();
  recorder.finish();
}

class WindowRecordingTest : public WindowTest {
 protected:
  void play(const QString& path) {
    ASSERT_NO_FATAL_FAILURE(connectByDialog("Recording", path + "?speed=max", pathTo("arm.hexo")));
  }
};

// What is lost of a recording is for the tests of its reader to count.
TEST_F(WindowRecordingTest, OneThatWasCutOffIsPlayedAsFarAsItIsWhole) {
  // Six seconds of a skin on a table: one pose, which is captured in the second of them.
  ASSERT_NO_FATAL_FAILURE(recordSkin("sim:x17?speed=20", pathTo("whole.skinrec").toStdString(), 6000));
  const QByteArray content = contentOf(pathTo("whole.skinrec"));
  const QString path = writeFile("cut.skinrec", content.left(content.size() * 3 / 4));
  ASSERT_NO_FATAL_FAILURE(play(path));
  ASSERT_TRUE(waitUntil([this] { return labelText("liveState") == "Ended"; }));
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  EXPECT_THAT(labelText("liveText"), BeginsWith(path + ": is cut off; all before byte "));
  EXPECT_TRUE(find<QLabel>("liveText")->isVisible());
  expectDisabled("actionCapture", "cut.skinrec");
  keepPicture(window_->picture(), "recording-cut-off");

  click(find<QPushButton>("liveDisconnect"));
  EXPECT_FALSE(controller().liveSession().source().isRunning());
  EXPECT_EQ(posesShown(), 1U);
  ASSERT_TRUE(waitUntil([this] { return controller().file().isKept() && !controller().file().isWriting(); }));
  EXPECT_EQ(readSessionStore(pathTo("arm.hexo").toStdString()).poses().size(), 1U);
}

/// With a session open, which must stay.
class WindowBrokenRecordingTest : public WindowRecordingTest {
 protected:
  void expectTheSessionStays() {
    EXPECT_EQ(controller().file().name(), "open.hexo");
    EXPECT_EQ(posesShown(), 2U);
    EXPECT_TRUE(controller().file().isKept());
    EXPECT_FALSE(QFile::exists(pathTo("arm.hexo")));
  }
};

// What a recording can lack in full is for the tests of its reader to find.
TEST_F(WindowBrokenRecordingTest, WhatIsNoRecordingIsRefusedText) {
  ASSERT_NO_FATAL_FAILURE(openSession("open.hexo", simulated(2)));
  ASSERT_NO_FATAL_FAILURE(play(writeFile("noise.skinrec", QByteArray(5000, '#'))));
  ASSERT_TRUE(waitForMessage("noise.skinrec"));
  EXPECT_THAT(message(), HasText("is no recording of a skin"));
  EXPECT_TRUE(find<QWidget>("messageBar")->isVisible()) << "it stays until somebody has read it";
  EXPECT_FALSE(controller().liveSession().source().isRunning());
  EXPECT_FALSE(find<QWidget>("liveStrip")->isVisible());
  ASSERT_NO_FATAL_FAILURE(expectTheSessionStays());
}

TEST_F(WindowBrokenRecordingTest, OneInWhichThereIsNoSkinEndsAndIsNotWaitedFor) {
  ASSERT_NO_FATAL_FAILURE(openSession("open.hexo", simulated(2)));
  const std::pair<const char*, QByteArray> endings[] = {
      {"byte 8: a record says that it has", "SKINREC1" + QByteArray(5000, '#')},
      {"the recording is over", "SKINREC1"},
  };
  for (const auto& [said, content] : endings) {
    ASSERT_NO_FATAL_FAILURE(play(writeFile("without.skinrec", content)));
    ASSERT_TRUE(waitUntil([this, part = said] { return labelText("liveText").contains(part); }));
    EXPECT_THAT(labelText("liveText"), HasText("without.skinrec"));
    EXPECT_EQ(labelText("liveState"), "Ended");
    EXPECT_TRUE(find<QWidget>("liveStrip")->isVisible());
    EXPECT_THAT(labelText("bannerSentence"), Not(HasText("Waiting")));
    EXPECT_THAT(labelText("bannerSentence"), HasText("without.skinrec"));
    EXPECT_EQ(bannerButton(), "Disconnect");
    keepPicture(window_->picture(), "recording-without-a-skin");
    clickBanner();
    EXPECT_FALSE(controller().liveSession().source().isRunning());
    ASSERT_NO_FATAL_FAILURE(expectTheSessionStays());
  }
}

}  // namespace
}  // namespace hexoderm
