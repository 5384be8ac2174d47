#pragma once

#include <QFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace hexoderm::test {

/// A time in which the GUI thread took no events.
struct Stall {
  double wall_ms = 0;
  double queue_ms = 0;  ///< of it, the time in which the GUI thread was ready but had no processor
  QString doing;
};

/// Measures how long the event loop is busy with anything at a time: a heartbeat every 5 ms on the GUI thread, and a
/// thread that looks at it, so that a loop that hangs for good is seen too. Lives on the GUI thread.
class Watchdog : public QObject {
 public:
  /// A heartbeat that is later than `limit_ms` is a stall. A loop that hangs for half a minute ends the process, as
  /// does a crash; both write the stack of the thread to stderr.
  explicit Watchdog(double limit_ms);
  ~Watchdog() override;

  /// Names the present activity, for the stalls that follow.
  void setDoing(const QString& doing);

  [[nodiscard]] const std::vector<Stall>& stalls() const { return stalls_; }
  [[nodiscard]] const Stall& worst() const { return worst_; }  ///< the longest, even if shorter than the limit
  [[nodiscard]] std::uint64_t beats() const { return beats_; }

 private:
  void beat();
  void watch();
  /// Since the thread of `schedule_` began; zero where the kernel does not count it.
  [[nodiscard]] double queued_ms() const;

  double limit_ms_;
  QTimer heart_;
  QFile schedule_;
  double last_queued_ms_ = 0;
  std::uint64_t beats_ = 0;
  std::vector<Stall> stalls_;
  Stall worst_;
  QString doing_;
  QString doing_before_;
  std::atomic<std::int64_t> last_beat_ns_;
  std::atomic<bool> ending_{false};
  std::mutex doing_mutex_;
  QString doing_for_thread_;
  pthread_t gui_thread_;
  std::thread thread_;
};

}  // namespace hexoderm::test
