// The log of events, in memory and in a file.
#include "app/window/log/event_log.h"
#include "hexoderm/base/file.h"
#include "tests/support/qt_wait.h"

#include <gmock/gmock.h>

#include <thread>

namespace hexoderm {
namespace {

using test::kPatience_ms;

TEST(EventLogTest, KeepsTheNewestLinesOfManyThreads) {
  EventLog log({});
  constexpr int kThreads = 4;
  constexpr int kEach = 3000;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&log] {
        for (int k = 0; k < kEach; ++k) log.add(Severity::Info, QString::number(k));
      });
    }
  }
  const std::vector<LogLine> lines = log.linesAfter(0);
  ASSERT_EQ(lines.size(), EventLog::kCapacity);
  EXPECT_EQ(lines.back().number, std::uint64_t{kThreads * kEach});
  EXPECT_EQ(lines.front().number, lines.back().number - EventLog::kCapacity + 1);
  EXPECT_EQ(log.linesAfter(lines.back().number - 3).size(), 3U);
  EXPECT_EQ(log.newest(7).front().number, lines.back().number - 6);
}

TEST(EventLogTest, TakesWhatQtComplainsAboutAsLongAsItLives) {
  std::uint64_t before = 0;
  {
    EventLog log({});
    EventLog newer({});
    qWarning("a signal was lost");
    ASSERT_EQ(newer.linesAfter(0).size(), 1U);
    EXPECT_EQ(newer.linesAfter(0)[0].text, "Qt: a signal was lost");
    EXPECT_EQ(newer.linesAfter(0)[0].severity, Severity::Warning);
    before = log.linesAfter(0).size();
  }
  EXPECT_EQ(before, 0U);
  qWarning("nobody listens, and nothing happens");
}

TEST(EventLogTest, WritesAFileThatBeginsAnewWhenItIsFull) {
  const QTemporaryDir folder;
  EventLog log(folder.filePath("logs"));
  log.add(Severity::Error, "first\nof two lines");
  ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
  EXPECT_THAT(readFile(log.filePath().toStdString()), testing::HasSubstr("ERROR   first | of two lines\n"));

  const QString long_text(1000, 'x');
  for (int k = 0; k < 1500; ++k) {
    log.add(Severity::Info, long_text);
    if (k % 100 == 0) {
      ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
    }
  }
  ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
  EXPECT_LE(QFileInfo(log.filePath()).size(), EventLog::kFileBytes);
  const QFileInfo old(QDir(log.folder()).filePath("hexoderm.1.log"));
  EXPECT_TRUE(old.exists());
  EXPECT_LE(old.size(), EventLog::kFileBytes);
}

TEST(EventLogTest, GoesOnWithoutAFileWhereNoneCanBeMade) {
  const QTemporaryDir folder;
  QFile in_the_way(folder.filePath("logs"));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  EventLog log(folder.filePath("logs"));
  QSignalSpy failed(&log, &EventLog::fileFailed);
  log.add(Severity::Info, "still here");
  ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
  log.add(Severity::Info, "and here");
  ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
  EXPECT_EQ(log.linesAfter(0).size(), 2U);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, kPatience_ms));
  QCoreApplication::processEvents();
  EXPECT_EQ(failed.size(), 1) << "said once";
  EXPECT_TRUE(failed[0][0].toString().contains("logs")) << failed[0][0].toString().toStdString();

  ASSERT_TRUE(in_the_way.remove());
  log.add(Severity::Info, "in the file again");
  ASSERT_TRUE(log.waitUntilWritten(kPatience_ms));
  EXPECT_THAT(readFile(log.filePath().toStdString()),
              testing::ContainsRegex("WARNING 2 lines are missing here(.|\n)*INFO    in the file again"));
}

}  // namespace
}  // namespace hexoderm
