#include "hexoderm/base/interrupt.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstring>

namespace hexoderm {
namespace {

constexpr unsigned kGrace_s = 1;

std::atomic<bool> interrupted = false;
std::atomic<const char*> words = "";
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free,
              "used by signal handlers");

// What handlers call must be safe for signals: alarm(), poll(), write() and _exit() are.

void endNow(int /*signal*/) {
  pollfd standard_error{STDERR_FILENO, POLLOUT, 0};
  // A pipe that nobody reads must not hold this up too.
  if (::poll(&standard_error, 1, 0) == 1 && (standard_error.revents & POLLOUT) != 0) {
    const char* const line = words;
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line, std::strlen(line));
  }
  ::_exit(kEndedByForce);
}

void askToEnd(int signal) {
  if (interrupted.exchange(true)) endNow(signal);
  ::alarm(kGrace_s);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void endOnInterrupt(const char* last_words) {
  words = last_words;
  handle(SIGALRM, endNow);
  handle(SIGINT, askToEnd);
  handle(SIGTERM, askToEnd);
  // The programs before this one may have blocked them.
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGALRM, SIGINT, SIGTERM}) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

bool isInterrupted() { return interrupted; }

}  // namespace hexoderm
