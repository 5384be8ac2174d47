#include "tests/monkey/watchdog.h"

#include <execinfo.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include <QDir>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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

double clock_ms(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / kNsPerMs;
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
  action.sa_flags = SA_RESTART | SA_ONSTACK;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

double Stall::alone_ms() const {
  const double waiting_ms = wall_ms - cpu_ms - queue_ms;
  // A drawing thread may as well have queued while the GUI thread did not wait for it.
  const double waiting_for_queue_ms = std::max(0.0, drawing_queue_ms - cpu_ms - queue_ms);
  const double elsewhere_ms = std::max(0.0, waiting_ms - drawing_ms - waiting_for_queue_ms);
  return std::min(wall_ms, cpu_ms + drawing_ms + others_ms + elsewhere_ms);
}

double Stall::unstolen_ms() const { return std::max(wall_ms - stolen_ms, cpu_ms); }

Watchdog::Watchdog(double limit_ms, bool trace)
    : limit_ms_(limit_ms),
      trace_(trace),
      schedule_(QStringLiteral("/proc/thread-self/schedstat")),
      processors_(QStringLiteral("/proc/stat")),
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
  for (const int signal : {SIGUSR1, SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) writeStackOn(signal);
  // If the kernel does not count it, queueing time is zero.
  static_cast<void>(schedule_.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
  last_cpu_ms_ = clock_ms(CLOCK_THREAD_CPUTIME_ID);
  last_process_ms_ = clock_ms(CLOCK_PROCESS_CPUTIME_ID);
  last_queue_ms_ = turnsOf(schedule_).queue_ms;
  static_cast<void>(processors_.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
  last_stolen_ms_ = stolenFrom_ms(processors_);
  findDrawingThreads();
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

Watchdog::Turns Watchdog::turnsOf(const QFile& schedule) {
  // Three figures: time on a processor, time in the queue for one, turns.
  char line[96] = {};
  long long cpu_ns = 0;
  long long queue_ns = 0;
  if (schedule.handle() < 0 || ::pread(schedule.handle(), line, sizeof(line) - 1, 0) <= 0 ||
      std::sscanf(line, "%lld %lld", &cpu_ns, &queue_ns) != 2) {
    return {};
  }
  return {static_cast<double>(cpu_ns) / kNsPerMs, static_cast<double>(queue_ns) / kNsPerMs};
}

std::vector<double> Watchdog::stolenFrom_ms(const QFile& processors) {
  std::vector<double> stolen_ms;
  char text[4096] = {};
  if (processors.handle() < 0 || ::pread(processors.handle(), text, sizeof(text) - 1, 0) <= 0) return stolen_ms;
  static const double kMsPerTick = 1e3 / static_cast<double>(::sysconf(_SC_CLK_TCK));
  // "cpu" is all of them, "cpu0", "cpu1" and so on each.
  for (const char* line = text; line && std::strncmp(line, "cpu", 3) == 0;) {
    long long ticks = 0;
    if (std::sscanf(line, "cpu%*[0-9] %*d %*d %*d %*d %*d %*d %*d %lld", &ticks) == 1) {
      stolen_ms.push_back(static_cast<double>(ticks) * kMsPerTick);
    }
    line = std::strchr(line, '\n');
    if (line) ++line;
  }
  return stolen_ms;
}

void Watchdog::findDrawingThreads() {
  for (const QString& id : QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    QFile name(QStringLiteral("/proc/self/task/%1/comm").arg(id));
    if (!name.open(QIODevice::ReadOnly) || !name.readAll().contains("llvmpipe")) continue;
    auto schedule = std::make_unique<QFile>(QStringLiteral("/proc/self/task/%1/schedstat").arg(id));
    if (!schedule->open(QIODevice::ReadOnly | QIODevice::Unbuffered)) continue;
    last_drawing_.push_back(turnsOf(*schedule));
    drawing_schedules_.push_back(std::move(schedule));
  }
}

void Watchdog::beat() {
  const std::int64_t now = now_ns();
  const double cpu_ms = clock_ms(CLOCK_THREAD_CPUTIME_ID);
  const double process_ms = clock_ms(CLOCK_PROCESS_CPUTIME_ID);
  const double queue_ms = turnsOf(schedule_).queue_ms;
  const std::vector<double> stolen_ms = stolenFrom_ms(processors_);
  Stall stall;
  stall.wall_ms = static_cast<double>(now - last_beat_ns_) / kNsPerMs - kBeat_ms;
  stall.cpu_ms = cpu_ms - last_cpu_ms_;
  stall.queue_ms = queue_ms - last_queue_ms_;
  for (std::size_t k = 0; k < std::min(stolen_ms.size(), last_stolen_ms_.size()); ++k) {
    stall.stolen_ms = std::max(stall.stolen_ms, stolen_ms[k] - last_stolen_ms_[k]);
  }
  stall.others_ms = process_ms - last_process_ms_ - stall.cpu_ms;
  double busiest_ms = 0;
  for (std::size_t k = 0; k < drawing_schedules_.size(); ++k) {
    const Turns turns = turnsOf(*drawing_schedules_[k]);
    const double computed_ms = turns.cpu_ms - last_drawing_[k].cpu_ms;
    const double queued_ms = turns.queue_ms - last_drawing_[k].queue_ms;
    stall.others_ms -= computed_ms;
    stall.drawing_ms = std::max(stall.drawing_ms, computed_ms);
    busiest_ms = std::max(busiest_ms, computed_ms + queued_ms);
    last_drawing_[k] = turns;
  }
  stall.drawing_queue_ms = busiest_ms - stall.drawing_ms;
  stall.others_ms = std::max(0.0, stall.others_ms);
  stall.doing = doing_before_.isEmpty() ? doing_ : doing_before_ + QStringLiteral(", then ") + doing_;
  if (stall.wall_ms > worst_.wall_ms) worst_ = stall;
  if (stall.wall_ms > limit_ms_) stalls_.push_back(stall);
  ++beats_;
  last_beat_ns_ = now;
  last_cpu_ms_ = cpu_ms;
  last_process_ms_ = process_ms;
  last_queue_ms_ = queue_ms;
  last_stolen_ms_ = stolen_ms;
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
      // Less and less often: in a large library, a stack takes longer to write than a step of this, and nothing else
      // would go on.
      next_trace_ms = 1.2 * silent_ms + limit_ms_ / 4;
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
