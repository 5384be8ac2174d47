#pragma once

#include "hexoderm/base/latest_worker.h"
#include "hexoderm/solve/reconstructor.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

namespace hexoderm {

/// The outcome of solving one snapshot: a result, or the message of the error that prevented it.
struct ReconstructionOutcome {
  std::uint64_t revision = 0;
  std::shared_ptr<const Reconstruction> reconstruction;  ///< null if it failed
  Message error;                                         ///< empty if it did not
};

/// Solves snapshots on a thread of its own. The newest snapshot wins; one that is being solved is never cancelled by
/// another (a quick operator would never see a result). `report` is called on the worker's thread, for every snapshot
/// that was solved, in order of submission. The destructor stops the running solve, drops what waits and joins.
class ReconstructionWorker {
 public:
  /// Is given each outcome, on the worker's thread. Must not throw: std::terminate.
  using Report = std::function<void(ReconstructionOutcome)>;
  /// Null if it ended early because stop was requested.
  using Solve = std::function<std::shared_ptr<const Reconstruction>(const SessionSnapshot&, const SolverOptions&,
                                                                    const std::stop_token& stop)>;
  /// reconstruct(), each time from where the last one ended: what changed is usually one pose. `progress`: is told how
  /// far it is; may be null.
  static Solve startingFromTheLast(std::shared_ptr<SolveProgress> progress = nullptr);
  /// `solve` is what the thread does with a snapshot; whatever it throws becomes the outcome's error.
  explicit ReconstructionWorker(Report report, Solve solve = startingFromTheLast());

  /// Never waits for a solve.
  void submit(std::shared_ptr<const SessionSnapshot> snapshot, SolverOptions options);
  /// Stops the running solve and drops the waiting snapshot, when no result is wanted any more. It does not wait, so
  /// one more report may come.
  void cancel();

 private:
  Report report_;
  Solve solve_;
  LatestWorker worker_;  // last: it has ended before anything that it calls is destroyed
};

}  // namespace hexoderm
