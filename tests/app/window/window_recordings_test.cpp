// Recordings that are not what they should be: what is whole is played, and what is wrong is said with the file's name.

#include "tests/app/window/recorded_skin.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

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
