#pragma once

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
  double cpu_ms = 0;   ///< that the GUI thread computed in it
  double load_ms = 0;  ///< for which not even a sleeping thread of this process got its turn: the machine was busy
  QString doing;
};

/// Measures how long the event loop is busy with anything at a time: a heartbeat every 5 ms on the GUI thread, and a
/// thread that looks at it, so that a loop that hangs for good is seen too. Lives on the GUI thread.
class Watchdog : public QObject {
 public:
  /// A heartbeat that is later than `limit_ms` is a stall. `trace`: writes the GUI thread's stack to stderr while it
  /// stalls. A loop that hangs for half a minute ends the process; so does a crash, which writes the stack too.
  Watchdog(double limit_ms, bool trace);
  ~Watchdog() override;

  /// What is done from now on; named with the stalls that come.
  void setDoing(const QString& doing);

  [[nodiscard]] const std::vector<Stall>& stalls() const { return stalls_; }
  [[nodiscard]] const Stall& worst() const { return worst_; }
  [[nodiscard]] std::uint64_t beats() const { return beats_; }

 private:
  void beat();
  void watch();

  double limit_ms_;
  bool trace_;
  QTimer heart_;
  std::int64_t last_cpu_ns_ = 0;
  std::int64_t last_load_ns_ = 0;
  std::uint64_t beats_ = 0;
  std::vector<Stall> stalls_;
  Stall worst_;
  QString doing_;
  QString doing_before_;
  std::atomic<std::int64_t> last_beat_ns_;
  std::atomic<std::int64_t> load_ns_{0};
  std::atomic<bool> ending_{false};
  std::mutex doing_mutex_;
  QString doing_for_thread_;
  pthread_t gui_thread_;
  std::thread thread_;
};

}  // namespace hexoderm::test
