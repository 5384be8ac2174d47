#pragma once

#include "app/cli/json.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/session/session.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <streambuf>

namespace hexoderm {
struct LiveCaptureOptions;
}

namespace hexoderm::cli {

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kNotGoodEnough =
      1,  ///< the verdict is not_enough, not_trusted or failed, or a check found changes; the output is still written
  kUsage = 2,
  kBadInput = 3,
  kDevice = 4,
  kStorage = 5,
};

/// An input file could not be used: exit code 3, whatever the reason.
class BadInput : public Error {
  using Error::Error;
};

/// Options that every command has, and how it says things.
struct Common {
  bool json = false;
  bool quiet = false;
  int exit_code = kDone;  ///< set by the command that ran

  void addTo(CLI::App& command);
  /// A line on stderr that replaces the one before, if stderr is a terminal and --quiet is not given.
  void progress(const std::string& text) const;
  void endProgress() const;
  /// A remark on stderr in the place of the progress, unless --quiet. Both write what a terminal may be given
  /// (forTerminal()).
  void note(const std::string& text) const;
  /// What went wrong while the command goes on, on stderr, also with --quiet.
  void complain(const std::string& text) const;
  /// A remark where stderr is no terminal, which would show progress().
  void logNote(const std::string& text) const;
};

/// What the help calls the value of an option: a file that the command reads, and what it writes.
inline constexpr const char* kInput = "FILE";
inline constexpr const char* kOutput = "OUTPUT";
/// An option, or what stands without one, for a file to read, for a file to write, and with its default in the help.
template <class Value>
CLI::Option* addInput(CLI::App& command, const std::string& names, Value& file, const std::string& help) {
  return command.add_option(names, file, help)->type_name(kInput);
}
template <class Value>
CLI::Option* addOutput(CLI::App& command, const std::string& names, Value& file, const std::string& help) {
  return command.add_option(names, file, help)->type_name(kOutput);
}
template <class Value>
CLI::Option* addWithDefault(CLI::App& command, const std::string& names, Value& value, const std::string& help) {
  return command.add_option(names, value, help)->capture_default_str();
}

/// Before any work: InvalidArgument if an output is one of the inputs, standard input among them, or another output,
/// StorageError if it is a session.
void requireReplaceableOutputs(const CLI::App& command);
/// InvalidArgument if two outputs are the same file, or one is what SQLite keeps beside the other.
void requireApart(const std::string& a, const std::string& b);

/// The numbers that an option takes, ends included but for a bound that they are above. Parsing throws InvalidArgument
/// for all others, with the name of the option. Every option of numbers has one of these: the parser itself takes
/// numbers that are not finite or are negative, and an empty text for 0. Return the option.
CLI::Option* takeNumbers(CLI::Option* option, double least, double most);
CLI::Option* takeNumbersAbove(CLI::Option* option, double bound, double most);
CLI::Option* takeWholeNumbers(CLI::Option* option, std::uint64_t least = 0,
                              std::uint64_t most = std::numeric_limits<std::uint32_t>::max());
/// The option has to be a direction, x,y,z.
CLI::Option* takeDirection(CLI::Option* option);
/// Seconds to wait: 11 days.
inline constexpr double kLongestWait_s = 1e6;
/// The option takes texts for which `check` does not throw InvalidArgument.
template <class Check>
CLI::Option* takeTexts(CLI::Option* option, Check check) {
  return option->check([option, check](const std::string& text) {
    try {
      check(text);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(located(option->get_name(), error.message()));
    }
    return std::string();
  });
}
/// Runs `check` and names the option, with its value, in what it throws.
template <class Check>
void checkOption(const std::string& option, const std::string& value, Check check) {
  try {
    check();
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(option + " " + shortened(value, 80), error.message());
  }
}

/// As `-o`: standard output.
inline constexpr std::string_view kStandardOutput = "-";

/// Where `-o` puts a command's document. If that is standard output, nothing else goes there: what the command would
/// print appears on standard error, or with --quiet nowhere, as long as this lives.
class Output {
 public:
  /// Throws InvalidArgument if --json wants standard output too.
  Output(std::string name, const Common& common);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  [[nodiscard]] bool isStandard() const { return name_ == kStandardOutput; }
  /// What the user is told: the name, "standard output".
  [[nodiscard]] std::string inWords() const;
  /// Writes a document: as writeFileAtomically(), or to standard output.
  void write(std::string_view content) const;
  void write(const ProduceBytes& produce) const;
  /// As saveSession(), or its JSON to standard output.
  void write(const Session& session) const;

 private:
  std::string name_;
  std::streambuf* standard_ = nullptr;  ///< of std::cout, while something else is in its place
  std::ostringstream nowhere_;
};

/// A command and its options, which live as long as it does.
template <class Options>
struct AddedCommand {
  CLI::App& command;
  Options& options;
};
/// Adds a command; `run` returns the exit code. The options that every command has are not among its own.
template <class Options>
AddedCommand<Options> addCommand(CLI::App& app, Common& common, const std::string& name, const std::string& help,
                                 const std::string& footer, int (*run)(const Options& options, const Common& common)) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(name, help)->footer(footer);
  command->callback([options, &common, run] { common.exit_code = run(*options, common); });
  return {*command, *options};
}

using AddCommand = void(CLI::App& app, Common& common);
AddCommand addSimulate, addCapture, addListen, addSolve, addEvaluate, addCheck, addExport, addConvert, addInspect,
    addSensors, addParts, addLinks, addPlace;

/// Captures as `capture` does and returns the session, which may have no pose. Says on standard error what goes on.
Session captureSession(const LiveCaptureOptions& options, const Common& common);

/// Says every offence of a device once, as soon as it is known.
class ProtocolViolationNotes {
 public:
  explicit ProtocolViolationNotes(const Common& common) : common_(common) {}
  void show(const std::vector<ProtocolViolation>& offences);

 private:
  const Common& common_;
  std::size_t shown_ = 0;
};

/// Runs `read` and turns what it throws about the file into BadInput.
template <class Read>
auto asInput(Read&& read) {
  try {
    return read();
  } catch (const StorageError& error) {
    throw BadInput(error.what());
  } catch (const FormatError& error) {
    throw BadInput(error.what());
  }
}

/// Opens an input; TUM files are read with the given cell model (a built-in name or a file).
OpenedFile openInput(const std::string& path, const std::string& cell_model = "hex-bma150",
                     TumAs tum = TumAs::Calibration);
Session openSession(const std::string& path);
/// What openSession() throws for a calibration.
BadInput noSession(const std::string& path);
std::shared_ptr<const Reconstruction> openCalibration(const std::string& path,
                                                      const std::string& cell_model = "hex-bma150");

/// robotNamed() of `--robot` and `--package`.
RobotModel openRobot(const std::string& robot, const std::vector<std::string>& packages);
/// The joint angles of a session's poses: those of the table `file` (as `--joints`; may be empty) where it has a pose,
/// else those of the session.
std::map<PoseId, JointAngles> anglesOfPoses(const Session& session, const std::string& file, const RobotModel& robot);

/// `--up`, three numbers or none. Throws InvalidArgument naming it where they are no direction.
void setUp(const std::vector<double>& up, LinksOptions& options);

/// Parses the arguments, which runs a command, and says what goes wrong in one line. Returns the exit code.
int runProgram(CLI::App& app, int argc, char** argv, const Common& common);
int exitCodeOf(const Assessment& verdict);
/// Of an error that ends a command; nothing for what no command should throw.
std::optional<int> exitCodeOf(const std::exception& error);

/// Findings and verdict as text and as JSON, the same in every command.
void printFindings(const std::vector<Finding>& findings);
void printVerdict(const Assessment& verdict);
Json toJson(const Finding& finding);
Json toJson(const Assessment& verdict);
Json toJson(const LotEstimate& lot);
Json toJson(const std::vector<Finding>& findings);
Json toJson(const std::vector<ProtocolViolation>& offences);
void printJson(const Json& json);
/// JSON as text, without what steers a terminal: JSON itself escapes the control characters of ASCII only.
void printJsonText(std::string_view text);

/// "1 pose", "2 poses".
std::string counted(std::uint64_t count, const std::string& noun);
std::string millimetres(double length_m, int decimals = 2);
std::string degrees(double angle_rad, int decimals = 2);

}  // namespace hexoderm::cli
