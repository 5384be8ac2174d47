#include "hexoderm/solve/reconstruction_worker.h"

#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <condition_variable>
#include <latch>
#include <mutex>
#include <thread>

namespace hexoderm {
namespace {

std::shared_ptr<const SessionSnapshot> snapshotOf(std::uint64_t revision) {
  auto snapshot = std::make_shared<SessionSnapshot>();
  snapshot->revision = revision;
  snapshot->model = std::make_shared<const CellModel>(builtInCellModel("hex-bma150"));
  snapshot->neighbors = std::make_shared<const NeighborList>();
  return snapshot;
}

/// Collects outcomes from the worker's thread and lets the test wait for them.
class Outcomes {
 public:
  ReconstructionWorker::Report report() {
    return [this](ReconstructionOutcome outcome) {
      const std::lock_guard lock(mutex_);
      outcomes_.push_back(std::move(outcome));
      changed_.notify_all();
    };
  }
  std::vector<ReconstructionOutcome> waitFor(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return outcomes_.size() >= count; });
    return outcomes_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ReconstructionOutcome> outcomes_;
};

TEST(ReconstructionWorker, SolvesASnapshotAndSaysWhichRevisionItWas) {
  Outcomes outcomes;
  ReconstructionWorker worker(outcomes.report());
  worker.submit(snapshotOf(7), {});
  const std::vector<ReconstructionOutcome> seen = outcomes.waitFor(1);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].revision, 7U);
  EXPECT_EQ(seen[0].error.english(), "");
  ASSERT_NE(seen[0].reconstruction, nullptr);
  EXPECT_EQ(seen[0].reconstruction->revision, 7U);
}

TEST(ReconstructionWorker, AnErrorBecomesAnOutcomeAndTheWorkerGoesOn) {
  Outcomes outcomes;
  ReconstructionWorker worker(outcomes.report());
  worker.submit(snapshotOf(1), test::with(&SolverOptions::class_threshold, -1));
  outcomes.waitFor(1);
  worker.submit(snapshotOf(2), {});
  const std::vector<ReconstructionOutcome> seen = outcomes.waitFor(2);
  EXPECT_EQ(seen[0].revision, 1U);
  EXPECT_EQ(seen[0].reconstruction, nullptr);
  EXPECT_THAT(seen[0].error.english(), testing::HasSubstr("threshold"));
  EXPECT_EQ(seen[1].error.english(), "");
  EXPECT_NE(seen[1].reconstruction, nullptr);
}

// Which job runs, waits or is dropped is LatestWorker's matter.
TEST(ReconstructionWorker, ReportsNothingOfACancelledSolve) {
  Outcomes outcomes;
  std::latch begun(1);
  ReconstructionWorker worker(outcomes.report(),
                              [&](const SessionSnapshot& snapshot, const SolverOptions&, const std::stop_token& stop) {
                                if (snapshot.revision == 2) return std::make_shared<const Reconstruction>();
                                begun.count_down();
                                while (!stop.stop_requested()) std::this_thread::yield();
                                return std::shared_ptr<const Reconstruction>();
                              });
  worker.submit(snapshotOf(1), {});
  begun.wait();
  worker.cancel();
  worker.submit(snapshotOf(2), {});
  const std::vector<ReconstructionOutcome> seen = outcomes.waitFor(1);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].revision, 2U);
}

TEST(ReconstructionWorker, TellsHowFarItIs) {
  const auto progress = std::make_shared<SolveProgress>();
  const ReconstructionWorker::Solve solve = ReconstructionWorker::startingFromTheLast(progress);
  const auto result = solve(*snapshotOf(1), {}, {});
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(progress->stage(), SolveStage::Figures) << "the last stage";
  EXPECT_EQ(progress->patches(), result->patches.size());
  std::stop_source cancelled;
  cancelled.request_stop();
  EXPECT_EQ(solve(*snapshotOf(2), {}, cancelled.get_token()), nullptr);
  EXPECT_NE(progress->stage(), SolveStage::Figures) << "it began anew, and did not come so far";
  EXPECT_NE(solve(*snapshotOf(3), {}, {}), nullptr) << "the next one is whole";
}

}  // namespace
}  // namespace hexoderm
