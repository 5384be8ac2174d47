#include "hexoderm/base/latest_worker.h"

#include "hexoderm/base/thread_priority.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm {

struct LatestWorker::State {
  explicit State(std::size_t mailboxes) : waiting(mailboxes) {}

  mutable std::mutex mutex;
  mutable std::condition_variable_any changed;
  std::vector<Job> waiting;            // per mailbox; empty: none
  std::optional<std::size_t> running;  // mailbox of the job that runs
  std::stop_source stop_running;       // stops that job
  std::jthread thread;  // last: started when everything it uses exists, joined before any of it is destroyed

  [[nodiscard]] std::vector<Job>::iterator firstWaiting() {
    return std::ranges::find_if(waiting, [](const Job& job) { return static_cast<bool>(job); });
  }
  [[nodiscard]] bool isBusy() const {
    return running || std::ranges::any_of(waiting, [](const Job& job) { return static_cast<bool>(job); });
  }

  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, stop, [this] { return firstWaiting() != waiting.end(); });
      if (stop.stop_requested()) return;
      const auto next = firstWaiting();
      Job job = std::exchange(*next, nullptr);
      running = static_cast<std::size_t>(next - waiting.begin());
      stop_running = std::stop_source();
      const std::stop_token stop_job = stop_running.get_token();
      lock.unlock();
      job(stop_job);
      job = nullptr;  // the job's own data go before anybody is told that the worker is idle
      lock.lock();
      running.reset();
      changed.notify_all();
    }
  }

  void cancel(std::size_t mailbox) {
    std::stop_source to_stop(std::nostopstate);
    Job dropped;
    {
      const std::lock_guard lock(mutex);
      dropped = std::exchange(waiting.at(mailbox), nullptr);
      if (running == mailbox) to_stop = stop_running;
    }
    changed.notify_all();
    to_stop.request_stop();  // without the lock: its callbacks are somebody else's
  }
};

LatestWorker::LatestWorker(std::size_t mailboxes) : state_(std::make_unique<State>(mailboxes)) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) {
    giveWayToOtherThreads();
    state->run(stop);
  });
}

LatestWorker::~LatestWorker() {
  // No further job begins after this, so that cancelling reaches every one.
  state_->thread.request_stop();
  for (std::size_t mailbox = 0; mailbox < state_->waiting.size(); ++mailbox) state_->cancel(mailbox);
}

void LatestWorker::submit(Job job, std::size_t mailbox) {
  Job dropped;
  {
    const std::lock_guard lock(state_->mutex);
    dropped = std::exchange(state_->waiting.at(mailbox), std::move(job));
  }
  state_->changed.notify_all();
}

void LatestWorker::cancel(std::size_t mailbox) { state_->cancel(mailbox); }

void LatestWorker::waitUntilIdle() const {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return !state_->isBusy(); });
}

}  // namespace hexoderm
