#include "hexoderm/base/latest_worker.h"

#include "tests/support/patience.h"
#include "tests/support/testing.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif
#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

namespace hexoderm {
namespace {

/// The names of the jobs that ran, in order.
class Diary {
 public:
  LatestWorker::Job job(const std::string& name) {
    return [this, name](const std::stop_token&) { note(name); };
  }
  void note(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.push_back(name);
  }
  std::vector<std::string> names() {
    const std::lock_guard lock(mutex_);
    return names_;
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> names_;
};

/// A job that runs until it is released or stopped.
class HeldJob {
 public:
  LatestWorker::Job job() {
    return [this](const std::stop_token& stop) {
      std::unique_lock lock(mutex_);
      begun_ = true;
      changed_.notify_all();
      changed_.wait(lock, stop, [this] { return released_; });
      was_stopped_ = stop.stop_requested();
    };
  }
  void waitUntilBegun() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return begun_; });
  }
  void release() {
    const std::lock_guard lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }
  bool wasStopped() {
    const std::lock_guard lock(mutex_);
    return was_stopped_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool begun_ = false;
  bool released_ = false;
  bool was_stopped_ = false;
};

class LatestWorkerTest : public testing::Test {
 protected:
  /// Keeps a worker busy until it is let go.
  void hold(LatestWorker& worker, std::size_t mailbox = 0) {
    worker.submit(held_.job(), mailbox);
    held_.waitUntilBegun();
  }
  void letGo(LatestWorker& worker) {
    held_.release();
    worker.waitUntilIdle();
  }

  Diary diary_;
  HeldJob held_;
};

#ifdef __linux__
TEST(LatestWorker, GivesWayToOtherThreads) {
  const int here = ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
  std::promise<int> there;
  LatestWorker worker;
  worker.submit(
      [&](const std::stop_token&) { there.set_value(::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()))); });
  EXPECT_EQ(there.get_future().get(), std::min(here + 5, 19));
  EXPECT_EQ(::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())), here);
}
#endif

TEST_F(LatestWorkerTest, TheNewestJobWinsAndTheRunningOneIsNotStopped) {
  LatestWorker worker;
  hold(worker);
  for (const char* name : {"1", "2", "3"}) worker.submit(diary_.job(name));
  letGo(worker);
  EXPECT_FALSE(held_.wasStopped());
  EXPECT_THAT(diary_.names(), ElementsAre("3"));
}

TEST_F(LatestWorkerTest, MailboxesDoNotDropEachOthersJobs) {
  LatestWorker worker(3);
  hold(worker, 1);
  worker.submit(diary_.job("of 2"), 2);
  worker.submit(diary_.job("old of 0"), 0);
  worker.submit(diary_.job("of 1"), 1);
  worker.submit(diary_.job("of 0"), 0);
  letGo(worker);
  EXPECT_THAT(diary_.names(), ElementsAre("of 0", "of 1", "of 2"));
}

TEST_F(LatestWorkerTest, CancelStopsTheRunningJobDropsTheWaitingOneAndTheWorkerGoesOn) {
  LatestWorker worker;
  hold(worker);
  worker.submit(diary_.job("dropped"));
  worker.cancel();
  worker.waitUntilIdle();
  EXPECT_TRUE(held_.wasStopped());
  EXPECT_THAT(diary_.names(), IsEmpty());
  worker.submit(diary_.job("next"));
  worker.waitUntilIdle();
  EXPECT_THAT(diary_.names(), ElementsAre("next"));
}

TEST_F(LatestWorkerTest, CancellingOneMailboxLeavesTheJobOfAnotherAlone) {
  LatestWorker worker(2);
  hold(worker);
  worker.cancel(1);
  letGo(worker);
  EXPECT_FALSE(held_.wasStopped());
}

TEST(LatestWorker, CancelReachesNoJobThatIsSubmittedLater) {
  LatestWorker worker;
  for (int k = 0; k < 200; ++k) {
    worker.cancel();
    std::promise<bool> stopped;
    worker.submit([&stopped](const std::stop_token& stop) { stopped.set_value(stop.stop_requested()); });
    EXPECT_FALSE(stopped.get_future().get());
  }
}

TEST_F(LatestWorkerTest, TheDestructorStopsTheRunningJobAndDropsTheWaitingOne) {
  {
    LatestWorker worker(2);
    hold(worker);
    worker.submit(diary_.job("0"), 0);
    worker.submit(diary_.job("1"), 1);
  }
  EXPECT_TRUE(held_.wasStopped());
  EXPECT_THAT(diary_.names(), IsEmpty());
}

TEST(LatestWorker, WhenIdleItHoldsNothingThatAJobHeld) {
  LatestWorker worker;
  auto held = std::make_shared<int>(1);
  worker.submit([held](const std::stop_token&) {});
  worker.waitUntilIdle();
  EXPECT_EQ(held.use_count(), 1);
}

TEST(LatestWorker, GoesAwayWithoutEverHavingWorked) {
  const std::future<void> gone = std::async(std::launch::async, [] { const LatestWorker worker; });
  EXPECT_EQ(gone.wait_for(test::kPatience), std::future_status::ready);
}

TEST(LatestWorker, TakesJobsOfManyThreads) {
  std::atomic<int> ran = 0;
  LatestWorker worker(2);
  {
    std::vector<std::jthread> threads;
    for (std::size_t thread = 0; thread < 4; ++thread) {
      threads.emplace_back([&, thread] {
        for (int k = 0; k < 500; ++k) {
          worker.submit([&ran](const std::stop_token&) { ++ran; }, thread % 2);
          if (k % 50 == 0) worker.cancel(thread % 2);
        }
      });
    }
  }
  worker.waitUntilIdle();
  EXPECT_GE(ran, 1);
  EXPECT_LE(ran, 2000);
}

}  // namespace
}  // namespace hexoderm
