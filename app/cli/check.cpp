#include "app/cli/command.h"

#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/temporary_file.h"
#include "hexoderm/capture/live_capture.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/solve/checks/calibration_check.h"

#include <filesystem>
#include <iostream>
#include <optional>

namespace hexoderm::cli {
namespace {

struct CheckOptions {
  std::string calibration;
  std::string session;
  LiveCaptureOptions live;
};

/// Poses that are taken for the check; without -o they are kept only as long as it takes.
Session takePoses(const CheckOptions& options, const Common& common) {
  LiveCaptureOptions live = options.live;
  std::optional<TemporaryFolder> folder;
  if (live.file.empty()) {
    folder.emplace(std::filesystem::temp_directory_path(), "the poses to check");
    live.file = folder->path() / "check.hexo";
  }
  return captureSession(live, common);
}

CalibrationCheck checkAgainst(const Reconstruction& calibration, const Session& today, const CheckOptions& options) {
  try {
    return checkCalibration(calibration, *today.snapshot());
  } catch (const InvalidArgument& error) {
    // The two don't belong together.
    throw BadInput(located(options.calibration, error.message()));
  }
}

Json toJson(const CheckedCell& cell) {
  constexpr double kMilli = 1000;
  const auto& turn = cell.turn;
  const auto& drift = cell.drift;
  return {{"cell", cell.cell.value()},
          {"change", cellChangeName(cell.change)},
          {"words", cell.words.english()},
          {"poses", cell.poses},
          {"deviate", cell.deviate},
          {"turn_deg", turn ? Json(toDegrees(turn->angle_rad)) : Json()},
          {"turn_sigma_deg", turn ? Json(toDegrees(turn->sigma_rad)) : Json()},
          {"turn_at_least", turn ? Json(turn->at_least) : Json()},
          {"offset_drift_mg", drift ? listOf(kMilli * drift->offset_g) : Json()},
          {"offset_drift_sigma_mg", drift ? Json(kMilli * drift->sigma_g) : Json()},
          {"noticed_turn_deg", orNull(cell.noticed_turn_rad, toDegrees)}};
}

Json toJson(const CalibrationCheck& check, const CheckOptions& options) {
  return {{"calibration", options.calibration},
          {"poses_of", options.session.empty() ? options.live.source : options.session},
          {"poses", numbersOf(check.poses)},
          {"changed", check.changed},
          {"compared", check.compared},
          {"summary", check.summary.english()},
          {"advice", check.advice.english()},
          {"remarks", textsOf(check.remarks)},
          {"cells", arrayOf(check.cells, [](const CheckedCell& cell) { return toJson(cell); })}};
}

void print(const CalibrationCheck& check) {
  std::cout << counted(check.poses.size(), "pose") << " against the calibration of "
            << counted(check.cells.size(), "cell") << '\n';
  std::cout << "  cell   a turn is noticed from   now\n";
  for (const CheckedCell& cell : check.cells) {
    const std::string id = toString(cell.cell);
    const std::string noticed = cell.noticed_turn_rad ? degrees(*cell.noticed_turn_rad, 1) : "-";
    const std::size_t noticed_width = noticed == "-" ? 1 : noticed.size() - 1;  // the degree sign has two bytes
    std::cout << "  " << id << std::string(id.size() < 7 ? 7 - id.size() : 1, ' ') << noticed
              << std::string(noticed_width < 25 ? 25 - noticed_width : 1, ' ') << cell.words << '\n';
  }
  for (const Message& remark : check.remarks) std::cout << forTerminal(remark.english()) << '\n';
  std::cout << forTerminal(check.summary.english()) << '\n';
  if (!check.advice.empty()) std::cout << forTerminal(check.advice.english()) << '\n';
}

int run(const CheckOptions& options, const Common& common) {
  if (options.session.empty() == options.live.source.empty()) {
    throw InvalidArgument("check: give either a session or --source, for the poses to compare the calibration with");
  }
  const auto calibration = openCalibration(options.calibration);
  const Session today = options.session.empty() ? takePoses(options, common) : openSession(options.session);
  if (isInterrupted() && today.poses().size() < options.live.poses) {
    common.note("Interrupted: " + std::to_string(today.poses().size()) + " of " + counted(options.live.poses, "pose") +
                " taken, nothing is compared");
    return kEndedByForce;
  }
  const CalibrationCheck check = checkAgainst(*calibration, today, options);
  if (common.json) {
    printJson(toJson(check, options));
  } else {
    print(check);
  }
  return check.changed || !check.compared ? kNotGoodEnough : kDone;
}

}  // namespace

void addCheck(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<CheckOptions>(
      app, common, "check", "Does an old calibration still hold? Compare it, cell by cell, with one to three new poses",
      "The calibration is not changed. A part that sits otherwise on the robot as a whole is no change.\n"
      "Exit code 1: something is not as calibrated, or nothing could be told.\n"
      "Example:\n  hexoderm-cli check arm.calibration.json today.session.json\n"
      "  hexoderm-cli check arm.calibration.json --source tcp://localhost:7700 --poses 2",
      run);
  options.live.poses = 2;
  addInput(command, "calibration", options.calibration, "Calibration (*.calibration.json)")->required();
  addInput(command, "session", options.session, "Session with the new poses (*.hexo or *.session.json)");
  CLI::Option* source = command.add_option("--source", options.live.source, "Take the poses now: " + sourceKindsText());
  takeWholeNumbers(addWithDefault(command, "--poses", options.live.poses, "Poses to take"), 1, 100)->needs(source);
  command.add_flag("--auto", options.live.automatic, "The device turns itself")->needs(source);
  takeNumbersAbove(addWithDefault(command, "--timeout", options.live.timeout_s,
                                  "Seconds to wait for a device to describe itself; with --auto also for each pose"),
                   0, kLongestWait_s)
      ->needs(source);
  addOutput(command, "-o,--output", options.live.file, "Keep the poses that are taken in a session (*.hexo)")
      ->needs(source);
}

}  // namespace hexoderm::cli
