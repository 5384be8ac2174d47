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

/// A time in which the GUI thread took no events. What is neither computing nor a queue is waiting: for other threads
/// (such as those that draw in software OpenGL), the display, a disk.
struct Stall {
  double wall_ms = 0;
  double cpu_ms = 0;     ///< that the GUI thread computed in it
  double others_ms = 0;  ///< that the other threads of this process computed, at the same time or not
  double queue_ms = 0;   ///< that the GUI thread was ready to compute but had no processor, as the kernel counts it
  QString doing;

  /// What other programs surely took from it: at most others_ms of the queue were behind threads of our own.
  [[nodiscard]] double load_ms() const;
};

/// Measures how long the event loop is busy with anything at a time: a heartbeat every 5 ms on the GUI thread, and a
/// thread that looks at it, so that a loop that hangs for good is seen too. Lives on the GUI thread.
class Watchdog : public QObject {
 public:
  /// A heartbeat that is later than `limit_ms` is a stall. `trace`: writes the GUI thread's stack to stderr while it
  /// stalls, from half of the limit on, again and again. A loop that hangs for half a minute ends the process; so does
  /// a crash, which writes the stack too.
  Watchdog(double limit_ms, bool trace);
  ~Watchdog() override;

  /// What is done from now on; named with the stalls that come.
  void setDoing(const QString& doing);

  [[nodiscard]] const std::vector<Stall>& stalls() const { return stalls_; }
  [[nodiscard]] const Stall& worst() const { return worst_; }  ///< of those and of the shorter ones
  [[nodiscard]] std::uint64_t beats() const { return beats_; }

 private:
  void beat();
  void watch();

  /// Of the GUI thread, of all threads, in the queue; since they began.
  struct Times {
    std::int64_t cpu_ns = 0;
    std::int64_t process_ns = 0;
    std::int64_t queue_ns = 0;
  };
  [[nodiscard]] Times times() const;

  double limit_ms_;
  bool trace_;
  QTimer heart_;
  QFile schedule_;
  Times last_;
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
