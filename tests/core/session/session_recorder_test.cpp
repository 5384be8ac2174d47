#include "hexoderm/session/session_recorder.h"

#include "tests/core/session/store_test.h"

#include <condition_variable>
#include <future>
#include <iostream>
#include <mutex>
#include <thread>

namespace hexoderm::store_test {
namespace {

/// Collects outcomes from the store's thread and lets the test wait for them.
class Outcomes {
 public:
  struct Named {
    int call;
    StoreOutcome outcome;
  };
  SessionRecorder::Acknowledge acknowledge(int call) {
    return [this, call](const StoreOutcome& outcome) {
      const std::lock_guard lock(mutex_);
      all_.push_back({call, outcome});
      changed_.notify_all();
    };
  }
  std::vector<Named> waitFor(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return all_.size() >= count; });
    return all_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Named> all_;
};

std::vector<StoreOperation> capture(std::uint32_t id) {
  const PoseCapture capture{PoseId(id), {}, {{CellId(1), {0, 0, 1}}}};
  return {AddPose{{std::make_shared<const PoseCapture>(capture)}}};
}

class SessionRecorderTest : public StoreTest {
 protected:
  SessionRecorderTest() { writeSessionStore(emptySession(), path_); }

  [[nodiscard]] std::vector<std::uint32_t> stored() const { return poseIds(readSessionStore(path_)); }

  Outcomes outcomes_;
};

TEST_F(SessionRecorderTest, AcknowledgesInOrderWhatIsOnDisk) {
  SessionRecorder recorder(SessionStore::open(path_));
  for (std::uint32_t id = 1; id <= 20; ++id) recorder.append(capture(id), outcomes_.acknowledge(static_cast<int>(id)));
  recorder.flush(outcomes_.acknowledge(100));
  const auto all = outcomes_.waitFor(21);
  ASSERT_EQ(all.size(), 21U);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_EQ(all[k].call, static_cast<int>(k + 1));
    EXPECT_EQ(all[k].outcome.error.english(), "");
    EXPECT_EQ(all[k].outcome.revision, all[0].outcome.revision + k);
  }
  EXPECT_EQ(all[20].call, 100);
  EXPECT_EQ(all[20].outcome.revision, all[19].outcome.revision);
  EXPECT_EQ(recorder.waiting(), 0U);
  EXPECT_EQ(stored().size(), 20U) << "read by another while the recorder has it open";
}

TEST_F(SessionRecorderTest, OpensOnItsOwnThreadAndKeepsWhatComesMeanwhile) {
  std::promise<void> may_open;
  auto allowed = may_open.get_future().share();
  SessionRecorder recorder(
      [this, allowed] {
        allowed.wait();
        return SessionStore::open(path_);
      },
      outcomes_.acknowledge(0));
  recorder.append(capture(1), outcomes_.acknowledge(1));
  EXPECT_EQ(recorder.waiting(), 2U);
  may_open.set_value();
  const auto all = outcomes_.waitFor(2);
  EXPECT_EQ(all[0].call, 0);
  EXPECT_EQ(all[0].outcome.error.english(), "");
  EXPECT_EQ(all[1].call, 1);
  EXPECT_EQ(all[1].outcome.error.english(), "");
}

TEST_F(SessionRecorderTest, AStoreThatCanNotBeOpenedIsTriedAgain) {
  std::optional<SessionStore> other = SessionStore::open(path_);
  SessionRecorder recorder([this] { return SessionStore::open(path_); }, outcomes_.acknowledge(0));
  const StoreOutcome refused = outcomes_.waitFor(1)[0].outcome;
  EXPECT_THAT(refused.error.english(), HasSubstr("already open"));
  EXPECT_TRUE(refused.is_kept);
  other.reset();
  recorder.retry();
  EXPECT_EQ(outcomes_.waitFor(2)[1].outcome.error.english(), "");
}

TEST_F(SessionRecorderTest, WhatCanNotBeWrittenIsKeptInOrderAndWrittenLater) {
  SessionRecorder recorder(SessionStore::open(path_));
  std::size_t acknowledged = 0;
  {
    const test::NoFileGrows full;
    recorder.append(capture(1), outcomes_.acknowledge(1));
    const auto first = outcomes_.waitFor(1);
    EXPECT_EQ(first[0].call, 1);
    EXPECT_THAT(first[0].outcome.error.english(), HasSubstr("arm.hexo"));
    EXPECT_TRUE(first[0].outcome.is_kept);
    EXPECT_EQ(first[0].outcome.revision, 0U);

    recorder.append(capture(2), outcomes_.acknowledge(2));  // tries again, and fails for both
    const auto all = outcomes_.waitFor(3);
    EXPECT_TRUE(all[1].outcome.is_kept);
    EXPECT_TRUE(all[2].outcome.is_kept);
    EXPECT_EQ(recorder.waiting(), 2U);
    recorder.retry();
    acknowledged = outcomes_.waitFor(5).size();
  }
  recorder.retry();
  const auto all = outcomes_.waitFor(acknowledged + 2);
  EXPECT_EQ(all[acknowledged].call, 1);
  EXPECT_EQ(all[acknowledged].outcome.error.english(), "");
  EXPECT_EQ(all[acknowledged + 1].call, 2);
  EXPECT_EQ(all[acknowledged + 1].outcome.error.english(), "");
  EXPECT_THAT(stored(), ElementsAre(1U, 2U));
}

/// 2.8 MB: 0.1 is no whole number of LSB.
std::vector<StoreOperation> captureWithRaw(std::uint32_t id) {
  std::vector<SampleFrame> frames(100);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    frames[k].time_s = static_cast<double>(k) / 1000;
    for (std::uint32_t cell = 1; cell <= 1000; ++cell) frames[k].samples.push_back({CellId(cell), {0, 0.1, 1}});
  }
  std::vector<StoreOperation> operations = capture(id);
  std::get<AddPose>(std::get<SessionEdit>(operations[0])).raw =
      std::make_shared<const std::vector<SampleFrame>>(std::move(frames));
  return operations;
}

TEST_F(SessionRecorderTest, APoseWhoseRawSamplesDoNotFitIsKeptWithoutThem) {
  {
    SessionRecorder recorder(SessionStore::open(path_));
    recorder.append(captureWithRaw(1), outcomes_.acknowledge(1));
    EXPECT_EQ(outcomes_.waitFor(1)[0].outcome.without_raw.english(), "");
    {
      const test::NoFileGrows nearly_full(3 << 20);
      for (std::uint32_t id = 2; id <= 4; ++id) {
        recorder.append(captureWithRaw(id), outcomes_.acknowledge(static_cast<int>(id)));
      }
      const auto all = outcomes_.waitFor(4);
      EXPECT_EQ(all.back().outcome.error.english(), "");
      EXPECT_THAT(all.back().outcome.without_raw.english(), HasSubstr("arm.hexo"));
    }
    recorder.append(captureWithRaw(5), outcomes_.acknowledge(5));
    EXPECT_EQ(outcomes_.waitFor(5).back().outcome.without_raw.english(), "") << "the disk has room again";
  }
  EXPECT_THAT(stored(), ElementsAre(1U, 2U, 3U, 4U, 5U));
  const SessionStore store = SessionStore::openReadOnly(path_);
  EXPECT_EQ(store.readRawSamples(0).size(), 100U);
  EXPECT_TRUE(store.readRawSamples(3).empty());
  EXPECT_EQ(store.readRawSamples(4).size(), 100U);
}

TEST_F(SessionRecorderTest, APoseThatDoesNotFitEvenWithoutRawSamplesWaitsWithThem) {
  SessionRecorder recorder(SessionStore::open(path_));
  {
    const test::NoFileGrows full;
    recorder.append(captureWithRaw(1), outcomes_.acknowledge(1));
    EXPECT_TRUE(outcomes_.waitFor(1)[0].outcome.is_kept);
  }
  recorder.retry();
  const StoreOutcome outcome = outcomes_.waitFor(2)[1].outcome;
  EXPECT_EQ(outcome.error.english(), "");
  EXPECT_EQ(outcome.without_raw.english(), "");
  EXPECT_EQ(SessionStore::openReadOnly(path_).readRawSamples(0).size(), 100U);
}

TEST_F(SessionRecorderTest, AFileThatWasRemovedIsWrittenAnewWithAllThatItHeld) {
  SessionRecorder recorder(SessionStore::open(path_));
  recorder.append(captureWithRaw(1), outcomes_.acknowledge(1));
  EXPECT_TRUE(outcomes_.waitFor(1)[0].outcome.renewed.empty());
  fs::remove(path_);
  recorder.append({RemovePose{0}}, {});  // nobody is told of it
  recorder.append(capture(2), outcomes_.acknowledge(2));
  EXPECT_EQ(outcomes_.waitFor(2)[1].outcome.renewed.english(),
            path_.string() + ": was removed while it was open; the whole session was written anew");
  EXPECT_THAT(stored(), ElementsAre(2U));

  fs::remove(path_);
  recorder.flush(outcomes_.acknowledge(3));
  EXPECT_THAT(outcomes_.waitFor(3)[2].outcome.renewed.english(), HasSubstr("arm.hexo: was removed"));
  recorder.append(captureWithRaw(3), outcomes_.acknowledge(4));
  EXPECT_TRUE(outcomes_.waitFor(4)[3].outcome.renewed.empty()) << "it is told once";
  EXPECT_THAT(stored(), ElementsAre(2U, 3U));

  fs::remove(path_);
  recorder.flush(outcomes_.acknowledge(5));
  outcomes_.waitFor(5);
  EXPECT_EQ(SessionStore::openReadOnly(path_).readRawSamples(1).size(), 100U);
}

TEST_F(SessionRecorderTest, WhatHasNoFileAnyMoreWaitsForAPlace) {
  SessionRecorder recorder(SessionStore::open(path_));
  fs::remove(path_);
  fs::create_directory(path_);
  recorder.append(capture(1), outcomes_.acknowledge(1));
  const StoreOutcome refused = outcomes_.waitFor(1)[0].outcome;
  EXPECT_TRUE(refused.is_kept);
  EXPECT_THAT(refused.error.english(), HasSubstr("arm.hexo: was removed while it was open"));
  fs::remove(path_);
  recorder.retry();
  EXPECT_EQ(outcomes_.waitFor(2)[1].outcome.error.english(), "");
  EXPECT_THAT(stored(), ElementsAre(1U));
}

/// 0 if a disk that fills in the middle of raw samples costs only those.
int fillTheDiskWithRawSamples(const fs::path& folder) {
  const fs::path file = folder / "arm.hexo";
  constexpr std::uint32_t kPoses = 8;
  Outcomes outcomes;
  {
    SessionRecorder recorder(SessionStore::create(file, emptySession()));
    for (std::uint32_t id = 1; id <= kPoses; ++id) {
      recorder.append(captureWithRaw(id), outcomes.acknowledge(static_cast<int>(id)));
    }
    for (const auto& named : outcomes.waitFor(kPoses)) {
      if (!named.outcome.error.empty()) return 1;
    }
    if (outcomes.waitFor(kPoses).back().outcome.without_raw.english().find("the disk has only") == std::string::npos)
      return 2;
  }
  const SessionStore store = SessionStore::openReadOnly(file);
  if (store.readSession().poses().size() != kPoses) return 3;
  if (store.readRawSamples(0).size() != 100) return 4;
  return store.readRawSamples(kPoses - 1).empty() ? 0 : 5;
}

TEST_F(SessionRecorderTest, ADiskThatFillsInTheMiddleOfRawSamplesCostsOnlyThose) {
  const TemporaryFolder disk;
  const int result = test::withSmallDisk(disk.path(), 12 << 20, [&] { return fillTheDiskWithRawSamples(disk.path()); });
  if (result < 0) {
    std::cout << "no small disk can be mounted here; the tests above cover the same path of errors\n";
    return;
  }
  EXPECT_EQ(result, 0);
}

TEST_F(SessionRecorderTest, WhatMakesNoSenseIsRefusedAndTheRestWritten) {
  SessionRecorder recorder(SessionStore::open(path_));
  recorder.append({RemovePose{3}}, outcomes_.acknowledge(1));
  recorder.append(capture(1), outcomes_.acknowledge(2));
  const auto all = outcomes_.waitFor(2);
  EXPECT_THAT(all[0].outcome.error.english(), HasSubstr("no pose at place 3"));
  EXPECT_FALSE(all[0].outcome.is_kept);
  EXPECT_EQ(all[1].outcome.error.english(), "");
}

TEST_F(SessionRecorderTest, EndingWritesWhatWaitsClosesTheFileAndSaysWhatCouldNotBeWritten) {
  {
    SessionRecorder recorder(SessionStore::open(path_));
    const test::NoFileGrows full;
    recorder.append(capture(1), outcomes_.acknowledge(1));
    outcomes_.waitFor(1);
    recorder.flush(outcomes_.acknowledge(2));
    outcomes_.waitFor(3);
  }
  // The disk has room again, so the last try writes it.
  EXPECT_THAT(stored(), ElementsAre(1U));
  EXPECT_EQ(folder_.entryCount(), 1U);
  EXPECT_NO_THROW(SessionStore::open(path_));

  {
    const test::NoFileGrows full;
    SessionRecorder recorder([]() -> SessionStore { throw StorageError("no such disk"); }, {});
    recorder.append(capture(2), outcomes_.acknowledge(3));
  }
  const auto all = outcomes_.waitFor(1);
  EXPECT_EQ(all.back().call, 3);
  EXPECT_THAT(all.back().outcome.error.english(), HasSubstr("closed before"));
  EXPECT_FALSE(all.back().outcome.is_kept);
}

TEST_F(SessionRecorderTest, TakesWorkFromSeveralThreads) {
  SessionRecorder recorder(SessionStore::open(path_));
  {
    std::vector<std::jthread> threads;
    for (std::uint32_t t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::uint32_t k = 1; k <= 5; ++k) {
          recorder.append(capture(10 * t + k), outcomes_.acknowledge(0));
          recorder.retry();
          static_cast<void>(recorder.waiting());
        }
      });
    }
  }
  for (const auto& named : outcomes_.waitFor(20)) EXPECT_EQ(named.outcome.error.english(), "");
  EXPECT_EQ(stored().size(), 20U);
}

}  // namespace
}  // namespace hexoderm::store_test
