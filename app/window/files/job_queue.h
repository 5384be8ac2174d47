#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace hexoderm {

/// Runs jobs one after another on a thread of its own: files and the simulated skin never make the window wait. Jobs
/// must not throw. The destructor finishes the running job and the essential ones, drops the others and joins.
class JobQueue {
 public:
  using Job = std::function<void()>;

  JobQueue();
  void add(Job job);
  void addEssential(Job job);

 private:
  struct Queued {
    Job job;
    bool is_essential = false;
  };
  void push(Queued queued);
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Queued> jobs_;
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace hexoderm
