#include "app/cli/command.h"

#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/io/session_joint_angles.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/robots/joint_angles_csv.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>
#include <utility>

namespace hexoderm::cli {
namespace {

/// The values of all options whose type is called so; what is checked of them follows its name.
template <class Action>
void forEachValue(const CLI::App& command, const std::string& type, const Action& action) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_type_name();
    if (name != type && !name.starts_with(type + ":")) continue;
    for (const std::string& value : option->results()) action(*option, value);
  }
}

/// Refuses the values of an option that are not taken, when they are parsed.
template <class IsTaken>
CLI::Option* take(CLI::Option* option, const std::string& expected, const std::string& in_help,
                  const IsTaken& isTaken) {
  const auto refusal = [=](const std::string& text) {
    if (!isTaken(text)) {
      throw InvalidArgument(option->get_name() + ": expected " + expected + ", found " + "\"" + shortened(text, 80) +
                            "\"");
    }
    return std::string();
  };
  return option->check(CLI::Validator(refusal, in_help));
}

std::string boundText(double number) {
  return number == std::floor(number) ? formatFixed(number, 0) : formatExact(number);
}

CLI::Option* takeReals(CLI::Option* option, double least, double most, bool is_least_taken) {
  const std::string from = boundText(least);
  const std::string to = boundText(most);
  return take(option,
              is_least_taken ? "a number from " + from + " to " + to : "a number above " + from + " and at most " + to,
              (is_least_taken ? "FLOAT in [" : "FLOAT in (") + from + " - " + to + "]", [=](const std::string& text) {
                double value = 0;
                return CLI::detail::lexical_cast(text, value) && value <= most &&
                       (is_least_taken ? value >= least : value > least);
              });
}

template <class Kind>
bool isA(const std::exception& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

}  // namespace

void Common::addTo(CLI::App& command) {
  command.add_flag("--json", json, "Print the result as JSON on standard output");
  command.add_flag("--quiet", quiet, "No progress and no remarks on standard error");
}

void Common::progress(const std::string& text) const {
  if (!quiet && ::isatty(STDERR_FILENO) != 0) std::cerr << "\r\033[K" << forTerminal(text) << std::flush;
}

void Common::endProgress() const { progress(""); }

void Common::complain(const std::string& text) const {
  endProgress();
  std::cerr << "hexoderm-cli: " << forTerminal(text) << '\n';
}

void Common::note(const std::string& text) const {
  endProgress();
  if (!quiet) std::cerr << forTerminal(text) << '\n';
}

void Common::logNote(const std::string& text) const {
  if (::isatty(STDERR_FILENO) == 0) note(text);
}

void requireApart(const std::string& a, const std::string& b) {
  const auto fileOf = [](const std::string& name) {
    std::error_code error;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error).string();
  };
  const auto isBeside = [](const std::string& file, const std::string& database) {
    return std::ranges::any_of(kBesideDatabases, [&](const char* suffix) { return file == database + suffix; });
  };
  const std::string file_a = fileOf(a);
  const std::string file_b = fileOf(b);
  const bool same = file_a == file_b || (identityOf(a) && identityOf(a) == identityOf(b));
  if (!same && !isBeside(file_a, file_b) && !isBeside(file_b, file_a)) return;
  throw InvalidArgument(a, message("collides with {}, which another option writes: take another name", b));
}

void requireReplaceableOutputs(const CLI::App& command) {
  noteRead("/dev/stdin");
  forEachValue(command, kInput, [](const CLI::Option& /*option*/, const std::string& file) { noteRead(file); });
  std::vector<std::string> outputs;
  forEachValue(command, kOutput, [&](const CLI::Option& option, const std::string& file) {
    if (file == kStandardOutput) return;
    const auto& letters = option.get_snames();
    requireReplaceable(file, (letters.empty() ? option.get_name() : "-" + letters.front()) + " " + file);
    for (const std::string& other : outputs) requireApart(file, other);
    outputs.push_back(file);
  });
}

CLI::Option* takeNumbers(CLI::Option* option, double least, double most) {
  return takeReals(option, least, most, true);
}

CLI::Option* takeNumbersAbove(CLI::Option* option, double bound, double most) {
  return takeReals(option, bound, most, false);
}

CLI::Option* takeWholeNumbers(CLI::Option* option, std::uint64_t least, std::uint64_t most) {
  const std::string least_text = std::to_string(least);
  const std::string most_text = std::to_string(most);
  const auto isTaken = [=](const std::string& text) {
    std::uint64_t value = 0;
    errno = 0;
    // The parser would wrap what is negative, and cut off what is beyond 64 bits.
    return text.find('-') == std::string::npos && CLI::detail::lexical_cast(text, value) && errno != ERANGE &&
           value >= least && value <= most;
  };
  // The largest number of the option's type tells nobody anything.
  const bool is_of_type = least == 0 && most >= std::numeric_limits<std::uint32_t>::max();
  const std::string in_help = is_of_type ? "" : "INT in [" + least_text + " - " + most_text + "]";
  return take(option, "a whole number from " + least_text + " to " + most_text, in_help, isTaken);
}

CLI::Option* takeDirection(CLI::Option* option) {
  return takeNumbers(option->expected(3)->delimiter(','), -kMaxLength_m, kMaxLength_m);
}

Output::Output(std::string name, const Common& common) : name_(std::move(name)) {
  if (!isStandard()) return;
  if (common.json) throw InvalidArgument("-o - and --json both want standard output: give -o a file, or leave one out");
  standard_ = std::cout.rdbuf(common.quiet ? nowhere_.rdbuf() : std::cerr.rdbuf());
}

Output::~Output() {
  if (standard_ != nullptr) std::cout.rdbuf(standard_);
}

std::string Output::inWords() const { return isStandard() ? "standard output" : name_; }

void Output::write(std::string_view content) const {
  write([&](const WriteBytes& take) { take(content); });
}

void Output::write(const ProduceBytes& produce) const {
  if (!isStandard()) return writeFileAtomically(name_, produce);
  produce([](std::string_view /*bytes*/) {});  // what can't be produced leaves no half of it
  std::ostream out(standard_);
  produce([&](std::string_view bytes) { out << bytes; });
  if (!out.flush()) throw StorageError("standard output: cannot be written");
}

void Output::write(const Session& session) const {
  if (!isStandard()) return saveSession(session, name_);
  write([&](const WriteBytes& take) { writeSessionJson(session, take); });
}

void ProtocolViolationNotes::show(const std::vector<ProtocolViolation>& offences) {
  for (; shown_ < offences.size(); ++shown_) {
    common_.note("The device does something wrong (" + std::string(offenceName(offences[shown_].kind)) +
                 "): " + inWords(offences[shown_]).english());
  }
}

OpenedFile openInput(const std::string& path, const std::string& cell_model, TumAs tum) {
  const CellModel model = asInput([&] { return loadCellModel(cell_model); });
  return asInput([&] { return openFile(path, model, tum); });
}

Session openSession(const std::string& path) {
  return asInput([&] { return hexoderm::openSession(path); });
}

BadInput noSession(const std::string& path) { return BadInput(hexoderm::noSession(path).what()); }

std::shared_ptr<const Reconstruction> openCalibration(const std::string& path, const std::string& cell_model) {
  const CellModel model = asInput([&] { return loadCellModel(cell_model); });
  return asInput([&] { return hexoderm::openCalibration(path, model); });
}

RobotModel openRobot(const std::string& robot, const std::vector<std::string>& packages) {
  return asInput([&] { return robotNamed(robot, packages); });
}

std::map<PoseId, JointAngles> anglesOfPoses(const Session& session, const std::string& file, const RobotModel& robot) {
  std::map<PoseId, JointAngles> angles;
  for (const SessionPose& pose : session.poses()) {
    if (!pose.joint_angles.positions.empty()) angles[pose.capture->id] = pose.joint_angles;
  }
  if (file.empty()) return angles;
  const JointAnglesTable table = asInput([&] {
    JointAnglesTable read = readJointAnglesCsv(file, robot);
    const Message why = whyNoPoseHasAngles(session, read);
    if (!why.empty()) throw FormatError(file, why);
    return read;
  });
  for (const SetJointAngles& edit : jointAnglesFor(session, table).edits) {
    angles[session.poses()[edit.index].capture->id] = edit.angles;
  }
  return angles;
}

void setUp(const std::vector<double>& up, LinksOptions& options) {
  if (up.empty()) return;
  options.up_w = {up[0], up[1], up[2]};
  checkOption("--up", formatExact(up[0]) + "," + formatExact(up[1]) + "," + formatExact(up[2]),
              [&] { options.validate(); });
}

int exitCodeOf(const Assessment& verdict) { return verdict.isUsable() ? kDone : kNotGoodEnough; }

int runProgram(CLI::App& app, int argc, char** argv, const Common& common) {
  try {
    app.parse(argc, argv);
    std::cout.flush();
    if (!std::cout) throw StorageError("standard output: cannot be written");
    return common.exit_code;
  } catch (const CLI::ParseError& error) {
    // Help and version as they are; a complaint about the arguments repeats them.
    std::ostringstream complaint;
    const int code = app.exit(error, std::cout, complaint);
    for (const std::string& line : split(complaint.str(), '\n')) {
      if (!line.empty()) std::cerr << forTerminal(line) << '\n';
    }
    return code == 0 ? kDone : kUsage;
  } catch (const std::exception& error) {
    const std::optional<int> code = exitCodeOf(error);
    if (!code) throw;
    std::cerr << app.get_name() << ": " << forTerminal(error.what()) << '\n';
    return *code;
  }
}

std::optional<int> exitCodeOf(const std::exception& error) {
  if (isA<BadInput>(error)) return kBadInput;
  if (isA<FormatError>(error)) return kStorage;  // what is written can't be made; what is read is BadInput
  if (isA<InvalidArgument>(error)) return kUsage;
  if (isA<DeviceError>(error)) return kDevice;
  if (isA<StorageError>(error)) return kStorage;
  if (isA<std::system_error>(error)) return kStorage;  // of std::filesystem, above all
  if (isA<std::bad_alloc>(error)) return kStorage;
  return std::nullopt;
}

void printFindings(const std::vector<Finding>& findings) {
  if (findings.empty()) {
    std::cout << "Findings: none\n";
    return;
  }
  std::cout << "Findings: " << findings.size() << '\n';
  // Of hundreds of a kind nobody reads more than the first; among them another kind would be overlooked.
  constexpr std::size_t kMaxOfAKind = 20;
  std::map<FindingCode, std::size_t> counts;
  for (const Finding& finding : findings) {
    if (++counts[finding.code] > kMaxOfAKind) continue;
    std::cout << "  " << severityName(finding.severity) << "  " << codeName(finding.code) << ": "
              << forTerminal(finding.message.english()) << '\n';
  }
  for (const auto& [code, count] : counts) {
    if (count <= kMaxOfAKind) continue;
    std::cout << "  and " << count - kMaxOfAKind << " more of " << codeName(code) << "; --json lists all\n";
  }
}

void printVerdict(const Assessment& assessment) {
  const std::string_view level = verdictName(assessment.level);
  std::string reason = assessment.reason.english();
  // Most reasons begin with the verdict themselves.
  std::string word(assessment.level == VerdictLevel::NotTrusted ? "not to be trusted" : level);
  std::ranges::replace(word, '_', ' ');
  const std::string beginning = static_cast<char>(std::toupper(word.front())) + word.substr(1) + ": ";
  const bool repeats = reason.starts_with(beginning);
  if (repeats) reason.erase(0, beginning.size());
  const bool is_figures = repeats && assessment.level != VerdictLevel::NotTrusted;
  std::cout << "Verdict: " << (is_figures ? word + ", " : word + ". ") << forTerminal(reason) << '\n';
  if (!assessment.next_action.empty()) std::cout << "Next: " << forTerminal(assessment.next_action.english()) << '\n';
}

Json toJson(const Finding& finding) {
  return {{"code", codeName(finding.code)},    {"severity", severityName(finding.severity)},
          {"text", finding.message.english()}, {"cells", numbersOf(finding.cells)},
          {"ports", numbersOf(finding.ports)}, {"poses", numbersOf(finding.poses)}};
}

Json toJson(const std::vector<Finding>& findings) {
  return arrayOf(findings, [](const Finding& finding) { return toJson(finding); });
}

Json toJson(const Assessment& verdict) {
  return {{"level", verdictName(verdict.level)},
          {"reason", verdict.reason.english()},
          {"position_95_mm", orNull(verdict.position_95_m, toMillimetres)},
          {"orientation_95_deg", orNull(verdict.orientation_95_rad, toDegrees)},
          {"limit", limitName(verdict.limit)},
          {"remedy", remedyName(verdict.remedy)},
          {"limiting_cells", numbersOf(verdict.limiting_cells)},
          {"retake", numbersOf(verdict.retake)},
          {"next_action", verdict.next_action.english()}};
}

Json toJson(const LotEstimate& lot) {
  return {{"offset_g", listOf(lot.offset_g)},
          {"offset_sigma_g", listOf(lot.offset_sigma_g)},
          {"scale", lot.scale},
          {"scale_sigma", lot.scale_sigma}};
}

Json toJson(const std::vector<ProtocolViolation>& offences) {
  return arrayOf(offences, [](const ProtocolViolation& offence) -> Json {
    return {{"kind", offenceName(offence.kind)},
            {"count", offence.count},
            {"reason", offence.reason.english()},
            {"message_begins", offence.excerpt}};
  });
}

void printJson(const Json& json) { printJsonText(json.dump(1, ' ', false, Json::error_handler_t::replace)); }

void printJsonText(std::string_view text) {
  // The escapes of forTerminal() are JSON's, too.
  for (const std::string& line : split(text, '\n')) std::cout << forTerminal(line) << '\n';
}

std::string counted(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}
std::string millimetres(double length_m, int decimals) {
  return formatFixed(toMillimetres(length_m), decimals) + " mm";
}
std::string degrees(double angle_rad, int decimals) { return formatFixed(toDegrees(angle_rad), decimals) + "°"; }

}  // namespace hexoderm::cli
