#include "hexoderm/base/parallel.h"

#include "tests/support/testing.h"

#include <atomic>
#include <chrono>
#include <latch>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace hexoderm {
namespace {

using testing::Pair;

class Parallel : public testing::Test {
 protected:
  ~Parallel() override { setCores(before_); }

 private:
  std::size_t before_ = cores();
};

TEST_F(Parallel, EverythingIsDoneOnceWithAnyNumberOfCores) {
  for (const std::size_t count : {0, 1, 2, 7}) {
    setCores(count);
    EXPECT_EQ(cores(), std::max<std::size_t>(1, count));
    for (const std::size_t works : {0, 1, 2, 1000}) {
      std::vector<int> done(works, 0);
      inParallel(works, [&](std::size_t k) { ++done[k]; });
      EXPECT_THAT(done, Each(1));
    }
  }
}

TEST_F(Parallel, SeveralAreAtWorkAtOnce) {
  setCores(3);
  std::latch all_are_there(3);  // would wait for ever for fewer
  inParallel(3, [&](std::size_t) { all_are_there.arrive_and_wait(); });
}

TEST_F(Parallel, WithOneCoreOneAfterTheOtherInThisThread) {
  setCores(1);
  std::vector<std::size_t> order;
  const std::thread::id here = std::this_thread::get_id();
  inParallel(3, [&](std::size_t k) {
    order.push_back(k);
    EXPECT_EQ(std::this_thread::get_id(), here);
  });
  EXPECT_THAT(order, ElementsAre(0, 1, 2));
}

/// By how many threads something is done that leaves each of them time to begin.
std::size_t threadsAtWork() {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  inParallel(20, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  return threads.size();
}

TEST_F(Parallel, CoresThatOthersUseAreLeftToThem) {
  setCores(4);
  {
    const CoresInUse others(3);
    EXPECT_EQ(freeCores(), 0U);
    EXPECT_EQ(threadsAtWork(), 1U);
    const CoresInUse more(5);
    EXPECT_EQ(freeCores(), 0U);
    EXPECT_EQ(threadsAtWork(), 1U);
  }
  EXPECT_EQ(freeCores(), 3U);
  std::latch all_are_there(4);
  std::latch all_have_looked(4);  // nobody gives a core back before
  inParallel(4, [&](std::size_t) {
    all_are_there.arrive_and_wait();
    EXPECT_EQ(freeCores(), 0U) << "all cores are at work already";
    all_have_looked.arrive_and_wait();
  });
}

TEST_F(Parallel, TheFirstFailureIsThrownWhenAllHaveEnded) {
  for (const std::size_t count : {1, 4}) {
    setCores(count);
    std::atomic<int> ended = 0;
    const auto fail = [&](std::size_t k) {
      ++ended;
      if (k % 10 == 3) throw std::runtime_error(std::to_string(k));
    };
    EXPECT_EQ(test::messageOf<std::runtime_error>([&] { inParallel(50, fail); }), "3");
    EXPECT_EQ(ended, 50);
  }
}

TEST_F(Parallel, RangesCoverAllAndDependOnTheirNumbersAlone) {
  const auto ranges = [](std::size_t count, std::size_t grain) {
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> found;
    inRanges(count, grain, [&](std::size_t begin, std::size_t end) {
      const std::lock_guard lock(mutex);
      found.emplace(begin, end);
    });
    return found;
  };
  for (const std::size_t count : {1, 3}) {
    setCores(count);
    EXPECT_THAT(ranges(10, 4), ElementsAre(Pair(0, 4), Pair(4, 8), Pair(8, 10)));
    EXPECT_THAT(ranges(4, 4), ElementsAre(Pair(0, 4)));
    EXPECT_THAT(ranges(0, 4), IsEmpty());
  }
}

}  // namespace
}  // namespace hexoderm
