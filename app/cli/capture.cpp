#include "app/cli/capture_events.h"
#include "app/cli/command.h"

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/advice/pose_advisor.h"
#include "hexoderm/reconstruction/advice/pose_coverage.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>

namespace hexoderm::cli {
namespace {

struct CaptureOptions {
  std::string source;
  std::string output;
  std::string recording;
  std::size_t poses = 0;
  bool automatic = false;
  bool keep_raw = false;
  double timeout_s = 30;
};

std::atomic<bool> interrupted = false;

/// Ctrl+C ends the capture and keeps what there is.
class InterruptGuard {
 public:
  InterruptGuard() {
    interrupted = false;
    before_ = std::signal(SIGINT, [](int) { interrupted = true; });
  }
  ~InterruptGuard() { std::signal(SIGINT, before_); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  void (*before_)(int) = nullptr;
};

std::string cellsInWords(std::size_t count) { return std::to_string(count) + (count == 1 ? " cell" : " cells"); }

/// One run of the command: what the events lead to.
class Capture {
  using Clock = std::chrono::steady_clock;

 public:
  Capture(const CaptureOptions& options, const Common& common, SkinSource& source, CaptureEvents& events)
      : options_(options), common_(common), source_(source), events_(events) {}

  /// Returns when the poses are good, the stream is over, or the user ends it.
  void run() {
    const auto patience = std::chrono::duration<double>(options_.timeout_s);
    Clock::time_point last_progress = Clock::now();
    while (!done_ && !interrupted) {
      const std::optional<CaptureEvent> event = events_.next(std::chrono::milliseconds(100));
      if (event) std::visit([this](const auto& what) { handle(what); }, *event);
      if (made_progress_ || disk_is_full_since_) last_progress = Clock::now();
      made_progress_ = false;
      if (disk_is_full_since_ && Clock::now() >= next_try_) tryAgain();
      if (!event && status_.state == SourceState::Ended) break;
      if (status_.state == SourceState::Incompatible) throw DeviceError(source_.address() + ": " + status_.text);
      if (Clock::now() - last_progress > patience && (!session_ || options_.automatic)) {
        throw DeviceError(source_.address() + ": nothing for " + formatFixed(options_.timeout_s, 0) + " s. " +
                          (session_ ? hold_.text : status_.text));
      }
    }
  }

  /// Waits until all that was captured is on disk. Throws StorageError if something can't be.
  void finish() {
    common_.endProgress();
    while (store_ && waiting_ > 0 && !disk_is_full_since_) handleStored(std::chrono::milliseconds(100));
    store_.reset();  // tries for the last time
    while (handleStored(std::chrono::milliseconds(0))) continue;
    if (!lost_.empty()) throw StorageError(lost_);
  }

  [[nodiscard]] const std::optional<Session>& session() const { return session_; }
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& result() const { return result_; }
  [[nodiscard]] const SourceStatus& status() const { return status_; }
  [[nodiscard]] const std::string& device() const { return device_; }

 private:
  void handle(const SkinDescription& skin) {
    made_progress_ = true;
    if (!session_) {
      device_ = skin.device;
      can_turn_ = skin.can_turn;
      session_.emplace(*skin.model, skin.neighbors, SourceDescription{skin.device + ", " + source_.address(), "", ""});
      if (skin.truth) session_->setTruth(*skin.truth);
      without_poses_ = reconstruct(*session_->snapshot());
      store_ = std::make_unique<SessionRecorder>(SessionStore::create(options_.output, *session_));
      common_.endProgress();
      common_.note(device_ + ": " + cellsInWords(skin.neighbors.size()));
      if (options_.automatic && !can_turn_) {
        throw DeviceError(source_.address() + ": --auto needs a device that turns by itself, and this one can't");
      }
      return;
    }
    if (skin.neighbors == session_->neighbors()) return;
    session_->setSkin(*skin.model, skin.neighbors);
    without_poses_ = reconstruct(*Session(*skin.model, skin.neighbors).snapshot());
    store_->append({SetSkin{skin.model, skin.neighbors}}, {});
    common_.note("The device says that its topology has changed; poses stay.");
  }

  void handle(const CapturedPose& captured) {
    made_progress_ = true;
    if (!session_ || (options_.poses > 0 && session_->poses().size() >= options_.poses)) return;
    auto labelled = std::make_shared<PoseCapture>(*captured.pose);
    if (labelled->label.empty()) labelled->label = poseLabel(*without_poses_, *labelled);
    session_->addPose({labelled, false});
    AddPose add{{labelled, false}};
    if (options_.keep_raw) add.raw = std::make_shared<const std::vector<SampleFrame>>(captured.frames);
    ++waiting_;
    store_->append({add}, [this, id = captured.pose->id](const StoreOutcome& outcome) {
      events_.push(Stored{id, outcome});
    });
    captured_.emplace(captured.pose->id, captured);
  }

  bool handleStored(std::chrono::milliseconds patience) {
    const std::optional<CaptureEvent> event = events_.next(patience);
    if (!event) return false;
    if (const auto* stored = std::get_if<Stored>(&*event)) handle(*stored);
    return true;
  }

  /// Only now it counts as captured.
  void handle(const Stored& stored) {
    made_progress_ = true;
    if (stored.outcome.is_kept) {
      // The disk may have room again in a moment; until then the pose waits in memory.
      constexpr auto kPatienceWithDisk = std::chrono::seconds(10);
      if (!disk_is_full_since_) {
        disk_is_full_since_ = Clock::now();
        next_try_ = *disk_is_full_since_ + kBetweenTries;
        common_.endProgress();
        common_.note(stored.outcome.error + ". Trying again.");
      }
      done_ = Clock::now() - *disk_is_full_since_ >= kPatienceWithDisk;
      return;
    }
    --waiting_;
    if (!stored.outcome.error.empty()) {
      lost_ = stored.outcome.error;
      done_ = true;
      return;
    }
    disk_is_full_since_.reset();
    announce(captured_.at(stored.pose));
    if (!stored.outcome.without_raw.empty()) {
      common_.note("Pose " + toString(stored.pose) + " is kept without its raw samples: " + stored.outcome.without_raw);
    }
    captured_.erase(stored.pose);
    if (waiting_ == 0) decide();
  }

  void tryAgain() {
    next_try_ = Clock::now() + kBetweenTries;
    store_->retry();
  }

  void announce(const CapturedPose& captured) const {
    common_.endProgress();
    std::string text =
        "Pose " + toString(captured.pose->id) + " captured: " + cellsInWords(captured.pose->samples.size());
    if (!captured.silent_cells.empty()) text += ", silent " + listInWords(captured.silent_cells);
    if (captured.repeats) {
      text += "; it repeats pose " + toString(*captured.repeats) + " (" + degrees(captured.repeat_angle_rad, 1) + ")";
    }
    common_.note(text);
    for (const OddCell& odd : captured.odd_cells) common_.note(describe(odd));
  }

  /// Judges the poses so far, and decides what comes next.
  void decide() {
    result_ = reconstruct(*session_->snapshot(), {}, result_.get());
    const std::size_t count = session_->poses().size();
    // A pose costs a device nothing: where a person could stop, it goes on until the result is good.
    const bool is_good = enoughPoses(*result_) && result_->verdict.level == VerdictLevel::Good;
    done_ =
        options_.poses > 0 ? count >= options_.poses : options_.automatic && (is_good || count >= kMostPosesByItself);
    if (done_ || result_->patches.empty()) return;
    advised_in_ = &*std::ranges::max_element(result_->patches, {},
                                             [](const PatchReconstruction& patch) { return patch.cells.size(); });
    advise();
  }

  void advise() {
    std::vector<Eigen::Vector3d> seen;
    for (const GravityDirection& gravity : advised_in_->gravity) seen.push_back(gravity.g_o);
    const PoseAdvice advice = adviseNextPose(session_->model(), seen, unreachable_);
    common_.note("Next: " + adviceInWords(advice, *result_));
    if (!options_.automatic) return;
    asked_up_ = advice.up;
    asked_ = source_.send(TurnTo{advised_in_->origin, advice.up});
  }

  /// A direction that can't be reached is skipped, and the next best asked for.
  void handle(const CommandOutcome& outcome) {
    if (asked_ == 0 || outcome.command != asked_) return;
    asked_ = 0;
    made_progress_ = true;
    if (outcome.done) return;
    common_.endProgress();
    common_.note("The device does not turn there: " + outcome.text);
    constexpr std::size_t kMostRefusals = 10;
    unreachable_.push_back(asked_up_);
    if (unreachable_.size() > kMostRefusals) {
      throw DeviceError(source_.address() + ": refused to turn " + std::to_string(unreachable_.size()) +
                        " times, the last time: " + outcome.text);
    }
    advise();
  }

  void handle(const SourceStatus& status) {
    if (status.state != status_.state && !session_) common_.progress(status.text);
    if (status.state != status_.state && session_ && status.state != SourceState::Streaming &&
        status.state != SourceState::Stopped) {
      common_.endProgress();
      common_.note(status.text);
    }
    status_ = status;
  }

  void handle(const HoldStatus& hold) {
    hold_ = hold;
    common_.progress(hold.text);
  }

  const CaptureOptions& options_;
  const Common& common_;
  SkinSource& source_;
  CaptureEvents& events_;

  std::optional<Session> session_;
  std::unique_ptr<SessionRecorder> store_;
  std::map<PoseId, CapturedPose> captured_;  ///< not yet on disk
  std::size_t waiting_ = 0;
  std::string lost_;  ///< why something is not on disk and never will be

  static constexpr auto kBetweenTries = std::chrono::seconds(1);
  std::optional<Clock::time_point> disk_is_full_since_;  ///< when it first refused a pose that still waits
  Clock::time_point next_try_{};
  std::string device_;
  bool can_turn_ = false;
  SourceStatus status_;
  HoldStatus hold_;

  /// Names the poses: unlike the result, the same for the same recording however fast it is played.
  std::shared_ptr<const Reconstruction> without_poses_;
  std::shared_ptr<const Reconstruction> result_;
  const PatchReconstruction* advised_in_ = nullptr;
  std::vector<Eigen::Vector3d> unreachable_;
  Eigen::Vector3d asked_up_ = Eigen::Vector3d::Zero();
  std::uint32_t asked_ = 0;  ///< the turn that was asked for; 0: none
  bool made_progress_ = false;
  bool done_ = false;
};

void print(const Capture& capture, const CaptureOptions& options, const Common& common) {
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
                                   {"reconnects", status.reconnects}};
    json["verdict"] = capture.result() ? toJson(capture.result()->verdict) : nlohmann::ordered_json();
    printJson(json);
    return;
  }
  std::cout << session.poses().size() << (session.poses().size() == 1 ? " pose" : " poses") << " of "
            << cellsInWords(session.neighbors().size()) << " in " << options.output << '\n';
  if (status.lost_samples + status.late_frames + status.rejected_messages + status.reconnects > 0) {
    std::cout << "On the way: " << status.lost_samples << " samples lost, " << status.late_frames << " frames late, "
              << status.rejected_messages << " messages broken, " << status.reconnects << " reconnects\n";
  }
  if (status.dropped_by_device > 0) {
    std::cout << "The device could not send " << status.dropped_by_device << " samples.\n";
  }
  if (capture.result()) printVerdict(capture.result()->verdict);
}

int run(const CaptureOptions& options, const Common& common) {
  if (!options.output.ends_with(".hexo")) {
    throw InvalidArgument("-o: expected a name that ends in .hexo, found \"" + options.output + "\"");
  }
  if (std::filesystem::exists(options.output)) {
    throw StorageError(options.output + ": exists already; a capture never replaces a session");
  }
  const std::unique_ptr<SkinSource> source = openSkinSource(options.source);
  PoseRecorderOptions recorder;
  recorder.keep_frames = options.keep_raw;
  CaptureEvents events(recorder);
  std::optional<StreamRecorder> recording;
  if (!options.recording.empty()) recording.emplace(options.recording, events);

  const InterruptGuard guard;
  Capture capture(options, common, *source, events);
  common.progress("Connecting to " + options.source + " ...");
  source->start(recording ? static_cast<SkinListener&>(*recording) : events);
  try {
    capture.run();
  } catch (...) {
    source->stop();
    capture.finish();  // captured poses stay
    throw;
  }
  source->stop();
  capture.finish();
  if (recording) recording->finish();
  if (!capture.session()) throw DeviceError(options.source + ": ended before a skin described itself");
  print(capture, options, common);
  return capture.result() ? exitCodeOf(capture.result()->verdict) : kNotGoodEnough;
}

}  // namespace

void addCapture(CLI::App& app, Common& common) {
  const auto options = std::make_shared<CaptureOptions>();
  CLI::App* command = app.add_subcommand("capture", "Take the poses of a skin that is connected, or of a recording");
  std::string kinds;
  for (const SourceKind& kind : sourceKinds()) kinds += (kinds.empty() ? "" : ", ") + std::string(kind.example);
  command->add_option("--source", options->source, kinds)->required();
  command->add_option("--poses", options->poses,
                      "End after so many (default: at the stream's end or Ctrl+C; with --auto when they are good)");
  command->add_flag("--auto", options->automatic, "The device turns itself, to where each pose helps most");
  command->add_flag("--keep-raw", options->keep_raw, "Keep every sample of the poses in the session too");
  command->add_option("--record", options->recording, "Write all that the device sends to this file, for replay:FILE");
  command
      ->add_option("--timeout", options->timeout_s,
                   "Seconds to wait for a device to describe itself; with --auto also for each pose")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "Session to make (*.hexo)")->required();
  common.addTo(*command);
  command->footer(
      "A pose is captured when the part is held still. Ctrl+C ends and keeps what there is.\n"
      "Example:\n  hexoderm-cli capture --source sim:x17 --auto --poses 4 -o arm.hexo\n"
      "  hexoderm-cli solve arm.hexo -o arm.calibration.json");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
