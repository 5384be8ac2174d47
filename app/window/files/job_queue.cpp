#include "app/window/files/job_queue.h"

#include "hexoderm/util/thread_priority.h"

#include <utility>

namespace hexoderm {

JobQueue::JobQueue() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

void JobQueue::add(Job job) { push({std::move(job), false}); }

void JobQueue::addEssential(Job job) { push({std::move(job), true}); }

void JobQueue::push(Queued queued) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(queued));
  }
  arrived_.notify_one();
}

void JobQueue::run(const std::stop_token& stop) {
  giveWayToOtherThreads();
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

}  // namespace hexoderm
