// Recordings that are not what they should be: what is whole is played, and what is wrong is said with the file's name.

#include "hexoderm/device/skinwire/codec.h"
#include "tests/app/window/recorded_skin.h"
#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

constexpr std::uint64_t kCells = 17;
constexpr qint64 kMagic = 8;
constexpr qint64 kHead = 12;  // head of a record

/// Position of a record in the file, and the number of frames in it.
struct Record {
  qint64 begin = 0;
  qint64 end = 0;
  std::uint64_t frames = 0;
};

class WindowRecordingTest : public WindowTest {
 protected:
  /// Six seconds of a skin on a table: one pose, which is captured in the second of them.
  void record() {
    ASSERT_NO_FATAL_FAILURE(recordSkin("sim:x17?speed=20", pathTo("whole.skinrec").toStdString(), 6000));
    QFile file(pathTo("whole.skinrec"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    content_ = file.readAll();
    qint64 at = kMagic;
    for (RecordingReader reader(pathTo("whole.skinrec").toStdString()); const auto record = reader.next();) {
      const skinwire::Decoded decoded = skinwire::decodeBody(record->body);
      const auto* samples = std::get_if<skinwire::Samples>(&decoded.message);
      const qint64 end = at + kHead + static_cast<qint64>(record->body.size());
      records_.push_back({at, end, samples == nullptr ? 0 : samples->ticks()});
      at = end;
    }
    ASSERT_EQ(at, content_.size());
    ASSERT_GE(frames(), 6000U);
  }
  [[nodiscard]] std::uint64_t frames(std::size_t first_records) const {
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < first_records; ++k) sum += records_[k].frames;
    return sum;
  }
  [[nodiscard]] std::uint64_t frames() const { return frames(records_.size()); }
  void play(const QString& path) {
    ASSERT_NO_FATAL_FAILURE(connectByDialog("Recording", path + "?speed=max", pathTo("arm.hexo")));
  }

  QByteArray content_;
  std::vector<Record> records_;
};

TEST_F(WindowRecordingTest, OneThatWasDamagedAndCutOffIsPlayedAsFarAsItIsWhole) {
  ASSERT_NO_FATAL_FAILURE(record());
  const std::size_t whole = 3 * records_.size() / 4;
  const Record& damaged = records_[records_.size() / 2];
  ASSERT_GT(damaged.frames, 0U);
  content_[static_cast<int>(damaged.end - 8)] = static_cast<char>(content_[static_cast<int>(damaged.end - 8)] ^ 0x10);
  const QString path = writeFile("cut.skinrec", content_.left(static_cast<int>(records_[whole].end - 5)));
  ASSERT_NO_FATAL_FAILURE(play(path));
  ASSERT_TRUE(waitUntil([this] { return labelText("liveState") == "Ended"; }));
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().liveSession().source().status().frames, frames(whole) - damaged.frames);
  EXPECT_EQ(controller().reconstruction()->cellCount(), kCells);
  const QString said =
      QStringLiteral("%1: is cut off; all before byte %2 was played").arg(path).arg(records_[whole].begin);
  EXPECT_EQ(labelText("liveText"), said);
  EXPECT_TRUE(find<QLabel>("liveText")->isVisible());
  EXPECT_FALSE(action("actionCapture")->isEnabled());
  EXPECT_TRUE(action("actionCapture")->toolTip().contains("cut.skinrec"))
      << action("actionCapture")->toolTip().toStdString();
  EXPECT_TRUE(labelText("liveCounters").contains("1 broken")) << labelText("liveCounters").toStdString();
  EXPECT_EQ(labelText("lossesStatus"), QStringLiteral("%1 samples lost").arg(damaged.frames * kCells));
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
TEST_F(WindowBrokenRecordingTest, WhatIsNoRecordingIsRefusedInWords) {
  ASSERT_NO_FATAL_FAILURE(openSession("open.hexo", simulated(2)));
  ASSERT_NO_FATAL_FAILURE(play(writeFile("noise.skinrec", QByteArray(5000, '#'))));
  ASSERT_TRUE(waitForMessage("noise.skinrec"));
  EXPECT_TRUE(message().contains("is no recording of a skin")) << message().toStdString();
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
    EXPECT_TRUE(labelText("liveText").contains("without.skinrec")) << labelText("liveText").toStdString();
    EXPECT_EQ(labelText("liveState"), "Ended");
    EXPECT_TRUE(find<QWidget>("liveStrip")->isVisible());
    EXPECT_FALSE(labelText("bannerSentence").contains("Waiting")) << labelText("bannerSentence").toStdString();
    EXPECT_TRUE(labelText("bannerSentence").contains("without.skinrec")) << labelText("bannerSentence").toStdString();
    EXPECT_EQ(find<QPushButton>("bannerButton")->text(), "Disconnect");
    keepPicture(window_->picture(), "recording-without-a-skin");
    clickBanner();
    EXPECT_FALSE(controller().liveSession().source().isRunning());
    ASSERT_NO_FATAL_FAILURE(expectTheSessionStays());
  }
}

}  // namespace
}  // namespace hexoderm
