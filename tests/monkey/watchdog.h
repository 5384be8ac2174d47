#pragma once

#include <QFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace hexoderm::test {

/// A time in which the GUI thread took no events, and what went on in it as the kernel counts it.
struct Stall {
  double wall_ms = 0;
  double cpu_ms = 0;            ///< computing time of the GUI thread
  double queue_ms = 0;          ///< time in which the GUI thread was ready but had no processor
  double drawing_ms = 0;        ///< computing time of the busiest thread that draws in software OpenGL
  double drawing_queue_ms = 0;  ///< time in which such a thread was ready but had no processor, at most
  double others_ms = 0;         ///< computing time of all other threads of this process
  double stolen_ms = 0;         ///< time that a virtual machine's host took away, of the processor that it took longest
  QString doing;

  /// Upper bound of the stall's length on an otherwise idle machine: computing time one after another (only the threads
  /// that draw work side by side), and the time in which the GUI thread waited for anything but them, such as the
  /// display or a disk. Only delays by other programs are left out; stolen time is not.
  [[nodiscard]] double alone_ms() const;
  /// Length of the stall if the machine had had all its processors; never less than its computing time.
  [[nodiscard]] double unstolen_ms() const;
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

  /// Names the present activity, for the stalls that follow.
  void setDoing(const QString& doing);

  [[nodiscard]] const std::vector<Stall>& stalls() const { return stalls_; }
  [[nodiscard]] const Stall& worst() const { return worst_; }  ///< the longest, even if shorter than the limit
  [[nodiscard]] std::uint64_t beats() const { return beats_; }

 private:
  void beat();
  void watch();

  /// Times of one thread since it began.
  struct Turns {
    double cpu_ms = 0;
    double queue_ms = 0;
  };
  static Turns turnsOf(const QFile& schedule);
  /// From each processor since the machine was started.
  static std::vector<double> stolenFrom_ms(const QFile& processors);
  void findDrawingThreads();

  double limit_ms_;
  bool trace_;
  QTimer heart_;
  QFile schedule_;
  QFile processors_;
  std::vector<std::unique_ptr<QFile>> drawing_schedules_;
  double last_cpu_ms_ = 0;
  double last_process_ms_ = 0;
  double last_queue_ms_ = 0;
  std::vector<double> last_stolen_ms_;
  std::vector<Turns> last_drawing_;
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
