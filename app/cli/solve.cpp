#include "app/cli/command.h"

#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/parallel.h"
#include "hexoderm/base/system_reason.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/reconstructor.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <future>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm::cli {
namespace {

struct SolveBatch {
  std::vector<std::string> inputs;
  std::string folder;  ///< where the calibrations go, made if it is not there; empty: nowhere
  SolverOptions solver;
  std::size_t jobs = 1;   ///< sessions that are solved at the same time, each on a thread of its own; at least 1
  std::string surface{};  ///< "convex" or "concave"; empty: as each session says
};

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
  Json json = {{"session", input}, {"file", nullptr}, {"exit_code", ended.exit_code}};
  if (!written.empty()) json["file"] = written.string();
  json["error"] = ended.error.empty() ? Json(nullptr) : Json(ended.error);
  std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  line.pop_back();
  return line + ",\"calibration\":" + (calibration.empty() ? "null" : inOneLine(calibration)) + "}";
}

Session openWithSurface(const std::string& input, std::string_view surface) {
  Session session = openSession(input);
  if (!surface.empty()) session.setSide(surface == "convex" ? SkinSide::Convex : SkinSide::Concave);
  return session;
}

/// Solves one session, reads it and writes its calibration; nothing if it was stopped.
std::optional<EndedSession> solveOne(const SolveBatch& batch, const std::string& input,
                                     const std::filesystem::path& written, bool json, const std::stop_token& stop) {
  EndedSession ended;
  try {
    const auto result = reconstruct(*openWithSurface(input, batch.surface).snapshot(), batch.solver, nullptr, stop);
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
          auto ended = solveOne(batch, batch.inputs[k], files.empty() ? std::filesystem::path() : files[k], json,
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

/// The file of each input's calibration: NAME.calibration.json in the folder for NAME.session.json or NAME.hexo. Where
/// two inputs have one name, all keep the folders below the one that they have in common; what is called alike even
/// then gets a number, NAME-2. No two are the same file.
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

/// Solves every session as `solve` does a single one, and says what came of it in a line (with --json: an object in a
/// line), in the order of the inputs. A session that can't be read, solved or written is named on standard error; the
/// others go on. At most as many sessions are in memory as there are jobs. Ctrl+C lets nothing new begin.
/// Returns the largest exit code of all sessions, or kEndedByForce if it was interrupted. Throws InvalidArgument for a
/// folder that can't be one, and StorageError if it can't be made.
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
                << " good, usable or coarse, " << report.not_good_enough << " not enough, not trusted or failed, "
                << report.failed << " with an error\n";
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

struct SolveOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::size_t jobs = cores();
  std::map<std::string_view, std::string> choices;  ///< of solverChoices(), by name
  std::vector<std::uint32_t> without;
  double class_threshold = SolverOptions().class_threshold;
  std::vector<double> goal;  ///< mm, degrees; empty: the default
  std::string surface;       ///< as SolveBatch has it
};

void printSummary(const Reconstruction& r, const Session& session) {
  std::cout << sizeText(r) << ", " << session.poses().size() << " poses, solved in "
            << formatFixed(r.solve_seconds * 1000, 1) << " ms (" << r.solver << ")\n";
  for (const PatchReconstruction& patch : r.patches) {
    std::cout << "Patch " << patch.id << ": " << counted(patch.cells.size(), "cell") << ", origin cell "
              << patch.origin;
    if (patch.gap_share && patch.gap_share->sigma > 0) {
      std::cout << ", gap share " << formatFixed(patch.gap_share->share, 2) << " +- "
                << formatFixed(patch.gap_share->sigma, 2) << " (0 pivot, 1 arc)";
    }
    std::cout << '\n';
    if (patch.lot) std::cout << "  lot: " << lotText(*patch.lot) << '\n';
  }
  if (session.truth()) {
    for (const Comparison& comparison : compareToTruth(r, *session.truth())) {
      if (comparison.cells.size() == 1) continue;  // it fits wherever it is
      std::cout << "Against the truth, patch " << comparison.patch << ": position "
                << millimetres(comparison.position_rms_m, 3) << " rms, orientation "
                << degrees(comparison.orientation_rms_rad, 3) << " rms (after alignment)\n";
    }
  }
  printFindings(r.findings);
  printVerdict(r.assessment);
}

int run(const SolveOptions& options, const Common& common) {
  SolverOptions solver;
  for (const SolverChoice& choice : solverChoices()) choice.set(solver, options.choices.at(choice.name));
  for (const std::uint32_t id : options.without) solver.left_out.emplace_back(id);
  solver.class_threshold = options.class_threshold;
  if (!options.goal.empty()) {
    solver.goal = {options.goal[0] * kMillimetre, options.goal[1] * kDegree};
    checkOption("--goal", formatExact(options.goal[0]) + "," + formatExact(options.goal[1]),
                [&] { solver.validate(); });
  }
  solver.validate();
  if (options.inputs.size() > 1 || options.output.ends_with('/')) {
    return solveBatch({options.inputs, options.output, std::move(solver), options.jobs, options.surface}, common);
  }
  const Output output(options.output, common);

  const std::string& input = options.inputs.front();
  common.progress("Reading " + input + " ...");
  const Session session = openWithSurface(input, options.surface);
  common.progress("Solving ...");
  const auto result = reconstruct(*session.snapshot(), solver);
  if (!options.output.empty()) {
    common.progress("Writing " + output.inWords() + " ...");
    output.write([&](const WriteBytes& write) { writeCalibrationJson(*result, write); });
  }
  common.endProgress();
  if (common.json) {
    printJsonText(calibrationToJson(*result));
  } else {
    printSummary(*result, session);
    if (!options.output.empty()) std::cout << "Written to " << forTerminal(output.inWords()) << '\n';
  }
  return exitCodeOf(result->assessment);
}

}  // namespace

void addSolve(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<SolveOptions>(
      app, common, "solve", "Find the placement of every cell of a session",
      "Many sessions are solved at the same time, each as if it were alone. Each gets a line on standard output, with\n"
      "--json an object in a line; the exit code is the largest of all.\n"
      "Example:\n  hexoderm-cli solve arm.session.json -o arm.calibration.json\n"
      "With a mould that stretches, and cell 7 placed through its links:\n"
      "  hexoderm-cli solve arm.session.json --gap-model arc --without 7\n"
      "The paper's own method:\n  hexoderm-cli solve arm.session.json --solver tree --centre off\n"
      "All sessions of a folder, arm.session.json to out/arm.calibration.json:\n"
      "  hexoderm-cli solve *.session.json -o out/",
      run);
  addInput(command, "input", options.inputs, "Session (*.hexo or *.session.json), or many")->required();
  addOutput(command, "-o,--output", options.output,
            "Calibration to write (*.calibration.json; - is standard output); of several sessions, or with "
            "a / at its end, the folder for their calibrations");
  for (const SolverChoice& choice : solverChoices()) {
    std::string& value = options.choices[choice.name];
    value = choice.get(SolverOptions());
    addWithDefault(command, "--" + std::string(choice.name), value, std::string(choice.help));
  }
  command
      .add_option("--surface", options.surface,
                  "Where the skin lies: convex, on the outside of the body, or concave, in a hollow (default: as the "
                  "session says)")
      ->check(CLI::IsMember({"convex", "concave"}));
  takeWholeNumbers(command.add_option("--without", options.without, "Leave this cell's readings out; may be repeated"));
  takeNumbersAbove(addWithDefault(command, "--class-threshold", options.class_threshold,
                                  "Singular value from which a direction counts as defined; 1 is the paper's"),
                   0, kMaxClassThreshold);
  takeNumbersAbove(command
                       .add_option("--goal", options.goal,
                                   "How well every cell is to be known (95 %): the result is good within it, usable "
                                   "within three times as much, and coarse beyond (default: 3,2)")
                       ->type_name("MM,DEG")
                       ->expected(2)
                       ->delimiter(','),
                   0, toMillimetres(kMaxGoal.position_m));
  takeWholeNumbers(
      command.add_option("-j,--jobs", options.jobs,
                         "Of many sessions, so many at the same time (default: as the computer has threads)"),
      1, 1024);
}

}  // namespace hexoderm::cli
