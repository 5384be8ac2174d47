#include "app/cli/capture.h"
#include "app/cli/capture_events.h"
#include "app/cli/command.h"

#include "hexoderm/course/capture_course.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/interrupt.h"
#include "hexoderm/util/kept_files.h"
#include "hexoderm/util/system_reason.h"
#include "hexoderm/util/text.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace hexoderm::cli {
namespace {

constexpr const char* kLastWords =
    "hexoderm-cli: ended while something was held up; every pose that was reported as captured is in the file\n";

/// reconstruct(), which Ctrl+C stops half a second later: enough for all but very large skins. Null if it was stopped.
std::shared_ptr<const Reconstruction> reconstructUnlessInterrupted(const SessionSnapshot& snapshot,
                                                                   const Reconstruction* earlier = nullptr) {
  constexpr std::chrono::milliseconds kLookEvery(20);
  constexpr std::chrono::milliseconds kGrace(500);
  std::stop_source stop;
  std::mutex mutex;
  std::condition_variable_any never;
  const std::jthread watch([&](const std::stop_token& done) {
    std::unique_lock lock(mutex);
    const auto wait = [&](std::chrono::milliseconds time) { never.wait_for(lock, done, time, [] { return false; }); };
    while (!done.stop_requested() && !isInterrupted()) wait(kLookEvery);
    wait(kGrace);
    stop.request_stop();
  });
  return reconstruct(snapshot, {}, earlier, stop.get_token());
}

std::string cellsInWords(std::size_t count) { return std::to_string(count) + (count == 1 ? " cell" : " cells"); }

/// One run of the command: passes what happens to the course of the capture, and says what it makes of it.
class Capture final : public CaptureOwner {
  using Clock = CaptureCourse::Clock;

 public:
  Capture(const CaptureOptions& options, const Common& common, SkinSource& source, CaptureEvents& events)
      : options_(options),
        common_(common),
        source_(source),
        events_(events),
        course_(*this, courseOptions(options)),
        offences_(common) {}

  /// Returns when there are enough poses, the stream is over, or the user ends it.
  void run() {
    const auto patience = std::chrono::duration<double>(options_.timeout_s);
    Clock::time_point last_progress = Clock::now();
    while (!course_.isFinished() && lost_.empty() && !isInterrupted()) {
      const std::optional<CaptureEvent> event = events_.next(std::chrono::milliseconds(100));
      if (event) std::visit([this](const auto& what) { handle(what); }, *event);
      if (std::exchange(made_progress_, false) || course_.isFileRefused()) last_progress = Clock::now();
      course_.tick();
      if (!event) sayThatNoReadingsCome();  // after a long solution news wait that come first
      if (!event && status_.state == SourceState::Ended) break;
      if (status_.state == SourceState::Incompatible) throw DeviceError(located(source_.address(), status_.message));
      if (Clock::now() - last_progress > patience && (!session_ || options_.automatic)) {
        throw DeviceError(source_.address() +
                          (session_ ? ": no pose for " : ": the device did not describe itself for ") +
                          formatFixed(options_.timeout_s, options_.timeout_s < 1 ? 1 : 0) + " s: " + whyNothingComes());
      }
    }
  }

  /// Waits until all that was captured is on disk. Throws StorageError if something can't be.
  void finish() {
    common_.endProgress();
    while (store_ && course_.waiting() > 0 && !course_.isFileRefused()) handleStored(std::chrono::milliseconds(100));
    store_.reset();  // tries for the last time
    while (handleStored(std::chrono::milliseconds(0))) continue;
    if (!lost_.empty()) throw StorageError(lost_);
  }

  [[nodiscard]] const std::optional<Session>& session() const { return session_; }
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& result() const { return result_; }
  /// Ctrl+C came before all poses were solved.
  [[nodiscard]] bool isUnsolved() const { return is_unsolved_; }
  [[nodiscard]] const SourceStatus& status() const { return status_; }
  [[nodiscard]] const std::string& device() const { return device_; }

  /// What the device does wrong goes before what is waited for.
  [[nodiscard]] std::string whyNothingComes() const {
    const bool is_wrong = !session_ && !status_.offences.empty();
    if (is_wrong) return inWords(status_.offences.front()).english();
    if (!session_) return status_.message.english();
    return inRow({hold_.message, last_refusal_, status_.message}, "; ").english();
  }

  void perform(const std::vector<SessionEdit>& edits) override {
    for (const SessionEdit& edit : edits) {
      apply(edit, *session_);
      SessionRecorder::Acknowledge done;
      if (const auto* add = std::get_if<AddPose>(&edit)) {
        done = [this, id = add->pose.capture->id](const StoreOutcome& outcome) { events_.push(Stored{id, outcome}); };
      }
      store_->append({edit}, std::move(done));
    }
    course_.noteChange();
  }
  std::uint32_t send(const SkinCommand& command) override { return source_.send(command); }
  void retryWriting() override { store_->retry(); }
  void onCourseEvent(const CourseEvent& event) override {
    std::visit([this](const auto& what) { show(what); }, event);
  }

 private:
  static CaptureCourseOptions courseOptions(const CaptureOptions& options) {
    CaptureCourseOptions course;
    course.poses = options.poses;
    course.keep_raw = options.keep_raw;
    // The disk may have room again in a moment.
    course.retry_every = std::chrono::seconds(1);
    course.give_up_after = std::chrono::seconds(10);
    return course;
  }

  void handle(const SkinDescription& skin) {
    made_progress_ = true;
    if (session_) {
      course_.describe(skin);
      return;
    }
    device_ = skin.device.english();
    session_ = CaptureCourse::sessionOf(skin, source_.address());
    store_ = std::make_unique<SessionRecorder>(SessionStore::create(options_.output, *session_));
    common_.endProgress();
    common_.note(device_ + ": " + cellsInWords(skin.neighbors.size()));
    if (options_.automatic && !skin.can_turn) {
      throw DeviceError(source_.address() + ": --auto needs a device that turns by itself, and this one can't");
    }
    course_.begin(*session_, skin);
    course_.setRobot(options_.automatic);
    nameTheSkin();
  }

  /// Labels come from the result without poses, so that they are the same for a recording however fast it is played.
  void nameTheSkin() {
    const Session without_poses(session_->model(), session_->neighbors());
    course_.setResult(reconstructUnlessInterrupted(*without_poses.snapshot()), false);
  }

  void handle(const CapturedPose& captured) {
    made_progress_ = true;
    course_.take(captured);
  }

  void handle(const Stored& stored) {
    made_progress_ = true;
    course_.setStored(stored.pose, stored.outcome);
    if (has_news_ && course_.waiting() == 0) solve();
  }
  bool handleStored(std::chrono::milliseconds patience) {
    const std::optional<CaptureEvent> event = events_.next(patience);
    if (!event) return false;
    if (const auto* stored = std::get_if<Stored>(&*event)) handle(*stored);
    return true;
  }

  void solve() {
    has_news_ = false;
    result_ = reconstructUnlessInterrupted(*session_->snapshot(), result_.get());
    is_unsolved_ = result_ == nullptr;
    course_.setResult(result_, true);
  }

  void handle(const CommandOutcome& outcome) {
    // A device that answers nothing is no progress, however often it is asked.
    if (outcome.done) made_progress_ = true;
    course_.setOutcome(outcome);
  }

  void handle(const SourceStatus& status) {
    offences_.show(status.offences);
    if (status.state != status_.state && !session_) common_.progress(status.message.english());
    if (status.state != status_.state && session_ && status.state != SourceState::Streaming &&
        status.state != SourceState::Stopped) {
      common_.endProgress();
      common_.note(status.message.english());
    }
    if (status.frames != status_.frames) readings_wait_.begin(hostTime_s());
    status_ = status;
    course_.setSending(status.state == SourceState::Streaming);
  }

  [[nodiscard]] double hostTime_s() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  /// What the device says of it is in the state's text. Where it is not connected, that has been said.
  void sayThatNoReadingsCome() {
    if (!session_ || status_.state != SourceState::Streaming) return readings_wait_.begin(hostTime_s());
    const std::optional<double> waited_s = readings_wait_.toBeSaid(hostTime_s());
    if (!waited_s) return;
    common_.endProgress();
    common_.note("No readings for " + formatFixed(*waited_s, 0) + " s. " + status_.message.english());
  }

  void handle(const HoldStatus& hold) {
    hold_ = hold;
    common_.progress(hold.message.english());
  }

  void handle(const LongWait& wait) {
    common_.logNote("No pose for " + formatFixed(wait.duration_s, 0) + " s. " + wait.why.english());
  }

  void show(const PoseTaken& /*taken*/) {}
  void show(const PoseKept& kept) {
    has_news_ = true;
    last_refusal_ = {};
    const CapturedPose& captured = kept.captured;
    common_.endProgress();
    std::string text =
        "Pose " + toString(captured.pose->id) + " captured: " + cellsInWords(captured.pose->samples.size());
    if (!captured.silent_cells.empty()) text += ", silent " + listInWords(captured.silent_cells);
    if (captured.repeats) {
      text += "; it repeats pose " + toString(*captured.repeats) + " (" + degrees(captured.repeat_angle_rad, 1) + ")";
    }
    common_.note(text);
    for (const OddCell& odd : captured.odd_cells) common_.note(describe(odd).english());
    if (!kept.without_raw.empty()) {
      common_.note("Pose " + toString(captured.pose->id) +
                   " is kept without its raw samples: " + kept.without_raw.english());
    }
  }
  void show(const PoseLost& pose) { lost_ = pose.why; }
  void show(const FileRefused& refused) {
    common_.endProgress();
    common_.note(refused.why.english() + ". Trying again.");
  }
  void show(const SkinChanged& changed) {
    nameTheSkin();
    common_.note(changed.other_model ? "The device says that it has another cell model; poses stay."
                                     : "The device says that its topology has changed; poses stay.");
  }
  void show(const AdviceWanted& wanted) {
    if (wanted.question.seen == result_ && !course_.isFinished()) course_.setAdvice(adviseOn(wanted.question));
  }
  void show(const AdviceChanged& /*changed*/) {
    if (course_.nextPose()) common_.note("Next: " + adviceInWords(*course_.nextPose(), *result_).english());
  }
  void show(const TurnRefused& refused) {
    common_.endProgress();
    last_refusal_ = message("The device does not turn there: {}", refused.why);
    common_.note("The device does not turn there: " + refused.why.english());
    if (refused.gave_up) {
      throw DeviceError(source_.address() + ": refused to turn " + std::to_string(refused.times) +
                        " times, the last time: " + refused.why.english());
    }
  }
  void show(const CourseFinished& /*finished*/) {}

  const CaptureOptions& options_;
  const Common& common_;
  SkinSource& source_;
  CaptureEvents& events_;

  std::optional<Session> session_;
  std::unique_ptr<SessionRecorder> store_;
  CaptureCourse course_;
  OffenceNotes offences_;
  Message lost_;  ///< why something is not on disk and never will be
  std::string device_;
  SourceStatus status_;
  HoldStatus hold_;
  Message last_refusal_;  ///< of a turn, since the last pose
  Clock::time_point began_ = Clock::now();
  LastingWait readings_wait_{3};
  std::shared_ptr<const Reconstruction> result_;
  bool is_unsolved_ = false;
  bool has_news_ = false;  ///< poses that are not in the result
  bool made_progress_ = false;
};

nlohmann::ordered_json toJson(const HoldLedger& ledger) {
  nlohmann::ordered_json json = {{"watched_s", ledger.watched_s()}, {"still_s", ledger.still_s()}};
  auto blocked = nlohmann::ordered_json::array();
  for (const BlockedTime& time : ledger.blocked()) {
    nlohmann::ordered_json entry = {{"by", blockerName(time.blocker)}, {"for_s", time.duration_s}};
    if (time.cell != CellId()) {
      entry["cell"] = time.cell.value();
      entry["cell_for_s"] = time.cell_s;
    }
    entry["message"] = time.message.english();
    blocked.push_back(std::move(entry));
  }
  json["blocked"] = std::move(blocked);
  auto odd_cells = nlohmann::ordered_json::array();
  if (ledger.last()) {
    for (const OddCell& odd : ledger.last()->stillness.odd_cells) {
      odd_cells.push_back(
          {{"cell", odd.cell.value()}, {"is", oddCellName(odd.kind)}, {"message", describe(odd).english()}});
    }
    json["restarts"] = ledger.last()->restarts;
  }
  json["odd_cells"] = std::move(odd_cells);
  return json;
}

/// Why there is no pose.
void printWhatBlocked(const HoldLedger& ledger) {
  if (!ledger.last()) {
    std::cout << "No pose was captured: no readings came.\n";
    return;
  }
  const auto seconds = [](double duration_s) { return formatFixed(duration_s, 1) + " s"; };
  std::cout << "No pose was captured in " << seconds(ledger.watched_s()) << " of readings; the part was still for "
            << seconds(ledger.still_s()) << ".\n";
  for (const BlockedTime& time : ledger.blocked()) {
    std::cout << "  " << seconds(time.duration_s) << "  " << blockerName(time.blocker) << ": " << time.message;
    if (time.cell != CellId()) std::cout << " (cell " << time.cell << " decided for " << seconds(time.cell_s) << ")";
    std::cout << '\n';
  }
  for (const OddCell& odd : ledger.last()->stillness.odd_cells) std::cout << "  " << describe(odd) << '\n';
}

void print(const Capture& capture, const HoldLedger& ledger, const CaptureOptions& options, const Common& common) {
  const Session& session = *capture.session();
  const SourceStatus& status = capture.status();
  if (common.json) {
    nlohmann::ordered_json json = {{"file", options.output},
                                   {"device", capture.device()},
                                   {"cells", session.neighbors().size()},
                                   {"poses", session.poses().size()},
                                   {"frames", status.frames},
                                   {"lost_samples", status.lost_samples},
                                   {"dropped_by_device", status.dropped_by_device},
                                   {"late_frames", status.late_frames},
                                   {"rejected_messages", status.rejected_messages},
                                   {"reconnects", status.reconnects},
                                   {"skin_changes", status.skin_changes},
                                   {"clock_restarts", status.clock_restarts},
                                   {"offences", cli::toJson(status.offences)}};
    json["hold"] = toJson(ledger);
    json["verdict"] = capture.result() ? cli::toJson(capture.result()->assessment) : nlohmann::ordered_json();
    printJson(json);
    return;
  }
  std::cout << session.poses().size() << (session.poses().size() == 1 ? " pose" : " poses") << " of "
            << cellsInWords(session.neighbors().size()) << " in " << forTerminal(options.output) << '\n';
  if (status.lost_samples + status.late_frames + status.rejected_messages + status.reconnects > 0) {
    std::cout << "On the way: " << status.lost_samples << " samples lost, " << status.late_frames << " frames late, "
              << status.rejected_messages << " messages rejected, " << status.reconnects << " reconnects\n";
  }
  if (status.dropped_by_device > 0) {
    std::cout << "The device could not send " << status.dropped_by_device << " samples.\n";
  }
  if (session.poses().empty()) printWhatBlocked(ledger);
  if (status.skin_changes > 0) {
    std::cout << "The device described other cells or links " << status.skin_changes
              << (status.skin_changes == 1 ? " time.\n" : " times.\n");
  }
  if (status.clock_restarts > 0) {
    std::cout << "The device's clock was set back " << status.clock_restarts
              << (status.clock_restarts == 1 ? " time.\n" : " times.\n");
  }
  for (const Offence& offence : status.offences) {
    std::cout << "The device did something wrong " << offence.count << (offence.count == 1 ? " time (" : " times (")
              << offenceName(offence.kind) << "): " << inWords(offence) << '\n';
  }
  if (capture.result()) printVerdict(capture.result()->assessment);
  if (capture.isUnsolved()) std::cout << "Ended before it was solved; \"hexoderm-cli solve\" does that.\n";
}

/// A program that reads the JSON is told what a person is told on standard error.
void printWithoutSkin(const Capture& capture, const CaptureOptions& options, const Common& common) {
  if (!common.json || capture.session()) return;
  printJson({{"source", options.source},
             {"poses", 0},
             {"status", capture.status().message.english()},
             {"rejected_messages", capture.status().rejected_messages},
             {"offences", cli::toJson(capture.status().offences)}});
}

/// `report` is given the capture, once it is over, and where its time went.
template <class Report>
void captureAndThen(const CaptureOptions& options, const Common& common, const Report& report) {
  endOnInterrupt(kLastWords);
  const std::unique_ptr<SkinSource> source = asInput([&] { return openSkinSource(options.source); });
  requireReplaceable(options.recording, "--record " + options.recording);  // the source may read it
  PoseRecorderOptions recorder;
  recorder.keep_frames = options.keep_raw;
  CaptureEvents events(recorder);
  std::optional<StreamRecorder> recording;
  if (!options.recording.empty()) recording.emplace(options.recording, events);

  Capture capture(options, common, *source, events);
  common.progress("Connecting to " + options.source + " ...");
  // A recording is an input file; devices complain in their own way.
  asInput([&] { source->start(recording ? static_cast<SkinListener&>(*recording) : events); });
  try {
    capture.run();
  } catch (...) {
    source->stop();
    capture.finish();  // captured poses stay
    printWithoutSkin(capture, options, common);
    throw;
  }
  source->stop();
  capture.finish();
  if (recording) recording->finish();
  if (!capture.session()) {
    printWithoutSkin(capture, options, common);
    throw DeviceError(options.source + ": ended before a skin described itself" +
                      (capture.status().offences.empty() ? "" : ". " + capture.whyNothingComes()));
  }
  report(capture, events.ledger());
}

int run(const CaptureOptions& options, const Common& common) {
  requireNewSession(options.output);
  int exit_code = kNotGoodEnough;
  captureAndThen(options, common, [&](const Capture& capture, const HoldLedger& ledger) {
    print(capture, ledger, options, common);
    if (capture.result()) exit_code = exitCodeOf(capture.result()->assessment);
  });
  return exit_code;
}

}  // namespace

void requireNewSession(const std::string& output) {
  if (output == kStandardOutput) {
    throw InvalidArgument("-o -: a capture is kept in a file (*.hexo) while it goes on: give the name of one");
  }
  if (!output.ends_with(".hexo")) {
    throw InvalidArgument("-o: expected a name that ends in .hexo, found \"" + output + "\"");
  }
  std::error_code error;
  const auto there = std::filesystem::symlink_status(output, error).type();
  if (there == std::filesystem::file_type::none) {
    throw StorageError(located(output, message("cannot be written: {}", systemReason(error))));
  }
  if (there != std::filesystem::file_type::not_found) {
    throw StorageError(output + ": exists already; a capture never replaces a session");
  }
}

Session captureSession(const CaptureOptions& options, const Common& common) {
  std::optional<Session> session;
  captureAndThen(options, common, [&](const Capture& capture, const HoldLedger& ledger) {
    session = capture.session();
    if (session->poses().empty() && !common.json) printWhatBlocked(ledger);
  });
  return *std::move(session);
}

void addCapture(CLI::App& app, Common& common) {
  const auto options = std::make_shared<CaptureOptions>();
  CLI::App* command = app.add_subcommand("capture", "Take the poses of a skin that is connected, or of a recording");
  command->add_option("--source", options->source, sourceKindsInWords())->required();
  command->add_option("--poses", options->poses,
                      "End after so many (default: at the stream's end or Ctrl+C; with --auto when they are good)");
  command->add_flag("--auto", options->automatic, "The device turns itself, to where each pose helps most");
  command->add_flag("--keep-raw", options->keep_raw, "Keep every sample of the poses in the session too");
  command->add_option("--record", options->recording, "Write all that the device sends to this file, for replay:FILE")
      ->type_name(kOutput);
  command
      ->add_option(
          "--timeout", options->timeout_s,
          "Seconds to wait for a device to describe itself; with --auto also for each pose, whatever turns it refuses")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "Session to make (*.hexo)")->type_name(kOutput)->required();
  common.addTo(*command);
  command->footer(
      "A pose is captured when the part is held still. Ctrl+C ends and keeps what there is.\n"
      "Example:\n  hexoderm-cli capture --source sim:x17 --auto --poses 4 -o arm.hexo\n"
      "  hexoderm-cli capture --source sim:robot --auto --poses 8 -o arm.hexo\n"
      "  hexoderm-cli solve arm.hexo -o arm.calibration.json");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
