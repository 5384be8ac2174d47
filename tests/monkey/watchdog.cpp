#include "tests/monkey/watchdog.h"

#include <execinfo.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
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

void writeStack(int signal) {
  constexpr int kDeepest = 64;
  void* frames[kDeepest];
  const int count = ::backtrace(frames, kDeepest);
  constexpr char kHead[] = "--- this is where it is\n";
  static_cast<void>(!::write(STDERR_FILENO, kHead, sizeof(kHead) - 1));
  ::backtrace_symbols_fd(frames, count, STDERR_FILENO);
  ::raise(signal);
}

void writeStackOn(int signal) {
  struct sigaction action {};
  action.sa_handler = &writeStack;
  action.sa_flags = SA_RESETHAND | SA_ONSTACK;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

Watchdog::Watchdog(double limit_ms)
    : limit_ms_(limit_ms),
      schedule_(QStringLiteral("/proc/thread-self/schedstat")),
      last_beat_ns_(now_ns()),
      gui_thread_(::pthread_self()) {
  // A stack for the signal handler, in case the thread's own is used up.
  static std::array<char, 256 * 1024> spare;
  stack_t stack{};
  stack.ss_sp = spare.data();
  stack.ss_size = spare.size();
  ::sigaltstack(&stack, nullptr);
  // The first call loads a library, which a signal handler must not.
  void* frame = nullptr;
  ::backtrace(&frame, 1);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) writeStackOn(signal);
  static_cast<void>(schedule_.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
  last_queued_ms_ = queued_ms();
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

double Watchdog::queued_ms() const {
  // Three figures: time on a processor, time in the queue for one, turns.
  char line[96] = {};
  if (schedule_.handle() < 0 || ::pread(schedule_.handle(), line, sizeof(line) - 1, 0) <= 0) return 0;
  return QByteArray(line).split(' ').value(1).toDouble() / kNsPerMs;
}

void Watchdog::beat() {
  const std::int64_t now = now_ns();
  const double queued = queued_ms();
  Stall stall;
  stall.wall_ms = static_cast<double>(now - last_beat_ns_) / kNsPerMs - kBeat_ms;
  stall.queue_ms = queued - last_queued_ms_;
  stall.doing = doing_before_.isEmpty() ? doing_ : doing_before_ + QStringLiteral(", then ") + doing_;
  if (stall.wall_ms > worst_.wall_ms) worst_ = stall;
  if (stall.wall_ms > limit_ms_) stalls_.push_back(stall);
  ++beats_;
  last_beat_ns_ = now;
  last_queued_ms_ = queued;
}

void Watchdog::watch() {
  while (!ending_) {
    std::this_thread::sleep_for(kGlance);
    if (static_cast<double>(now_ns() - last_beat_ns_) / kNsPerMs < kHang_ms) continue;
    const std::lock_guard lock(doing_mutex_);
    std::cerr << "monkey: the window hangs: " << doing_for_thread_.toStdString() << std::endl;
    ::pthread_kill(gui_thread_, SIGABRT);
    return;
  }
}

}  // namespace hexoderm::test
