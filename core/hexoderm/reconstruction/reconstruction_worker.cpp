#include "hexoderm/reconstruction/reconstruction_worker.h"

#include "hexoderm/util/error.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace hexoderm {

struct ReconstructionWorker::State {
  struct Letter {
    std::shared_ptr<const SessionSnapshot> snapshot;
    SolverOptions options;
  };

  Report report;
  Solve solve;
  std::mutex mutex;
  std::condition_variable_any arrived;
  std::optional<Letter> mailbox;
  std::stop_source solving;  // of the solve that runs
  std::jthread thread;       // last: started when everything it uses exists, joined before any of it goes

  std::optional<Letter> waitForLetter(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    arrived.wait(lock, stop, [this] { return mailbox.has_value(); });
    if (stop.stop_requested()) return std::nullopt;
    solving = std::stop_source();
    return std::exchange(mailbox, std::nullopt);
  }

  void cancel() {
    std::stop_source running;
    {
      const std::lock_guard lock(mutex);
      mailbox.reset();
      running = solving;
    }
    running.request_stop();
  }

  void run(const std::stop_token& stop) {
    while (const std::optional<Letter> letter = waitForLetter(stop)) {
      const std::stop_callback ends_with_thread(stop, [this] { cancel(); });
      ReconstructionOutcome outcome;
      outcome.revision = letter->snapshot->revision;
      try {
        outcome.reconstruction = solve(*letter->snapshot, letter->options, solving.get_token());
        if (outcome.reconstruction == nullptr) continue;
      } catch (const std::exception& error) {
        outcome.error = messageOf(error);
      }
      report(std::move(outcome));
    }
  }
};

ReconstructionWorker::ReconstructionWorker(Report report, Solve solve) : state_(std::make_unique<State>()) {
  state_->report = std::move(report);
  state_->solve = std::move(solve);
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
}

ReconstructionWorker::Solve ReconstructionWorker::startingFromTheLast() {
  return [last = std::shared_ptr<const Reconstruction>()](const SessionSnapshot& snapshot, const SolverOptions& options,
                                                          const std::stop_token& stop) mutable {
    auto result = reconstruct(snapshot, options, last.get(), stop);
    if (result) last = result;
    return result;
  };
}

ReconstructionWorker::~ReconstructionWorker() = default;

void ReconstructionWorker::submit(std::shared_ptr<const SessionSnapshot> snapshot, SolverOptions options) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->mailbox = State::Letter{std::move(snapshot), options};
  }
  state_->arrived.notify_one();
}

void ReconstructionWorker::cancel() { state_->cancel(); }

}  // namespace hexoderm
