#include "hexoderm/session/session_recorder.h"

#include "hexoderm/base/error.h"
#include "hexoderm/session/sample_blobs.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace hexoderm {

namespace {

/// Room for poses without raw samples; those of 10,000 cells take a megabyte.
constexpr std::uintmax_t kRoomForPoses = std::uintmax_t{4} << 20U;

/// Why raw samples should not be tried at all; empty if they may be. They go into SQLite's journal and from there into
/// the file, and poses must still find room behind them: a disk that is full to the last byte takes none.
Message whyNoRawSamples(const std::vector<StoreOperation>& operations, const std::filesystem::path& path) {
  std::uintmax_t most_bytes = 0;
  for (const StoreOperation& operation : operations) {
    const AddPose* add = addedPose(operation);
    if (add != nullptr && add->raw) most_bytes += mostBytesOf(*add->raw);
  }
  if (most_bytes == 0) return {};
  std::error_code unknown;
  const std::filesystem::space_info space = std::filesystem::space(path, unknown);
  const std::uintmax_t needed = 2 * most_bytes + kRoomForPoses;
  if (unknown || space.available >= needed) return {};
  return located(path.string(), message("the disk has only {} MiB left; for raw samples {} MiB have to be free",
                                        space.available >> 20U, needed >> 20U));
}

}  // namespace

struct SessionRecorder::State {
  struct Job {
    std::vector<StoreOperation> operations;
    Acknowledge done;

    void acknowledge(const StoreOutcome& outcome) const {
      if (done) done(outcome);
    }
  };

  Open open;
  std::optional<SessionStore> store;  // touched by the thread alone once it runs
  mutable std::mutex mutex;
  std::condition_variable_any changed;
  std::deque<Job> jobs;    // the thread takes from the front; references to others stay valid
  Message renewed;         // what became of the file, until somebody is told; touched by the thread alone
  bool is_to_try = false;  // something was added, or is to be tried again
  std::jthread thread;     // last: started when everything it uses exists, joined before any of it goes

  void start() {
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void add(Job job) {
    {
      const std::lock_guard lock(mutex);
      jobs.push_back(std::move(job));
      is_to_try = true;
    }
    changed.notify_one();
  }

  void run(const std::stop_token& stop) {
    bool is_last = false;
    while (!is_last) {
      {
        std::unique_lock lock(mutex);
        changed.wait(lock, stop, [this] { return is_to_try; });
        is_to_try = false;
        is_last = stop.stop_requested();
      }
      if (writeAll() && store) store->tidy();
    }
    giveUp();
    store.reset();
  }

  const Job* firstJob() const {
    const std::lock_guard lock(mutex);
    return jobs.empty() ? nullptr : &jobs.front();
  }
  Job takeFirstJob() {
    const std::lock_guard lock(mutex);
    Job job = std::move(jobs.front());
    jobs.pop_front();
    return job;
  }

  StoreOutcome write(const std::vector<StoreOperation>& operations) {
    StoreOutcome outcome;
    try {
      if (!store && open) store.emplace(open());
      if (Message what = store->renewIfGone(); !what.empty()) renewed = std::move(what);
      outcome.revision = operations.empty() ? store->revision() : store->append(operations);
    } catch (const InvalidArgument& error) {
      outcome.error = error.message();
    } catch (const std::exception& error) {
      outcome.error = messageOf(error);
      outcome.is_kept = true;
    }
    return outcome;
  }

  /// The operations without raw samples, if there are any.
  static std::optional<std::vector<StoreOperation>> withoutRaw(std::vector<StoreOperation> operations) {
    bool had_some = false;
    for (StoreOperation& operation : operations) {
      auto* edit = std::get_if<SessionEdit>(&operation);
      auto* add = edit != nullptr ? std::get_if<AddPose>(edit) : nullptr;
      if (add != nullptr) had_some = std::exchange(add->raw, nullptr) || had_some;
    }
    return had_some ? std::optional(std::move(operations)) : std::nullopt;
  }

  StoreOutcome writeAllOrWithoutRaw(const std::vector<StoreOperation>& operations) {
    StoreOutcome outcome;
    Message why = store ? whyNoRawSamples(operations, store->path()) : Message();
    if (why.empty()) {
      outcome = write(operations);
      if (!outcome.is_kept || !store) return outcome;
      why = outcome.error;
    }
    if (const auto bare = withoutRaw(operations)) {
      outcome = write(*bare);
      if (outcome.error.empty()) outcome.without_raw = std::move(why);
    }
    return outcome;
  }

  /// True if nothing is left.
  bool writeAll() {
    while (const Job* job = firstJob()) {
      StoreOutcome outcome = writeAllOrWithoutRaw(job->operations);
      if (outcome.is_kept) {
        acknowledgeAll(outcome);
        return false;
      }
      if (job->done && outcome.error.empty()) outcome.renewed = std::exchange(renewed, {});
      takeFirstJob().acknowledge(outcome);
    }
    return true;
  }

  void acknowledgeAll(const StoreOutcome& outcome) const {
    std::vector<Acknowledge> all;
    {
      const std::lock_guard lock(mutex);
      for (const Job& job : jobs) all.push_back(job.done);
    }
    for (const Acknowledge& done : all) {
      if (done) done(outcome);
    }
  }

  void giveUp() {
    while (firstJob() != nullptr) {
      takeFirstJob().acknowledge(
          {0, message("the session was closed before this could be written to its file"), false, {}});
    }
  }
};

SessionRecorder::SessionRecorder(SessionStore store) : state_(std::make_unique<State>()) {
  state_->store.emplace(std::move(store));
  state_->start();
}

SessionRecorder::SessionRecorder(Open open, Acknowledge opened) : state_(std::make_unique<State>()) {
  state_->open = std::move(open);
  state_->add({{}, std::move(opened)});
  state_->start();
}

SessionRecorder::~SessionRecorder() = default;

void SessionRecorder::append(std::vector<StoreOperation> operations, Acknowledge done) {
  state_->add({std::move(operations), std::move(done)});
}

void SessionRecorder::flush(Acknowledge done) { state_->add({{}, std::move(done)}); }

void SessionRecorder::retry() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->is_to_try = true;
  }
  state_->changed.notify_one();
}

std::size_t SessionRecorder::waiting() const {
  const std::lock_guard lock(state_->mutex);
  return state_->jobs.size();
}

}  // namespace hexoderm
