#include "hexoderm/reconstruction/reconstruction_worker.h"

#include "hexoderm/util/error.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace hexoderm {
namespace {

using testing::ElementsAre;

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
  std::vector<std::uint64_t> revisions() {
    const std::lock_guard lock(mutex_);
    std::vector<std::uint64_t> revisions;
    for (const ReconstructionOutcome& outcome : outcomes_) revisions.push_back(outcome.revision);
    return revisions;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ReconstructionOutcome> outcomes_;
};

/// A solve that says when it has begun and ends when the test allows it.
class HeldSolve {
 public:
  ReconstructionWorker::Solve solve() {
    return [this](const SessionSnapshot& snapshot, const SolverOptions&, const std::stop_token&) {
      std::unique_lock lock(mutex_);
      ++begun_;
      changed_.notify_all();
      changed_.wait(lock, [this] { return released_; });
      auto result = std::make_shared<Reconstruction>();
      result->revision = snapshot.revision;
      return std::shared_ptr<const Reconstruction>(result);
    };
  }
  void waitUntilBegun() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return begun_ > 0; });
  }
  void release() {
    const std::lock_guard lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }
  int begun() {
    const std::lock_guard lock(mutex_);
    return begun_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int begun_ = 0;
  bool released_ = false;
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

TEST(ReconstructionWorker, NewestWinsAndTheRunningSolveIsNotCancelled) {
  Outcomes outcomes;
  HeldSolve held;
  {
    ReconstructionWorker worker(outcomes.report(), held.solve());
    worker.submit(snapshotOf(1), {});
    held.waitUntilBegun();
    for (std::uint64_t revision = 2; revision <= 5; ++revision) worker.submit(snapshotOf(revision), {});
    held.release();
    outcomes.waitFor(2);
  }
  EXPECT_THAT(outcomes.revisions(), ElementsAre(1, 5));
}

TEST(ReconstructionWorker, OptionsTravelWithTheirSnapshot) {
  Outcomes outcomes;
  std::vector<double> thresholds;
  {
    ReconstructionWorker worker(outcomes.report(),
                                [&](const SessionSnapshot&, const SolverOptions& options, const std::stop_token&) {
                                  thresholds.push_back(options.class_threshold);
                                  return std::make_shared<const Reconstruction>();
                                });
    SolverOptions options;
    options.class_threshold = 0.75;
    worker.submit(snapshotOf(1), options);
    outcomes.waitFor(1);
  }
  EXPECT_THAT(thresholds, ElementsAre(0.75));
}

TEST(ReconstructionWorker, AnErrorBecomesAnOutcomeAndTheWorkerGoesOn) {
  Outcomes outcomes;
  ReconstructionWorker worker(outcomes.report());
  SolverOptions impossible;
  impossible.class_threshold = -1;
  worker.submit(snapshotOf(1), impossible);
  outcomes.waitFor(1);
  worker.submit(snapshotOf(2), {});
  const std::vector<ReconstructionOutcome> seen = outcomes.waitFor(2);
  EXPECT_EQ(seen[0].revision, 1U);
  EXPECT_EQ(seen[0].reconstruction, nullptr);
  EXPECT_THAT(seen[0].error.english(), testing::HasSubstr("threshold"));
  EXPECT_EQ(seen[1].error.english(), "");
  EXPECT_NE(seen[1].reconstruction, nullptr);
}

/// A solve that ends only when it is told to stop.
class EndlessSolve {
 public:
  ReconstructionWorker::Solve solve() {
    return [this](const SessionSnapshot& snapshot, const SolverOptions&, const std::stop_token& stop) {
      std::unique_lock lock(mutex_);
      begun_.push_back(snapshot.revision);
      changed_.notify_all();
      changed_.wait(lock, stop, [] { return false; });
      return std::shared_ptr<const Reconstruction>();
    };
  }
  void waitUntilBegun(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return begun_.size() >= count; });
  }
  std::vector<std::uint64_t> begun() {
    const std::lock_guard lock(mutex_);
    return begun_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<std::uint64_t> begun_;
};

TEST(ReconstructionWorker, TheDestructorStopsTheRunningSolveAndDropsWhatWaits) {
  Outcomes outcomes;
  EndlessSolve endless;
  {
    ReconstructionWorker worker(outcomes.report(), endless.solve());
    worker.submit(snapshotOf(1), {});
    endless.waitUntilBegun(1);
    worker.submit(snapshotOf(2), {});
  }
  EXPECT_THAT(endless.begun(), ElementsAre(1));
  EXPECT_THAT(outcomes.revisions(), ElementsAre());
}

TEST(ReconstructionWorker, CancelStopsTheRunningSolveDropsWhatWaitsAndGoesOn) {
  Outcomes outcomes;
  EndlessSolve endless;
  ReconstructionWorker worker(outcomes.report(), endless.solve());
  worker.cancel();  // nothing runs: nothing happens
  worker.submit(snapshotOf(1), {});
  endless.waitUntilBegun(1);
  worker.submit(snapshotOf(2), {});
  worker.cancel();
  worker.submit(snapshotOf(3), {});
  endless.waitUntilBegun(2);
  EXPECT_THAT(endless.begun(), ElementsAre(1, 3));
  EXPECT_THAT(outcomes.revisions(), ElementsAre());
}

TEST(ReconstructionWorker, ACancelledReconstructionLeavesNothingAndTheNextIsWhole) {
  std::stop_source cancelled;
  cancelled.request_stop();
  const ReconstructionWorker::Solve solve = ReconstructionWorker::startingFromTheLast();
  EXPECT_EQ(solve(*snapshotOf(1), {}, cancelled.get_token()), nullptr);
  ASSERT_NE(solve(*snapshotOf(2), {}, {}), nullptr);
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
}

TEST(ReconstructionWorker, GoesAwayWithoutEverHavingWorked) {
  Outcomes outcomes;
  { const ReconstructionWorker worker(outcomes.report()); }
  EXPECT_TRUE(outcomes.revisions().empty());
}

}  // namespace
}  // namespace hexoderm
