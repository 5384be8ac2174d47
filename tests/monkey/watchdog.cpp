#include "watchdog.h"

#include <execinfo.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
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

std::int64_t cpuOfThisThread_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
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

Watchdog::Watchdog(double limit_ms, bool trace)
    : limit_ms_(limit_ms), trace_(trace), last_beat_ns_(now_ns()), gui_thread_(::pthread_self()) {
  // The first call loads a library, which a signal handler must not.
  void* frame = nullptr;
  ::backtrace(&frame, 1);
  for (const int signal : {SIGUSR1, SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) writeStackOn(signal);
  last_cpu_ns_ = cpuOfThisThread_ns();
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

void Watchdog::beat() {
  const std::int64_t now = now_ns();
  const std::int64_t cpu = cpuOfThisThread_ns();
  const std::int64_t load = load_ns_;
  Stall stall;
  stall.wall_ms = static_cast<double>(now - last_beat_ns_) / kNsPerMs - kBeat_ms;
  stall.cpu_ms = static_cast<double>(cpu - last_cpu_ns_) / kNsPerMs;
  stall.load_ms = static_cast<double>(load - last_load_ns_) / kNsPerMs;
  stall.doing = doing_before_.isEmpty() ? doing_ : doing_before_ + QStringLiteral(", then ") + doing_;
  if (stall.wall_ms > worst_.wall_ms) worst_ = stall;
  if (stall.wall_ms > limit_ms_) stalls_.push_back(stall);
  ++beats_;
  last_beat_ns_ = now;
  last_cpu_ns_ = cpu;
  last_load_ns_ = load;
}

void Watchdog::watch() {
  std::int64_t reported_beat = 0;
  while (!ending_) {
    const std::int64_t before = now_ns();
    std::this_thread::sleep_for(kGlance);
    const std::int64_t now = now_ns();
    const std::int64_t late =
        now - before - std::chrono::duration_cast<std::chrono::nanoseconds>(kGlance).count() - 1'000'000;
    if (late > 0) load_ns_ += late;
    const std::int64_t beat = last_beat_ns_;
    const double silent_ms = static_cast<double>(now - beat) / kNsPerMs;
    if (trace_ && silent_ms > limit_ms_ + kBeat_ms && beat != reported_beat) {
      reported_beat = beat;
      {
        const std::lock_guard lock(doing_mutex_);
        std::cerr << "--- doing: " << doing_for_thread_.toStdString() << std::endl;
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
