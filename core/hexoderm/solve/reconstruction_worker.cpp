#include "hexoderm/solve/reconstruction_worker.h"

#include "hexoderm/base/error.h"

#include <exception>
#include <utility>

namespace hexoderm {

ReconstructionWorker::ReconstructionWorker(Report report, Solve solve)
    : report_(std::move(report)), solve_(std::move(solve)) {}

ReconstructionWorker::Solve ReconstructionWorker::startingFromTheLast(std::shared_ptr<SolveProgress> progress) {
  return [progress = std::move(progress), last = std::shared_ptr<const Reconstruction>()](
             const SessionSnapshot& snapshot, const SolverOptions& options, const std::stop_token& stop) mutable {
    auto result = reconstruct(snapshot, options, last.get(), stop, progress.get());
    if (result) last = result;
    return result;
  };
}

void ReconstructionWorker::submit(std::shared_ptr<const SessionSnapshot> snapshot, SolverOptions options) {
  worker_.submit([this, snapshot = std::move(snapshot), options = std::move(options)](const std::stop_token& stop) {
    ReconstructionOutcome outcome;
    outcome.revision = snapshot->revision;
    try {
      outcome.reconstruction = solve_(*snapshot, options, stop);
      if (outcome.reconstruction == nullptr) return;
    } catch (const std::exception& error) {
      outcome.error = messageOf(error);
    }
    report_(std::move(outcome));
  });
}

void ReconstructionWorker::cancel() { worker_.cancel(); }

}  // namespace hexoderm
