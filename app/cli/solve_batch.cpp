#include "app/cli/solve_batch.h"

#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/parallel.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/calibration_json.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <future>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace hexoderm::cli {
namespace {

constexpr std::string_view kCalibrationEnding = ".calibration.json";
constexpr auto kLookForInterruptEvery = std::chrono::milliseconds(50);
constexpr const char* kLastWordsOfBatch = "hexoderm-cli: interrupted; every calibration that was written is whole\n";
/// Calibrations as text may wait for the line of a slow session before them: so many for each job.
constexpr std::size_t kMaxWaitingTexts = 4;

/// NAME of NAME.session.json.
std::string sessionName(const std::filesystem::path& input) {
  const std::string file = input.filename().string();
  for (const std::string_view ending : {".session.json", ".hexo", ".json"}) {
    if (file.size() > ending.size() && file.ends_with(ending)) return file.substr(0, file.size() - ending.size());
  }
  return file;
}

/// The folder of each input below the one that all have in common.
std::vector<std::filesystem::path> foldersOf(const std::vector<std::string>& inputs) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& input : inputs) {
    folders.push_back(std::filesystem::absolute(input).lexically_normal().parent_path());
  }
  std::filesystem::path common = folders.front();
  for (const std::filesystem::path& folder : folders) {
    const auto [end, other] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    std::filesystem::path same;
    for (auto part = common.begin(); part != end; ++part) same /= *part;
    common = same;
  }
  for (std::filesystem::path& folder : folders) folder = folder.lexically_relative(common);
  return folders;
}

/// JSON laid out in lines as one line: within a text there is no line break.
std::string inOneLine(std::string_view json) {
  std::string line;
  line.reserve(json.size());
  for (std::size_t begin = 0; begin < json.size();) {
    const std::size_t end = std::min(json.find('\n', begin), json.size());
    begin = std::min(json.find_first_not_of(' ', begin), end);
    line += json.substr(begin, end - begin);
    begin = end + 1;
  }
  return line;
}

/// What came of a session.
struct EndedSession {
  int exit_code = kDone;
  std::string line{};   ///< of standard output; empty: none
  std::string error{};  ///< with the session's name in front; empty: none
};

std::string lineOf(const std::string& input, const Reconstruction& result, const std::filesystem::path& written) {
  std::string verdict(verdictName(result.assessment.level));
  std::ranges::replace(verdict, '_', ' ');
  std::string line = input + ": " + verdict + ". " + sizeText(result).english() + ", " +
                     counted(result.poses.size(), "pose") + ", solved in " +
                     formatFixed(result.solve_seconds * 1000, 1) + " ms (" + result.solver + ")";
  if (!written.empty()) line += ". Written to " + written.string();
  return line;
}

std::string jsonLineOf(const std::string& input, const std::filesystem::path& written, const EndedSession& ended,
                       std::string_view calibration) {
  nlohmann::ordered_json json = {{"session", input}, {"file", nullptr}, {"exit_code", ended.exit_code}};
  if (!written.empty()) json["file"] = written.string();
  json["error"] = ended.error.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(ended.error);
  std::string line = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  line.pop_back();
  return line + ",\"calibration\":" + (calibration.empty() ? "null" : inOneLine(calibration)) + "}";
}

/// Solves one session, reads it and writes its calibration; nothing if it was stopped.
std::optional<EndedSession> solveOne(const std::string& input, const std::filesystem::path& written,
                                     const SolverOptions& solver, bool json, const std::stop_token& stop) {
  EndedSession ended;
  try {
    const auto result = reconstruct(*openSession(input).snapshot(), solver, nullptr, stop);
    if (result == nullptr) return std::nullopt;
    if (!written.empty()) writeCalibrationJson(*result, written);
    ended.exit_code = exitCodeOf(result->assessment);
    ended.line = json ? jsonLineOf(input, written, ended, calibrationToJson(*result)) : lineOf(input, *result, written);
  } catch (const std::exception& error) {
    const std::optional<int> code = exitCodeOf(error);
    if (!code) throw;
    ended.exit_code = *code;
    ended.error = error.what();
    if (!ended.error.starts_with(input)) ended.error = input + ": " + ended.error;
    if (json) ended.line = jsonLineOf(input, {}, ended, {});
  }
  return ended;
}

/// Threads that take up the sessions in their order, each of them one at a time.
class BatchThreads {
 public:
  /// `files`: of the calibrations; empty: none is written.
  BatchThreads(const SolveBatch& batch, const std::vector<std::filesystem::path>& files, bool json)
      : outcomes_(batch.inputs.size()) {
    const std::size_t jobs = std::min(batch.jobs, batch.inputs.size());
    for (std::promise<EndedSession>& outcome : outcomes_) futures_.push_back(outcome.get_future());
    ahead_ = json ? kMaxWaitingTexts * jobs : batch.inputs.size();
    for (std::size_t job = 0; job < jobs; ++job) {
      threads_.emplace_back([this, &batch, files, json, job] {
        const CoresInUse in_use(job == 0 ? 0 : 1);  // the first has the core that every call has
        for (std::size_t k = takeUp(); k < outcomes_.size(); k = takeUp()) {
          auto ended = solveOne(batch.inputs[k], files.empty() ? std::filesystem::path() : files[k], batch.solver, json,
                                stop_.get_token());
          if (ended) outcomes_[k].set_value(*std::move(ended));
        }
      });
    }
  }
  ~BatchThreads() { stop(); }
  BatchThreads(const BatchThreads&) = delete;
  BatchThreads& operator=(const BatchThreads&) = delete;

  /// Waits for a session, which is then let go; nothing if the user wants the program to end.
  std::optional<EndedSession> waitFor(std::size_t session) {
    do {
      if (isInterrupted()) return std::nullopt;
    } while (futures_[session].wait_for(kLookForInterruptEvery) != std::future_status::ready);
    {
      const std::lock_guard lock(mutex_);
      ++ahead_;
    }
    is_more_.notify_one();
    return futures_[session].get();
  }
  /// Nothing new begins from now on.
  void stop() { stop_.request_stop(); }
  void waitUntilStopped() { threads_.clear(); }
  /// A session that has ended and was not let go yet.
  std::optional<EndedSession> takeEnded(std::size_t session) {
    std::future<EndedSession>& future = futures_[session];
    if (!future.valid() || future.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    return future.get();
  }

 private:
  /// The session to solve next; one that there is not: none.
  std::size_t takeUp() {
    std::unique_lock lock(mutex_);
    is_more_.wait(lock, stop_.get_token(), [this] { return ahead_ > 0; });
    if (stop_.stop_requested()) return outcomes_.size();
    --ahead_;
    return next_++;
  }

  std::vector<std::promise<EndedSession>> outcomes_;
  std::vector<std::future<EndedSession>> futures_;
  std::mutex mutex_;
  std::condition_variable_any is_more_;
  std::size_t ahead_ = 0;  ///< so many more may be taken up before the first of them is let go
  std::size_t next_ = 0;   ///< to be taken up
  std::stop_source stop_;
  std::vector<std::jthread> threads_;  // last: they use all of the above
};

/// Prints what came of the sessions, and counts.
struct BatchReport {
  const Common& common;
  std::size_t count = 0;
  std::size_t not_good_enough = 0;
  std::size_t failed = 0;
  int exit_code = kDone;

  void add(const EndedSession& ended) {
    common.endProgress();
    ++count;
    exit_code = std::max(exit_code, ended.exit_code);
    if (!ended.error.empty()) {
      common.complain(ended.error);
      ++failed;
    } else if (ended.exit_code != kDone) {
      ++not_good_enough;
    }
    // Each line at once, for whoever waits for it at the end of a pipe.
    if (!ended.line.empty()) std::cout << forTerminal(ended.line) << '\n' << std::flush;
  }
};

void makeFolders(const std::vector<std::filesystem::path>& files) {
  std::set<std::filesystem::path> folders;
  for (const std::filesystem::path& file : files) folders.insert(file.parent_path());
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw StorageError(folder.string(), message("cannot be made: {}", systemReason(error)));
  }
}

void requireFolder(const std::string& name) {
  if (name == kStandardOutput) {
    throw InvalidArgument(
        "-o -: several calibrations are several files, which standard output can't be: give a "
        "folder, or take --json, which prints one in a line");
  }
  const std::filesystem::path path(name);
  const std::filesystem::path folder = path.has_filename() ? path : path.parent_path();
  if (std::filesystem::is_directory(folder)) return;
  if (name.ends_with(".json") || std::filesystem::exists(folder)) {
    throw InvalidArgument("-o: expected a folder for the calibrations of several sessions, found \"" + name + "\"");
  }
}

}  // namespace

std::vector<std::filesystem::path> calibrationsOf(const std::vector<std::string>& inputs,
                                                  const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const std::string& input : inputs) names.push_back(sessionName(input));
  const bool are_different = std::set(names.begin(), names.end()).size() == names.size();
  const std::vector<std::filesystem::path> folders =
      are_different ? std::vector<std::filesystem::path>(inputs.size()) : foldersOf(inputs);
  std::vector<std::filesystem::path> files;
  std::set<std::filesystem::path> taken;
  std::map<std::filesystem::path, std::size_t> last_number;  // of the files that would have this name
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::filesystem::path without_ending = (folder / folders[k] / names[k]).lexically_normal();
    std::size_t& number = last_number[without_ending];
    std::filesystem::path file;
    do {
      file = without_ending;
      if (++number > 1) file += "-" + std::to_string(number);
      file += kCalibrationEnding;
    } while (!taken.insert(file).second);
    files.push_back(file);
  }
  return files;
}

int solveBatch(const SolveBatch& batch, const Common& common) {
  std::vector<std::filesystem::path> files;
  if (!batch.folder.empty()) {
    requireFolder(batch.folder);
    files = calibrationsOf(batch.inputs, batch.folder);
    std::map<std::filesystem::path, std::string> names;  // of the same file by a link
    for (const std::filesystem::path& file : files) {
      requireReplaceable(file, "-o " + file.string());
      const auto [known, is_new] = names.try_emplace(std::filesystem::weakly_canonical(file), file.string());
      if (!is_new) requireApart(file.string(), known->second);
    }
    makeFolders(files);
  }
  endOnInterrupt(kLastWordsOfBatch);
  BatchThreads threads(batch, files, common.json);
  BatchReport report{common};
  const std::size_t count = batch.inputs.size();
  const auto next = [&](std::size_t session) {
    common.progress("Solved " + std::to_string(session) + " of " + std::to_string(count) + " sessions ...");
    const std::optional<EndedSession> ended = threads.waitFor(session);
    if (ended) report.add(*ended);
    return ended.has_value();
  };
  std::size_t session = 0;
  while (session < count && next(session)) ++session;
  common.endProgress();
  if (session == count) {
    if (!common.json) {
      std::cout << counted(count, "session") << ": " << count - report.not_good_enough - report.failed
                << " good or usable, " << report.not_good_enough << " not enough or failed, " << report.failed
                << " with an error\n";
    }
    return report.exit_code;
  }
  threads.stop();
  // What has ended is said before those that are under way are waited for, which may be in vain.
  for (const bool is_last_time : {false, true}) {
    if (is_last_time) threads.waitUntilStopped();
    for (std::size_t k = session; k < count; ++k) {
      if (const std::optional<EndedSession> ended = threads.takeEnded(k)) report.add(*ended);
    }
  }
  common.note("Interrupted: " + std::to_string(report.count) + " of " + std::to_string(count) +
              " sessions were solved");
  return kEndedByForce;
}

}  // namespace hexoderm::cli
