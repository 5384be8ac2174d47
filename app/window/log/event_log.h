#pragma once

#include "hexoderm/base/finding.h"

#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace hexoderm {

/// One thing that the program did, or said to the operator.
struct LogLine {
  std::uint64_t number = 0;  ///< 1, 2, 3, ... as they came
  std::int64_t at_ms = 0;    ///< milliseconds since 1970, UTC
  Severity severity = Severity::Info;
  QString text;
};

/// The events since the program was started, to be read in the window and to be sent with a report of a bug: the newest
/// kCapacity lines in memory, and all of them in a file that starts over at kFileBytes and keeps the one before. If
/// lines can't be in the file, because the disk refuses or is too slow, the file tells how many are missing. add() may
/// be called from any thread while the log lives, and never waits for the disk; everything else belongs to the thread
/// of this object. While it lives it also takes the messages of Qt and VTK (qInstallMessageHandler); if there are
/// several logs, the newest one does.
class EventLog : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kCapacity = 10000;
  static constexpr std::int64_t kFileBytes = 1 << 20;

  /// `folder`: where the file is kept; it is made. Empty: no file.
  explicit EventLog(const QString& folder, QObject* parent = nullptr);
  /// Writes what is left; waits for the disk at most a second.
  ~EventLog() override;

  void add(Severity severity, const QString& text);

  /// The lines in memory after the line of that number; 0: all. Oldest first.
  [[nodiscard]] std::vector<LogLine> linesAfter(std::uint64_t number) const;
  [[nodiscard]] std::vector<LogLine> newest(std::size_t count) const;

  /// Empty without a file.
  [[nodiscard]] QString folder() const { return folder_; }
  [[nodiscard]] QString filePath() const;
  /// Waits until every line added so far was written or could not be; false if that takes longer. For tests.
  bool waitUntilWritten(int timeout_ms) const;

 signals:
  /// Emitted at most once per turn of the event loop.
  void grown();
  /// Said once: the file can't be written, and why.
  void fileFailed(const QString& why);

 private:
  class Writer;
  static void takeQtMessage(QtMsgType type, const QMessageLogContext& context, const QString& text);

  QString folder_;
  std::unique_ptr<Writer> writer_;

  mutable std::mutex mutex_;  ///< guards what follows
  std::deque<LogLine> lines_;
  std::uint64_t count_ = 0;
  bool told_ = false;  ///< grown() is on its way
};

/// "2026-11-21 19:23:47.123 WARNING The disk is full": local time, one line whatever the text holds.
QString asFileLine(const LogLine& line);
/// The folder of the program's log.
QString logFolder();

}  // namespace hexoderm
