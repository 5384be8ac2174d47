#include "app/window/log/event_log.h"

#include "app/window/files/job_queue.h"
#include "widgets/style/of_enum.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QMetaObject>
#include <QStandardPaths>
#include <algorithm>
#include <condition_variable>
#include <thread>
#include <utility>

namespace hexoderm {
namespace {

const QString kFileName = QStringLiteral("hexoderm.log");
const QString kOldFileName = QStringLiteral("hexoderm.1.log");

// A complaint that is repeated a thousand times a second must not push everything else out of the log.
constexpr std::size_t kMaxWaiting = 2 * EventLog::kCapacity;

const char* englishWord(Severity severity) { return ofEnum(severity, {"INFO   ", "WARNING", "ERROR  "}); }

}  // namespace

/// Appends lines to the file on a thread of its own.
class EventLog::Writer {
 public:
  Writer(EventLog& log, QString folder) : log_(&log), folder_(std::move(folder)) {}

  void add(const QString& line) {
    const std::lock_guard lock(mutex_);
    if (dropped_ > 0 || lines_.size() >= kMaxWaiting) {
      ++dropped_;
      return;
    }
    lines_.push_back(line);
    if (!std::exchange(busy_, true)) jobs_.addEssential([this] { writeAll(); });
  }
  bool waitUntilWritten(int timeout_ms) {
    std::unique_lock lock(mutex_);
    return written_.wait_for(lock, std::chrono::milliseconds(timeout_ms), [this] { return !busy_; });
  }
  /// The log is told nothing any more.
  void forgetLog() {
    const std::lock_guard lock(mutex_);
    log_ = nullptr;
  }

 private:
  void writeAll() {
    std::unique_lock lock(mutex_);
    while (!lines_.empty()) {
      std::deque<QString> batch = std::exchange(lines_, {});
      const std::size_t dropped = std::exchange(dropped_, 0);
      const std::size_t count = batch.size() + dropped;
      if (refused_ > 0) batch.push_front(linesAreMissing(refused_));
      if (dropped > 0) batch.push_back(linesAreMissing(dropped));
      lock.unlock();
      const QString problem = write(batch);
      lock.lock();
      refused_ = problem.isEmpty() ? 0 : refused_ + count;
      if (!problem.isEmpty()) say(problem);
    }
    busy_ = false;
    written_.notify_all();
  }

  static QString linesAreMissing(std::size_t count) {
    LogLine line;
    line.at_ms = QDateTime::currentMSecsSinceEpoch();
    line.severity = Severity::Warning;
    line.text = EventLog::tr("%1 lines are missing here: they could not be written, or came too fast").arg(count);
    return asFileLine(line);
  }

  /// Once: what comes next fails too, as a rule, and would say nothing new. With the lock.
  void say(const QString& problem) {
    if (!log_ || std::exchange(said_, true)) return;
    QMetaObject::invokeMethod(
        log_, [log = log_, problem] { emit log->fileFailed(problem); }, Qt::QueuedConnection);
  }

  /// Why it could not; empty if it could.
  QString write(const std::deque<QString>& batch) {
    const QDir folder(folder_);
    if (!folder.exists() && !QDir().mkpath(folder_)) {
      return EventLog::tr("The folder %1 can't be made.").arg(QDir::toNativeSeparators(folder_));
    }
    QByteArray bytes;
    for (const QString& line : batch) bytes += line.toUtf8() + '\n';
    const QString path = folder.filePath(kFileName);
    const QString old_path = folder.filePath(kOldFileName);
    if (QFile(path).size() + bytes.size() > kFileBytes) {
      QFile::remove(old_path);
      QFile::rename(path, old_path);
    }
    // Several windows of several processes may write it; whole lines are appended at once.
    QFile file(path);
    if (file.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered) &&
        file.write(bytes) == bytes.size()) {
      return {};
    }
    return QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(path), file.errorString());
  }

  EventLog* log_;  ///< null once it goes
  QString folder_;
  std::mutex mutex_;  ///< guards all but the folder
  std::condition_variable written_;
  std::deque<QString> lines_;
  std::size_t dropped_ = 0;  ///< later lines, which are too many
  std::size_t refused_ = 0;  ///< by the disk, before what waits
  bool said_ = false;
  bool busy_ = false;
  JobQueue jobs_{true};  // last: its thread has ended before what it uses goes
};

namespace {

/// The logs that live, the newest last: Qt's message handler is one for the whole process.
struct Handlers {
  std::mutex mutex;
  std::vector<EventLog*> logs;
  QtMessageHandler before = nullptr;
};
Handlers& handlers() {
  static Handlers instance;
  return instance;
}

Severity severityOf(QtMsgType type) {
  if (type == QtDebugMsg || type == QtInfoMsg) return Severity::Info;
  return type == QtWarningMsg ? Severity::Warning : Severity::Error;
}

}  // namespace

EventLog::EventLog(const QString& folder, QObject* parent) : QObject(parent), folder_(folder) {
  if (!folder_.isEmpty()) writer_ = std::make_unique<Writer>(*this, folder_);
  Handlers& all = handlers();
  const std::lock_guard lock(all.mutex);
  if (all.logs.empty()) all.before = qInstallMessageHandler(&EventLog::takeQtMessage);
  all.logs.push_back(this);
}

EventLog::~EventLog() {
  {
    Handlers& all = handlers();
    const std::lock_guard lock(all.mutex);
    all.logs.erase(std::find(all.logs.begin(), all.logs.end(), this));
    if (all.logs.empty()) qInstallMessageHandler(all.before);
  }
  if (!writer_) return;
  writer_->forgetLog();
  constexpr int kPatience_ms = 1000;
  // A disk that takes longer keeps the writer, and nobody else.
  if (!writer_->waitUntilWritten(kPatience_ms)) std::thread([writer = std::move(writer_)] {}).detach();
}

void EventLog::takeQtMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  // Should Qt complain about what add() does, that can't be added again.
  thread_local bool adding = false;
  if (adding) return;
  Handlers& all = handlers();
  QtMessageHandler before = nullptr;
  {
    adding = true;
    const std::lock_guard lock(all.mutex);
    before = all.before;
    if (!all.logs.empty()) all.logs.back()->add(severityOf(type), QStringLiteral("Qt: ") + text);
    adding = false;
  }
  // A fatal message ends the process in there.
  if (before) before(type, context, text);
}

void EventLog::add(Severity severity, const QString& text) {
  LogLine line;
  line.at_ms = QDateTime::currentMSecsSinceEpoch();
  line.severity = severity;
  line.text = text;
  const std::lock_guard lock(mutex_);
  line.number = ++count_;
  if (writer_) writer_->add(asFileLine(line));
  lines_.push_back(std::move(line));
  if (lines_.size() > kCapacity) lines_.pop_front();
  if (told_) return;
  told_ = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        {
          const std::lock_guard told(mutex_);
          told_ = false;
        }
        emit grown();
      },
      Qt::QueuedConnection);
}

std::vector<LogLine> EventLog::linesAfter(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  const auto first = std::upper_bound(lines_.begin(), lines_.end(), number,
                                      [](std::uint64_t value, const LogLine& line) { return value < line.number; });
  return {first, lines_.end()};
}

std::vector<LogLine> EventLog::newest(std::size_t count) const {
  const std::lock_guard lock(mutex_);
  return {lines_.end() - static_cast<std::ptrdiff_t>(std::min(count, lines_.size())), lines_.end()};
}

QString EventLog::filePath() const { return folder_.isEmpty() ? QString() : QDir(folder_).filePath(kFileName); }

bool EventLog::waitUntilWritten(int timeout_ms) const { return !writer_ || writer_->waitUntilWritten(timeout_ms); }

QString asFileLine(const LogLine& line) {
  QString text = line.text;
  text.replace(QLatin1Char('\n'), QStringLiteral(" | "));
  return QStringLiteral("%1 %2 %3")
      .arg(QDateTime::fromMSecsSinceEpoch(line.at_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz")),
           QLatin1String(englishWord(line.severity)), text);
}

QString logFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation); }

}  // namespace hexoderm
