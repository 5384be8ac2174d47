#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace hexoderm {

/// Runs jobs one after another on a thread of its own: files and the simulated skin never make the window wait. Jobs
/// must not throw. The destructor finishes the running job, drops those that wait and joins.
class JobQueue {
 public:
  using Job = std::function<void()>;

  JobQueue();
  void add(Job job);

 private:
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Job> jobs_;
  std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace hexoderm
