#include "hexoderm/session/session_recorder.h"

#include "hexoderm/util/error.h"
#include "support/failing_disk.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

namespace hexoderm {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

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
  PoseCapture capture;
  capture.id = PoseId(id);
  GravitySample sample;
  sample.cell = CellId(1);
  sample.mean_g.z() = 1;
  capture.samples = {sample};
  std::vector<StoreOperation> operations;
  operations.emplace_back(AddPose{{std::make_shared<const PoseCapture>(std::move(capture))}});
  return operations;
}

class SessionRecorderTest : public testing::Test {
 protected:
  SessionRecorderTest() { writeSessionStore(Session(builtInCellModel("hex-bma150"), NeighborList()), path_); }

  [[nodiscard]] std::vector<std::uint32_t> stored() const {
    std::vector<std::uint32_t> ids;
    const Session session = readSessionStore(path_);
    for (const SessionPose& pose : session.poses()) ids.push_back(pose.capture->id.value());
    return ids;
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "arm.hexo";
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
    EXPECT_EQ(all[k].outcome.error, "");
    EXPECT_EQ(all[k].outcome.revision, all[0].outcome.revision + k);
  }
  EXPECT_EQ(all[20].call, 100);
  EXPECT_EQ(all[20].outcome.revision, all[19].outcome.revision);
  EXPECT_EQ(recorder.waiting(), 0U);
  EXPECT_EQ(stored().size(), 20U) << "read by another while the recorder has it open";
}

TEST_F(SessionRecorderTest, AnAcknowledgedCaptureIsOnDisk) {
  SessionRecorder recorder(SessionStore::open(path_));
  std::promise<std::size_t> seen;
  recorder.append(capture(1), [&](const StoreOutcome&) { seen.set_value(stored().size()); });
  EXPECT_EQ(seen.get_future().get(), 1U);
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
  EXPECT_EQ(all[0].outcome.error, "");
  EXPECT_EQ(all[1].call, 1);
  EXPECT_EQ(all[1].outcome.error, "");
}

TEST_F(SessionRecorderTest, AStoreThatCanNotBeOpenedIsTriedAgain) {
  std::optional<SessionStore> other = SessionStore::open(path_);
  SessionRecorder recorder([this] { return SessionStore::open(path_); }, outcomes_.acknowledge(0));
  const StoreOutcome refused = outcomes_.waitFor(1)[0].outcome;
  EXPECT_THAT(refused.error, HasSubstr("already open"));
  EXPECT_TRUE(refused.is_kept);
  other.reset();
  recorder.retry();
  EXPECT_EQ(outcomes_.waitFor(2)[1].outcome.error, "");
}

TEST_F(SessionRecorderTest, WhatCanNotBeWrittenIsKeptInOrderAndWrittenLater) {
  SessionRecorder recorder(SessionStore::open(path_));
  std::size_t acknowledged = 0;
  {
    const test::NoFileGrows full;
    recorder.append(capture(1), outcomes_.acknowledge(1));
    const auto first = outcomes_.waitFor(1);
    EXPECT_EQ(first[0].call, 1);
    EXPECT_THAT(first[0].outcome.error, HasSubstr("arm.hexo"));
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
  EXPECT_EQ(all[acknowledged].outcome.error, "");
  EXPECT_EQ(all[acknowledged + 1].call, 2);
  EXPECT_EQ(all[acknowledged + 1].outcome.error, "");
  EXPECT_THAT(stored(), ElementsAre(1U, 2U));
}

TEST_F(SessionRecorderTest, WhatMakesNoSenseIsRefusedAndTheRestWritten) {
  SessionRecorder recorder(SessionStore::open(path_));
  recorder.append({RemovePose{3}}, outcomes_.acknowledge(1));
  recorder.append(capture(1), outcomes_.acknowledge(2));
  const auto all = outcomes_.waitFor(2);
  EXPECT_THAT(all[0].outcome.error, HasSubstr("no pose at place 3"));
  EXPECT_FALSE(all[0].outcome.is_kept);
  EXPECT_EQ(all[1].outcome.error, "");
}

TEST_F(SessionRecorderTest, EndingWritesWhatWaitsAndClosesTheFile) {
  {
    SessionRecorder recorder(SessionStore::open(path_));
    for (std::uint32_t id = 1; id <= 10; ++id) recorder.append(capture(id), {});
  }
  EXPECT_EQ(stored().size(), 10U);
  EXPECT_EQ(folder_.entryCount(), 1U);
  EXPECT_NO_THROW(SessionStore::open(path_));
}

TEST_F(SessionRecorderTest, EndingSaysWhatCouldNotBeWritten) {
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

  {
    const test::NoFileGrows full;
    SessionRecorder recorder([]() -> SessionStore { throw StorageError("no such disk"); }, {});
    recorder.append(capture(2), outcomes_.acknowledge(3));
  }
  const auto all = outcomes_.waitFor(1);
  EXPECT_EQ(all.back().call, 3);
  EXPECT_THAT(all.back().outcome.error, HasSubstr("closed before"));
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
  for (const auto& named : outcomes_.waitFor(20)) EXPECT_EQ(named.outcome.error, "");
  EXPECT_EQ(stored().size(), 20U);
}

}  // namespace
}  // namespace hexoderm
