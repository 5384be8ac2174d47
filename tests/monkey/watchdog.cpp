#include "watchdog.h"

#include <execinfo.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace hexoderm::test {
namespace {

constexpr int kBeat_ms = 5;
constexpr auto kGlance = std::chrono::milliseconds(2);
constexpr double kHang_ms = 30000;
constexpr double kNsPerMs = 1e6;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::int64_t clock_ns(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void writeStack(int signal) {
  constexpr int kDeepest = 64;
  void* frames[kDeepest];
  const int count = ::backtrace(frames, kDeepest);
  constexpr char kHead[] = "--- this is where it is\n";
  static_cast<void>(!::write(STDERR_FILENO, kHead, sizeof(kHead) - 1));
  ::backtrace_symbols_fd(frames, count, STDERR_FILENO);
  if (signal == SIGUSR1) return;
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

void writeStackOn(int signal) {
  struct sigaction action {};
  action.sa_handler = &writeStack;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

double Stall::load_ms() const { return std::max(0.0, queue_ms - others_ms); }

Watchdog::Watchdog(double limit_ms, bool trace)
    : limit_ms_(limit_ms),
      trace_(trace),
      schedule_(QStringLiteral("/proc/thread-self/schedstat")),
      last_beat_ns_(now_ns()),
      gui_thread_(::pthread_self()) {
  // The first call loads a library, which a signal handler must not.
  void* frame = nullptr;
  ::backtrace(&frame, 1);
  for (const int signal : {SIGUSR1, SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) writeStackOn(signal);
  // Where the kernel does not count, nothing is taken for a queue.
  static_cast<void>(schedule_.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
  last_ = times();
  heart_.setTimerType(Qt::PreciseTimer);
  heart_.setInterval(kBeat_ms);
  connect(&heart_, &QTimer::timeout, this, &Watchdog::beat);
  heart_.start();
  thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
  ending_ = true;
  thread_.join();
}

void Watchdog::setDoing(const QString& doing) {
  doing_before_ = std::exchange(doing_, doing);
  const std::lock_guard lock(doing_mutex_);
  doing_for_thread_ = doing;
}

Watchdog::Times Watchdog::times() const {
  Times times;
  times.cpu_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID);
  times.process_ns = clock_ns(CLOCK_PROCESS_CPUTIME_ID);
  // Three figures: time on a processor, time in the queue for one, turns.
  char line[96] = {};
  if (schedule_.handle() >= 0 && ::pread(schedule_.handle(), line, sizeof(line) - 1, 0) > 0) {
    long long on_processor = 0;
    long long in_queue = 0;
    if (std::sscanf(line, "%lld %lld", &on_processor, &in_queue) == 2) times.queue_ns = in_queue;
  }
  return times;
}

void Watchdog::beat() {
  const std::int64_t now = now_ns();
  const Times times = this->times();
  const std::int64_t cpu_ns = times.cpu_ns - last_.cpu_ns;
  Stall stall;
  stall.wall_ms = static_cast<double>(now - last_beat_ns_) / kNsPerMs - kBeat_ms;
  stall.cpu_ms = static_cast<double>(cpu_ns) / kNsPerMs;
  stall.others_ms = static_cast<double>(times.process_ns - last_.process_ns - cpu_ns) / kNsPerMs;
  stall.queue_ms = static_cast<double>(times.queue_ns - last_.queue_ns) / kNsPerMs;
  stall.doing = doing_before_.isEmpty() ? doing_ : doing_before_ + QStringLiteral(", then ") + doing_;
  if (stall.wall_ms > worst_.wall_ms) worst_ = stall;
  if (stall.wall_ms > limit_ms_) stalls_.push_back(stall);
  ++beats_;
  last_ = times;
  last_beat_ns_ = now;
}

void Watchdog::watch() {
  std::int64_t traced_beat = 0;
  double next_trace_ms = 0;
  while (!ending_) {
    std::this_thread::sleep_for(kGlance);
    const std::int64_t beat = last_beat_ns_;
    const double silent_ms = static_cast<double>(now_ns() - beat) / kNsPerMs;
    if (beat != traced_beat) {
      traced_beat = beat;
      next_trace_ms = limit_ms_ / 2;
    }
    if (trace_ && silent_ms > next_trace_ms) {
      next_trace_ms = silent_ms + limit_ms_ / 4;
      {
        const std::lock_guard lock(doing_mutex_);
        std::cerr << "--- after " << silent_ms << " ms, doing: " << doing_for_thread_.toStdString() << std::endl;
      }
      ::pthread_kill(gui_thread_, SIGUSR1);
    }
    if (silent_ms > kHang_ms) {
      const std::lock_guard lock(doing_mutex_);
      std::cerr << "monkey: the window hangs: " << doing_for_thread_.toStdString() << std::endl;
      std::abort();
    }
  }
}

}  // namespace hexoderm::test
