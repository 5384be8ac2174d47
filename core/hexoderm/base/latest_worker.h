#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>

namespace hexoderm {

/// A thread with mailboxes of one slot each, where the newest job wins: a job that waits is dropped when another one is
/// submitted to its mailbox. A job that runs is only ever stopped by cancel(), so that results still come while jobs
/// arrive faster than they are done. For work that is out of date as soon as there is newer input; jobs that must all
/// run belong in a queue.
///
/// Jobs run one after another; of several that wait, the one in the mailbox with the smallest number runs first. They
/// must not throw: std::terminate. All functions may be called from any thread, but waitUntilIdle() and the destructor
/// not from a job.
class LatestWorker {
 public:
  /// `stop` is requested by cancel() and by the destructor; a job that takes long should check it.
  using Job = std::function<void(const std::stop_token& stop)>;

  explicit LatestWorker(std::size_t mailboxes = 1);  ///< with so many mailboxes, each of which keeps the newest job
  /// Stops the running job, drops those that wait and joins the thread.
  ~LatestWorker();

  /// Never waits for a job.
  void submit(Job job, std::size_t mailbox = 0);
  /// Drops the job that waits in the mailbox, and requests the one from it that runs to stop. Does not wait until it
  /// has.
  void cancel(std::size_t mailbox = 0);
  /// Returns once no job waits or runs.
  void waitUntilIdle() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hexoderm
