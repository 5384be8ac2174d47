#include "hexoderm/base/parallel.h"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hexoderm {
namespace {

/// Of the computer's, those that this process may use.
std::size_t coresOfTheProcess() {
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return static_cast<std::size_t>(CPU_COUNT(&allowed));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

std::atomic<std::size_t> most_cores = coresOfTheProcess();
/// Beside the first thread of every call.
std::atomic<std::ptrdiff_t> in_use = 0;

std::ptrdiff_t freeBeside(std::ptrdiff_t used) {
  return std::max(std::ptrdiff_t(0), static_cast<std::ptrdiff_t>(most_cores.load()) - 1 - used);
}

/// Up to so many cores that nobody uses, until it goes.
class BorrowedCores {
 public:
  explicit BorrowedCores(std::size_t wanted) {
    std::ptrdiff_t used = in_use.load();
    do {
      count_ = std::min(freeBeside(used), static_cast<std::ptrdiff_t>(wanted));
    } while (count_ > 0 && !in_use.compare_exchange_weak(used, used + count_));
  }
  ~BorrowedCores() { in_use -= count_; }
  BorrowedCores(const BorrowedCores&) = delete;
  BorrowedCores& operator=(const BorrowedCores&) = delete;
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(count_); }

 private:
  std::ptrdiff_t count_ = 0;
};

/// What several threads take their work from.
class SharedWork {
 public:
  SharedWork(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work), failed_at_(count) {}

  /// Until nothing is left.
  void take() {
    for (std::size_t k = next_++; k < count_; k = next_++) {
      try {
        work_(k);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (k >= failed_at_) continue;
        failed_at_ = k;
        failure_ = std::current_exception();
      }
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t failed_at_;
  std::exception_ptr failure_;
};

}  // namespace

std::size_t cores() { return most_cores; }

void setCores(std::size_t count) { most_cores = std::max<std::size_t>(1, count); }

std::size_t freeCores() { return static_cast<std::size_t>(freeBeside(in_use)); }

CoresInUse::CoresInUse(std::size_t count) : count_(static_cast<std::ptrdiff_t>(count)) { in_use += count_; }

CoresInUse::~CoresInUse() { in_use -= count_; }

void inParallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  const BorrowedCores helpers(count > 0 ? count - 1 : 0);
  SharedWork shared(count, work);
  {
    std::vector<std::jthread> threads;
    threads.reserve(helpers.count());
    try {
      while (threads.size() < helpers.count()) threads.emplace_back([&shared] { shared.take(); });
    } catch (const std::system_error&) {
      // The system has no thread to spare: the others do it.
    }
    shared.take();
  }
  shared.rethrow();
}

void inRanges(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) {
  inParallel((count + grain - 1) / grain, [&](std::size_t k) { work(k * grain, std::min(count, (k + 1) * grain)); });
}

}  // namespace hexoderm
