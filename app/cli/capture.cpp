#include "app/cli/command.h"

#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/capture/live_capture.h"
#include "hexoderm/device/sources/open_source.h"

#include <chrono>
#include <iostream>
#include <stop_token>
#include <thread>
#include <utility>
#include <variant>

namespace hexoderm::cli {
namespace {

constexpr const char* kLastWords =
    "hexoderm-cli: ended while something was held up; every pose that was reported as captured is in the file\n";

/// Says on standard error what goes on.
class Remarks {
 public:
  explicit Remarks(const Common& common) : common_(common), offences_(common) {}

  void operator()(const CaptureBegun& begun) {
    is_begun_ = true;
    common_.note(begun.skin.device.english() + ": " + counted(begun.skin.neighbors.size(), "cell"));
  }
  void operator()(const SourceStatus& status) {
    offences_.show(status.offences);
    if (std::exchange(state_, status.state) == status.state) return;
    if (!is_begun_) {
      common_.progress(status.message.english());
    } else if (status.state != SourceState::Streaming && status.state != SourceState::Stopped) {
      common_.note(status.message.english());
    }
  }
  void operator()(const HoldStatus& hold) { common_.progress(hold.message.english()); }
  void operator()(const NoPose& wait) {
    common_.logNote("No pose for " + formatFixed(wait.duration_s, 0) + " s. " + wait.why.english());
  }
  void operator()(const NoReadings& wait) {
    common_.note("No readings for " + formatFixed(wait.duration_s, 0) + " s. " + wait.why.english());
  }
  void operator()(const PoseAdvised& next) { common_.note("Next: " + next.advice.english()); }
  void operator()(const WorkflowEvent& event) { std::visit(*this, event); }
  void operator()(const PoseKept& kept) {
    const CapturedPose& captured = kept.captured;
    const std::string pose = "Pose " + toString(captured.pose->id);
    std::string text = pose + " captured: " + counted(captured.pose->samples.size(), "cell");
    if (!captured.silent_cells.empty()) text += ", silent " + listText(captured.silent_cells);
    if (captured.repeats) {
      text += "; it repeats pose " + toString(*captured.repeats) + " (" + degrees(captured.repeat_angle_rad, 1) + ")";
    }
    common_.note(text);
    for (const OddCell& odd : captured.odd_cells) common_.note(describe(odd).english());
    if (!kept.without_raw.empty()) {
      common_.note(pose + " is kept without its raw samples: " + kept.without_raw.english());
    }
  }
  void operator()(const FileRefused& refused) { common_.note(refused.why.english() + ". Trying again."); }
  void operator()(const FileRenewed& renewed) { common_.note(renewed.what.english() + "."); }
  void operator()(const RecordingEnded& ended) { common_.complain(ended.why.english() + "; the capture goes on"); }
  void operator()(const SkinChanged& changed) {
    common_.note(changed.other_model ? "The device says that it has another cell model; poses stay."
                                     : "The device says that its topology has changed; poses stay.");
  }
  void operator()(const TurnRefused& refused) {
    common_.note("The device does not turn there: " + refused.why.english());
  }
  /// Of the others nothing is said: LiveCapture itself deals with them.
  template <class Event>
  void operator()(const Event& /*event*/) {}

 private:
  const Common& common_;
  ProtocolViolationNotes offences_;
  bool is_begun_ = false;
  SourceState state_{};
};

Json toJson(const BlockedTime& time) {
  Json json = {{"by", blockerName(time.blocker)}, {"for_s", time.duration_s}};
  if (time.cell != CellId()) {
    json["cell"] = time.cell.value();
    json["cell_for_s"] = time.cell_s;
  }
  json["message"] = time.message.english();
  return json;
}

Json toJson(const StillnessStatistics& ledger) {
  const auto odd_json = [](const OddCell& odd) -> Json {
    return {{"cell", odd.cell.value()}, {"is", oddCellName(odd.kind)}, {"message", describe(odd).english()}};
  };
  Json json = {{"watched_s", ledger.watched_s()},
               {"still_s", ledger.still_s()},
               {"blocked", arrayOf(ledger.blocked(), [](const BlockedTime& time) { return toJson(time); })}};
  if (ledger.last()) json["restarts"] = ledger.last()->restarts;
  json["odd_cells"] = ledger.last() ? arrayOf(ledger.last()->stillness.odd_cells, odd_json) : Json::array();
  return json;
}

/// Why there is no pose.
void printWhatBlocked(const StillnessStatistics& ledger) {
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

void print(const LiveCaptureState& capture, const LiveCaptureOptions& options, const Common& common) {
  const Session& session = *capture.session;
  const SourceStatus& status = capture.source;
  if (common.json) {
    Json json = {{"file", options.file.string()},
                 {"device", capture.device.english()},
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
                 {"offences", cli::toJson(status.offences)},
                 {"hold", toJson(capture.holds)}};
    if (!capture.recording_error.empty()) json["recording_error"] = capture.recording_error.english();
    json["verdict"] = capture.result ? cli::toJson(capture.result->assessment) : Json();
    printJson(json);
    return;
  }
  std::cout << counted(session.poses().size(), "pose") << " of " << counted(session.neighbors().size(), "cell")
            << " in " << forTerminal(options.file.string()) << '\n';
  if (status.lost_samples + status.late_frames + status.rejected_messages + status.reconnects > 0) {
    std::cout << "On the way: " << status.lost_samples << " samples lost, " << status.late_frames << " frames late, "
              << status.rejected_messages << " messages rejected, " << status.reconnects << " reconnects\n";
  }
  if (status.dropped_by_device > 0) {
    std::cout << "The device could not send " << status.dropped_by_device << " samples.\n";
  }
  if (session.poses().empty()) printWhatBlocked(capture.holds);
  if (status.skin_changes > 0) {
    std::cout << "The device described other cells or links " << counted(status.skin_changes, "time") << ".\n";
  }
  if (status.clock_restarts > 0) {
    std::cout << "The device's clock was set back " << counted(status.clock_restarts, "time") << ".\n";
  }
  for (const ProtocolViolation& offence : status.offences) {
    std::cout << "The device did something wrong " << counted(offence.count, "time") << " ("
              << offenceName(offence.kind) << "): " << inWords(offence) << '\n';
  }
  if (capture.result) {
    printVerdict(capture.result->assessment);
  } else if (!session.poses().empty()) {
    std::cout << "Ended before it was solved; \"hexoderm-cli solve\" does that.\n";
  }
}

/// LiveCapture refuses such names too, but does not know what the option is called.
void requireSessionName(const std::string& output) {
  if (output == kStandardOutput) {
    throw InvalidArgument("-o -: a capture is kept in a file (*.hexo) while it goes on: give the name of one");
  }
  if (!output.ends_with(".hexo")) {
    throw InvalidArgument("-o: expected a name that ends in .hexo, found \"" + output + "\"");
  }
}

/// The state at the end of the capture, which has a session then.
LiveCaptureState takePoses(const LiveCaptureOptions& options, const Common& common) {
  constexpr std::chrono::milliseconds kLookEvery(20);
  constexpr std::chrono::milliseconds kGrace(500);  // to solve the poses: enough for all but very large skins
  requireSessionName(options.file.string());
  endOnInterrupt(kLastWords);
  // A recording is an input file; devices complain in their own way.
  std::unique_ptr<SkinSource> source = asInput([&] { return openSkinSource(options.source); });
  requireReplaceable(options.record_to, "--record " + options.record_to.string());  // the source may read it
  Remarks remarks(common);
  LiveCapture capture(options, std::move(source),
                      [&remarks](const LiveCaptureEvent& event) { std::visit(remarks, event); });
  common.progress("Connecting to " + options.source + " ...");
  asInput([&] { capture.start(); });

  std::stop_source interrupted;
  std::stop_source out_of_time;
  const std::jthread watch([&](const std::stop_token& done) {
    while (!done.stop_requested() && !isInterrupted()) std::this_thread::sleep_for(kLookEvery);
    interrupted.request_stop();
    const auto end = std::chrono::steady_clock::now() + kGrace;
    while (!done.stop_requested() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kLookEvery);
    out_of_time.request_stop();
  });
  try {
    while (capture.next(interrupted.get_token(), out_of_time.get_token())) continue;
    capture.close(out_of_time.get_token());
    if (!capture.state().session) throw DeviceError(options.source, capture.state().status);
  } catch (...) {
    common.endProgress();
    LiveCaptureState end = capture.state();
    if (!end.recording_error.empty() && end.session) return end;  // it was said, and all else went well
    // A program that reads the JSON is told what a person is told on standard error.
    if (common.json && !end.session) {
      printJson({{"source", options.source},
                 {"poses", 0},
                 {"status", end.source.message.english()},
                 {"rejected_messages", end.source.rejected_messages},
                 {"offences", cli::toJson(end.source.offences)}});
    }
    throw;
  }
  common.endProgress();
  return capture.state();
}

int run(const LiveCaptureOptions& options, const Common& common) {
  const LiveCaptureState capture = takePoses(options, common);
  print(capture, options, common);
  if (!capture.recording_error.empty()) return kStorage;
  return capture.result ? exitCodeOf(capture.result->assessment) : kNotGoodEnough;
}

}  // namespace

Session captureSession(const LiveCaptureOptions& options, const Common& common) {
  LiveCaptureState capture = takePoses(options, common);
  if (capture.session->poses().empty() && !common.json) printWhatBlocked(capture.holds);
  return *std::move(capture.session);
}

void addCapture(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<LiveCaptureOptions>(
      app, common, "capture", "Take the poses of a skin that is connected, or of a recording",
      "A pose is captured when the part is held still. Ctrl+C ends and keeps what there is.\n"
      "Example:\n  hexoderm-cli capture --source sim:x17 --auto --poses 4 -o arm.hexo\n"
      "  hexoderm-cli capture --source sim:robot --auto --poses 8 -o arm.hexo\n"
      "  hexoderm-cli solve arm.hexo -o arm.calibration.json",
      run);
  command.add_option("--source", options.source, sourceKindsText())->required();
  takeWholeNumbers(
      command.add_option("--poses", options.poses,
                         "End after so many (default: at the stream's end or Ctrl+C; with --auto when they are good)"));
  command.add_flag("--auto", options.automatic, "The device turns itself, to where each pose helps most");
  command.add_flag("--keep-raw", options.keep_raw, "Keep every sample of the poses in the session too");
  addOutput(command, "--record", options.record_to, "Write all that the device sends to this file, for replay:FILE");
  takeNumbersAbove(
      addWithDefault(
          command, "--timeout", options.timeout_s,
          "Seconds to wait for a device to describe itself; with --auto also for each pose, whatever turns it refuses"),
      0, kLongestWait_s);
  addOutput(command, "-o,--output", options.file, "Session to make (*.hexo)")->required();
}

}  // namespace hexoderm::cli
