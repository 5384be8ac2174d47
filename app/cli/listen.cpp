#include "app/cli/command.h"

#include "hexoderm/base/interrupt.h"
#include "hexoderm/device/listening.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/sources/open_source.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hexoderm::cli {
namespace {

/// Commands that `listen` sends to a device to see how it answers. Outcomes come from the source's thread.
class CommandTrial {
 public:
  struct Named {
    std::string name;  ///< as in skinwire.proto, and what is asked: "set_led of cell 5"
    SkinCommand command;
  };
  explicit CommandTrial(std::vector<Named> commands) : commands_(std::move(commands)) {}

  /// Sends all of them, the first time; the device has described itself.
  void sendOnce(SkinSource& source) {
    if (!sent_.empty()) return;
    for (const Named& named : commands_) {
      const Clock::time_point now = Clock::now();
      sent_.push_back({source.send(named.command), now});
    }
  }

  void add(const CommandOutcome& outcome) {
    const std::lock_guard lock(mutex_);
    answers_[outcome.command] = {outcome, Clock::now()};
  }

  /// Whether every command that was sent has its outcome.
  [[nodiscard]] bool isAnswered() const {
    const std::lock_guard lock(mutex_);
    return std::ranges::all_of(sent_, [this](const Sent& sent) { return answers_.contains(sent.number); });
  }

  /// A command and how it was answered.
  struct Answered {
    std::string name;
    bool is_sent = false;
    bool is_done = false;
    std::string message{};
    std::optional<double> after_s{};  ///< nothing: no answer so far
  };

  [[nodiscard]] std::vector<Answered> answers() const {
    const std::lock_guard lock(mutex_);
    std::vector<Answered> all;
    for (std::size_t k = 0; k < commands_.size(); ++k) {
      Answered& command = all.emplace_back(Answered{commands_[k].name, !sent_.empty()});
      const auto found = sent_.empty() ? answers_.end() : answers_.find(sent_[k].number);
      if (found == answers_.end()) continue;
      const auto& [outcome, at] = found->second;
      command.is_done = outcome.done;
      command.message = outcome.message.english();
      command.after_s = std::chrono::duration<double>(at - sent_[k].at).count();
    }
    return all;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Sent {
    std::uint32_t number = 0;
    Clock::time_point at;
  };
  struct Answer {
    CommandOutcome outcome;
    Clock::time_point at;
  };

  std::vector<Named> commands_;
  std::vector<Sent> sent_;  ///< of all commands, or none
  mutable std::mutex mutex_;
  std::map<std::uint32_t, Answer> answers_;
};

/// No cell is as quick.
constexpr double kMaxRate_hz = 1e6;

struct ListenOptions {
  std::string source;
  double time_s = 5;
  std::uint32_t light = 0;  ///< a cell; 0: none
  double rate_hz = 0;       ///< 0: as it is
  bool explore = false;
};

std::vector<CommandTrial::Named> commandsOf(const ListenOptions& options) {
  constexpr std::uint8_t kFull = 255;
  std::vector<CommandTrial::Named> commands;
  if (options.light > 0) {
    commands.push_back(
        {"set_led of cell " + std::to_string(options.light), SetLed{CellId(options.light), kFull, kFull, kFull}});
  }
  if (options.rate_hz > 0) {
    commands.push_back({"set_rate to " + formatExact(options.rate_hz) + " Hz", SetRate{options.rate_hz}});
  }
  if (options.explore) commands.push_back({"explore_again", ExploreAgain{}});
  return commands;
}

constexpr const char* kLastLine = "hexoderm-cli: ended while something was held up, without a report\n";

/// Passes on what is heard, and keeps the newest status for the thread that waits.
class Ear final : public SkinListener {
 public:
  explicit Ear(CommandTrial& trial) : trial_(trial) {}

  void onSkin(const SkinDescription& skin) override { listening_.onSkin(skin); }
  void onFrame(const SampleFrame& frame) override { listening_.onFrame(frame); }
  void onStatus(const SourceStatus& status) override {
    listening_.onStatus(status);
    const std::lock_guard lock(mutex_);
    status_ = status;
    was_connected_ =
        was_connected_ || (status.state != SourceState::Stopped && status.state != SourceState::Connecting);
  }
  void onCommandOutcome(const CommandOutcome& outcome) override { trial_.add(outcome); }

  [[nodiscard]] SourceStatus status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }
  [[nodiscard]] bool wasConnected() const {
    const std::lock_guard lock(mutex_);
    return was_connected_;
  }
  /// After the source has stopped.
  [[nodiscard]] ListeningReport report() const { return listening_.report(); }

 private:
  CommandTrial& trial_;
  Listening listening_;
  mutable std::mutex mutex_;
  SourceStatus status_;
  bool was_connected_ = false;
};

/// Until the time is over, the stream ends or the user ends it. What is wrong is said as soon as it is known.
void listenTo(const Ear& ear, SkinSource& source, CommandTrial& trial, double time_s, const Common& common) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kForAnswers(4);  // a source waits for 3 s, and longer for a device that is at it
  constexpr std::chrono::milliseconds kLookEvery(50);
  ProtocolViolationNotes notes(common);
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s));
  while (true) {
    const SourceStatus status = ear.status();
    notes.show(status.offences);
    const bool is_over = status.state == SourceState::Ended || status.state == SourceState::Incompatible;
    if (status.state == SourceState::Streaming) trial.sendOnce(source);
    const Clock::time_point now = Clock::now();
    if (is_over || isInterrupted() || now >= end + kForAnswers || (now >= end && trial.isAnswered())) break;
    common.progress(status.message.english());
    std::this_thread::sleep_for(kLookEvery);
  }
  common.endProgress();
}

constexpr double kMilli = 1000;

Json spreadJson(const std::optional<Spread>& spread, double factor = 1) {
  return orNull(spread, [&](const Spread& s) -> Json {
    return {{"min", s.least * factor}, {"median", s.median * factor}, {"max", s.most * factor}};
  });
}

Json toJson(const CellHeard& cell) {
  return {{"cell", cell.cell.value()},
          {"readings", cell.readings},
          {"rate_hz", orNull(cell.rate_hz)},
          {"norm_g", spreadJson(cell.norm_g)},
          {"mean_g", orNull(cell.mean_u, listOf)},
          {"noise_mg", orNull(cell.noise_g, kMilli)}};
}

Json toJson(const CommandTrial::Answered& command) {
  return {{"command", command.name},
          {"sent", command.is_sent},
          {"done", command.is_done},
          {"message", command.message},
          {"after_s", orNull(command.after_s)}};
}

Json toJson(const ListeningReport& report, const CommandTrial& trial, const ListenOptions& options) {
  const SourceStatus& status = report.status;
  return {
      {"source", options.source},
      {"ready", report.obstacle.empty()},
      {"obstacle", report.obstacle.english()},
      {"remarks", textsOf(report.remarks)},
      {"status", status.message.english()},
      {"device", report.device},
      {"cell_model", report.cell_model},
      {"rate_hz", spreadJson(report.rate_hz)},
      {"norm_g", spreadJson(report.norm_g)},
      {"noise_mg", spreadJson(report.noise_g, kMilli)},
      {"links",
       {{"agreed", report.links_agreed}, {"one_sided", report.links_one_sided}, {"unusable", report.links_unusable}}},
      {"frames", status.frames},
      {"lost_samples", status.lost_samples},
      {"dropped_by_device", status.dropped_by_device},
      {"late_frames", status.late_frames},
      {"undescribed_samples", status.undescribed_samples},
      {"unknown_samples", status.unknown_samples},
      {"rejected_messages", status.rejected_messages},
      {"reconnects", status.reconnects},
      {"silent_cells", numbersOf(report.silent_cells)},
      {"cells", arrayOf(report.cells, [](const CellHeard& cell) { return toJson(cell); })},
      {"slowness", orNull(report.slowness)},
      {"commands", arrayOf(trial.answers(), [](const auto& answered) { return toJson(answered); })},
      {"offences", cli::toJson(report.offences)}};
}

void printSpread(const std::string& name, const std::optional<Spread>& spread, const std::string& unit, int decimals,
                 double factor = 1) {
  std::cout << name << ": ";
  if (!spread) {
    std::cout << "not known\n";
    return;
  }
  const auto figure = [&](double value) { return formatFixed(value * factor, decimals); };
  std::cout << figure(spread->median) << ' ' << unit << " in the median, " << figure(spread->least) << " to "
            << figure(spread->most) << '\n';
}

constexpr std::size_t kMax = 32;  // cells that are listed

void printSilent(const std::vector<CellId>& cells) {
  if (cells.empty()) return;
  std::cout << "Silent: ";
  if (cells.size() > kMax) {
    std::cout << cells.size() << " cells\n";
  } else {
    std::cout << (cells.size() == 1 ? "cell " : "cells ") << listText(cells) << '\n';
  }
}

void printCells(const std::vector<CellHeard>& cells) {
  std::cout << "Cell  readings  rate (Hz)  norm (g)  noise (mg)    x (g)    y (g)    z (g)\n";
  const auto column = [](const std::string& text, std::size_t width) {
    return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
  };
  const auto figure = [&](const std::optional<double>& value, int decimals, std::size_t width) {
    return column(value ? formatFixed(*value, decimals) : "-", width);
  };
  for (std::size_t k = 0; k < cells.size() && k < kMax; ++k) {
    const CellHeard& cell = cells[k];
    const std::optional<double> norm = cell.norm_g ? std::optional(cell.norm_g->median) : std::nullopt;
    const std::optional<double> noise_mg = cell.noise_g ? std::optional(*cell.noise_g * kMilli) : std::nullopt;
    std::cout << column(toString(cell.cell), 4) << column(std::to_string(cell.readings), 10)
              << figure(cell.rate_hz, 1, 11) << figure(norm, 3, 10) << figure(noise_mg, 1, 12);
    for (int axis = 0; axis < 3; ++axis) {
      std::cout << figure(cell.mean_u ? std::optional((*cell.mean_u)[axis]) : std::nullopt, 3, 9);
    }
    std::cout << '\n';
  }
  std::cout << "x, y and z are means along the axes of the cell.\n";
  if (cells.size() > kMax) std::cout << "... and " << cells.size() - kMax << " more; --json has all\n";
}

void print(const CommandTrial::Answered& command) {
  std::cout << "Command " << command.name << ": ";
  if (!command.after_s) {
    std::cout << (command.is_sent ? "no answer yet\n" : "was not sent, for the device has not described itself\n");
    return;
  }
  std::cout << (command.is_done ? "done" : "not done") << " after " << formatFixed(*command.after_s, 2) << " s"
            << (command.message.empty() ? "" : ": ") << command.message << '\n';
}

void print(const ListeningReport& report, const CommandTrial& trial) {
  const SourceStatus& status = report.status;
  if (report.is_described) {
    std::cout << report.device << ": " << counted(report.cells.size(), "cell") << " of model " << report.cell_model
              << '\n';
    std::cout << "Links: " << report.links_agreed << " that both ends report, " << report.links_one_sided
              << " that only one end reports, " << report.links_unusable << " that can't be used otherwise\n";
    printSpread("Rate of a cell", report.rate_hz, "Hz", 1);
    printSpread("Norm of the readings", report.norm_g, "g", 3);
    printSpread("Noise of a cell", report.noise_g, "mg", 1, kMilli);
    printSilent(report.silent_cells);
  }
  std::cout << "On the way: " << status.frames << " frames, " << status.lost_samples << " samples lost, "
            << status.late_frames << " frames late, " << status.undescribed_samples
            << " samples before the description, " << status.unknown_samples << " samples of unknown cells, "
            << status.rejected_messages << " messages rejected, " << status.reconnects << " reconnects\n";
  if (status.dropped_by_device > 0) {
    std::cout << "The device could not send " << status.dropped_by_device << " samples.\n";
  }
  if (report.is_described) printCells(report.cells);
  std::cout << "Offences: " << (report.offences.empty() ? "none" : std::to_string(report.offences.size())) << '\n';
  for (const ProtocolViolation& offence : report.offences) {
    std::cout << "  " << offenceName(offence.kind) << " (" << offence.count << "): " << inWords(offence) << '\n';
  }
  for (const CommandTrial::Answered& command : trial.answers()) print(command);
  for (const Message& remark : report.remarks) std::cout << remark << '\n';
  if (report.obstacle.empty()) {
    std::cout << "A calibration could begin.\n";
  } else {
    std::cout << "A calibration could not begin. " << report.obstacle << '\n';
  }
}

int run(const ListenOptions& options, const Common& common) {
  endOnInterrupt(kLastLine);
  const std::unique_ptr<SkinSource> source = asInput([&] { return openSkinSource(options.source); });
  CommandTrial trial(commandsOf(options));
  Ear ear(trial);
  common.progress("Connecting to " + options.source + " ...");
  source->start(ear);
  listenTo(ear, *source, trial, options.time_s, common);
  const SourceStatus last = ear.status();
  source->stop();
  if (!ear.wasConnected() && !isInterrupted()) throw DeviceError(last.message);
  ListeningReport report = ear.report();
  report.status.message = last.message;  // not that it was stopped
  if (common.json) {
    printJson(toJson(report, trial, options));
  } else {
    print(report, trial);
  }
  return report.obstacle.empty() ? kDone : kNotGoodEnough;
}

}  // namespace

void addListen(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<ListenOptions>(
      app, common, "listen", "Listen to a device, and say what it does wrong: for those who make one",
      "The first offence of each kind is said at once on standard error; rates, losses, norms, noise, links and the\n"
      "counts of all offences follow at the end. Exit code 0: a calibration could begin; 1: it could not, and why;\n"
      "4: no device there.\n"
      "Example:\n  hexoderm-cli listen sim:x17 --for 1",
      run);
  command.add_option("source", options.source, sourceKindsText())->required();
  takeNumbersAbove(
      addWithDefault(command, "--for", options.time_s, "Seconds to listen; Ctrl+C ends it before, with its report"), 0,
      kLongestWait_s);
  takeWholeNumbers(
      command.add_option("--light", options.light, "Light this cell, and say how the device answers (SetLed)"), 1);
  takeNumbersAbove(
      command.add_option("--rate", options.rate_hz, "Ask for so many samples a second of each cell (SetRate)"), 0,
      kMaxRate_hz);
  command.add_flag("--explore", options.explore, "Ask the device to explore its neighbours again (ExploreAgain)");
}

}  // namespace hexoderm::cli
