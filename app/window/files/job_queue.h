#pragma once

#include "hexoderm/base/thread_priority.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace hexoderm {

/// Runs jobs one after another on a thread of its own: files and the simulated skin never make the window wait. Jobs
/// must not throw. The destructor finishes the running job and the essential ones, drops the others and joins.
class JobQueue {
 public:
  using Job = std::function<void()>;

  /// `is_urgent`: its jobs do not give way to computations.
  explicit JobQueue(bool is_urgent = false)
      : is_urgent_(is_urgent), thread_([this](const std::stop_token& stop) { run(stop); }) {}
  void add(Job job) { push({std::move(job), false}); }
  void addEssential(Job job) { push({std::move(job), true}); }

 private:
  struct Queued {
    Job job;
    bool is_essential = false;
  };
  void push(Queued queued) {
    {
      const std::lock_guard lock(mutex_);
      jobs_.push_back(std::move(queued));
    }
    arrived_.notify_one();
  }

  void run(const std::stop_token& stop) {
    if (!is_urgent_) giveWayToOtherThreads();
    for (;;) {
      Queued next;
      {
        std::unique_lock lock(mutex_);
        arrived_.wait(lock, stop, [this] { return !jobs_.empty(); });
        if (jobs_.empty()) return;
        next = std::move(jobs_.front());
        jobs_.pop_front();
      }
      if (!stop.stop_requested() || next.is_essential) next.job();
    }
  }

  const bool is_urgent_;
  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Queued> jobs_;
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace hexoderm
