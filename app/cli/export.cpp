#include "app/cli/command.h"

#include "hexoderm/base/file.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/io/export_package.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/solve/result/patch_placements.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <system_error>

namespace hexoderm::cli {
namespace {

/// Whether a format has a link that a patch is fixed to whose place is not known.
bool hasParent(ExportFormat format) {
  const auto parent = std::ranges::find(exportOptions(), "parent", &ExportOptionDescription::name);
  return parent != exportOptions().end() && std::ranges::find(parent->formats, format) != parent->formats.end();
}

/// Whether a file is of no use without the robot's own links.
bool isForARobot(ExportFormat format) {
  using enum ExportFormat;
  return format == RobotUrdf || format == TfRos1 || format == TfRos2 || format == TfYaml;
}

/// Whether the links that patches are fixed to are those of the robot that `--robot` names; nothing without it. Throws
/// InvalidArgument, and BadInput where the robot can't be read.
void requireLinksOfTheRobot(const std::vector<ExportFormat>& formats, const ExportOptions& options) {
  if (options.robot_urdf.empty()) return;
  const RobotModel robot = [&] {
    try {
      return openRobot(options.robot_urdf.string(), {});
    } catch (const BadInput& error) {
      throw BadInput("--robot " + std::string(error.what()));
    }
  }();
  const auto require = [&](const std::string& link, std::string_view option) {
    try {
      static_cast<void>(robot.linkNamed(link));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(std::string(option), error.message());
    }
  };
  for (const PatchOnLink& place : options.placements) require(place.link, "the place of a patch");
  if (!options.in_link.empty()) require(options.in_link, "--in-link");
  if (options.placements.empty() && std::ranges::any_of(formats, hasParent)) require(options.parent_link, "--parent");
}

/// What is said where no place is known and a file for a robot joins the skin to a link all the same; empty elsewhere.
std::string joinedWithoutAPlace(const std::vector<ExportFormat>& formats, const ExportOptions& options) {
  if (!options.placements.empty() || std::ranges::none_of(formats, isForARobot)) return {};
  return "Where the patch is on the robot is not known: it is joined to " + options.parent_link +
         " without any offset. --place LINK:x,y,z,roll,pitch,yaw says where it is.";
}

/// Runs `write`, and turns what it throws about the robot's file into BadInput: what is wrong is not what is written.
template <class Write>
auto withRobotAsInput(const ExportOptions& options, Write&& write) {
  try {
    return write();
  } catch (const Error& error) {
    const std::string_view what = error.what();
    const bool is_of_robot = !options.robot_urdf.empty() && what.starts_with(options.robot_urdf.string() + ": ");
    if (!is_of_robot || dynamic_cast<const InvalidArgument*>(&error) != nullptr) throw;
    throw BadInput("--robot " + std::string(what));
  }
}

struct ExportCommandOptions {
  std::string input;
  std::string formats;
  std::string output;
  std::map<std::string_view, std::string> values;  ///< of exportOptions(), by name
  std::vector<std::string> placements;
  std::string placements_file;
  std::optional<std::uint32_t> patch_of_cell;
  ExportOptions options;
};

Json toJson(const std::vector<PatchLeftOut>& patches) {
  return arrayOf(patches, [](const PatchLeftOut& patch) -> Json {
    return {{"patch", patch.patch.value()}, {"origin", patch.origin.value()}, {"cells", numbersOf(patch.cells)}};
  });
}

/// "[CELL@]LINK:x,y,z,roll,pitch,yaw"; without a cell the patch that is exported alone.
PatchOnLink placementFrom(const std::string& text, const Reconstruction& reconstruction, const ExportOptions& options) {
  const auto fail = [&text](const Message& what) { throw InvalidArgument("--place \"" + text + "\"", what); };
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) fail(message("expected [CELL@]LINK:x,y,z,roll,pitch,yaw in metres and radians"));
  const std::vector<std::string> numbers = split(text.substr(colon + 1), ',');
  if (numbers.size() != 6) fail(message("expected six numbers behind the link, found {}", numbers.size()));
  std::array<double, 6> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double most = k < 3 ? kMaxLength_m : kMaxAngle_rad;
    values[k] = parseNumberWithin(numbers[k], "--place", -most, most);
  }

  PatchOnLink place;
  const std::size_t at = text.find('@');
  const PatchReconstruction* patch =
      options.patch ? reconstruction.find(*options.patch).patch : largestPatch(reconstruction);
  if (at < colon) {
    const CellId cell(parseUnsigned(text.substr(0, at), "--place"));
    patch = reconstruction.find(cell).patch;
    if (patch == nullptr) fail(message("no patch holds a cell {}", cell));
  }
  if (patch == nullptr) fail(message("there is no patch to place"));
  place.origin = patch->origin;
  const std::size_t name = at < colon ? at + 1 : 0;
  place.link = text.substr(name, colon - name);
  place.T_l_o = {rotationFromRpy({values[3], values[4], values[5]}), {values[0], values[1], values[2]}};
  return place;
}

/// The placements of a file that `hexoderm-cli place` wrote, all of which the calibration has to hold.
std::vector<PatchOnLink> placementsOf(const Reconstruction& reconstruction, const std::string& file) {
  std::vector<PatchOnLink> placements = asInput([&] { return readPlacementsJson(file); });
  for (const PatchOnLink& place : placements) {
    const auto is_it = [&](const PatchReconstruction& patch) { return patch.origin == place.origin; };
    if (std::ranges::none_of(reconstruction.patches, is_it)) {
      throw BadInput(file + ": cell " + toString(place.origin) + " is the origin of no patch of the calibration");
    }
  }
  return placements;
}

std::vector<ExportFormat> formatsFrom(const std::string& text) {
  std::vector<ExportFormat> formats;
  for (const std::string& name : split(text, ',')) formats.push_back(exportFormatFromName(name));
  return formats;
}

void addOnce(std::vector<std::string>& sentences, const std::string& sentence) {
  if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(sentence);
}

/// What the formats can't hold.
std::vector<std::string> notCarried(const std::vector<ExportFormat>& formats) {
  std::vector<std::string> sentences;
  for (const ExportFormat format : formats) {
    const std::string sentence = exportFormatDescription(format).not_carried.english();
    if (!sentence.empty()) addOnce(sentences, sentence);
  }
  return sentences;
}

/// The file that the calibration was read from, unless it was a pipe, which can't be read again.
std::vector<ExportInput> inputFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  return {{"calibration", std::filesystem::path(path).filename().string(), sha256Hex(readFile(path))}};
}

int run(const ExportCommandOptions& command, const Common& common) {
  const std::vector<ExportFormat> formats = formatsFrom(command.formats);
  ExportOptions options = command.options;
  for (const ExportOptionDescription& option : exportOptions()) option.set(options, command.values.at(option.name));
  if (command.patch_of_cell) options.patch = CellId(*command.patch_of_cell);
  if (options.robot_urdf.empty() && std::ranges::find(formats, ExportFormat::RobotUrdf) != formats.end()) {
    throw InvalidArgument("--to robot-urdf: expected --robot FILE too, the URDF of the robot that gets the skin");
  }
  for (const ExportFormat format : formats) options.validateFor(format);
  const Output output(command.output, common);
  const bool is_zip = !output.isStandard() && isZip(command.output);
  const bool is_folder = formats.size() > 1 || formats.front() == ExportFormat::Csv || is_zip;
  if (output.isStandard() && is_folder) {
    throw InvalidArgument("-o -: " + std::string(formats.size() > 1 ? "an export in several formats" : "csv") +
                          " is a folder of several files, which standard output can't be: give a folder");
  }
  const auto calibration = openCalibration(command.input);
  if (!command.placements_file.empty()) options.placements = placementsOf(*calibration, command.placements_file);
  for (const std::string& text : command.placements) {
    options.placements.push_back(placementFrom(text, *calibration, options));
  }
  if (options.placements.empty()) options.placements = placedPatches(*calibration);
  requireLinksOfTheRobot(formats, options);
  if (is_folder) options.inputs = inputFile(command.input);

  std::vector<PatchLeftOut> left_out;
  std::vector<std::string> remarks;
  for (const ExportFormat format : formats) {
    const std::vector<PatchLeftOut> of_format = patchesLeftOut(*calibration, format, options);
    if (of_format.empty()) continue;
    addOnce(remarks,
            leftOutText(of_format).english() +
                (of_format.front().not_on_link ? " --place or --placements says where a patch is."
                                               : " --patch CELL writes the patch of a cell to a file of its own."));
    for (const PatchLeftOut& patch : of_format) {
      if (std::ranges::find(left_out, patch.patch, &PatchLeftOut::patch) == left_out.end()) left_out.push_back(patch);
    }
  }
  if (const std::string remark = joinedWithoutAPlace(formats, options); !remark.empty()) addOnce(remarks, remark);
  const bool is_trusted = calibration->assessment.level != VerdictLevel::NotTrusted;
  const int exit_code = is_trusted ? kDone : kNotGoodEnough;
  if (!is_trusted) common.complain(command.input + ": " + calibration->assessment.reason.english());
  const std::vector<std::string> not_carried = notCarried(formats);
  for (const std::string& sentence : not_carried) addOnce(remarks, sentence);
  const auto sayWhatIsMissing = [&] {
    for (const std::string& remark : remarks) common.note(remark);
  };

  common.progress("Writing " + output.inWords() + " ...");
  if (output.isStandard()) {
    output.write(withRobotAsInput(options, [&] { return exportBytes(*calibration, formats.front(), options); }));
    common.endProgress();
    sayWhatIsMissing();
    return exit_code;
  }
  const auto files = withRobotAsInput(options, [&] {
    return is_folder ? exportBundle(*calibration, formats, command.output, options)
                     : exportReconstruction(*calibration, formats.front(), command.output, options);
  });
  common.endProgress();
  if (common.json) {
    printJson({{"format", command.formats},
               {"files", arrayOf(files, [](const std::filesystem::path& file) { return file.string(); })},
               {"left_out", toJson(left_out)},
               {"not_carried", not_carried}});
  } else {
    for (const auto& file : files) {
      std::error_code ignored;  // a device or a pipe is not read
      const bool is_file = std::filesystem::is_regular_file(file, ignored);
      std::cout << (is_file ? "Written and read back: " : "Written: ") << forTerminal(file.string()) << '\n';
    }
    sayWhatIsMissing();
  }
  return exit_code;
}

/// "urdf, robot-urdf: URDF of the robot" for the help.
std::string helpOf(const ExportOptionDescription& option) {
  return option.help.english() + " (" + inWords(option.formats) + ")";
}

void addFormatOptions(CLI::App& command, ExportCommandOptions& options) {
  for (const ExportOptionDescription& description : exportOptions()) {
    std::string& value = options.values[description.name];
    value = description.get(options.options);
    CLI::Option* option = command.add_option("--" + std::string(description.name), value, helpOf(description));
    std::vector<std::string> choices;
    for (const auto& choice : description.choices) choices.emplace_back(choice.value);
    if (!choices.empty()) option->check(CLI::IsMember(choices));
    if (description.kind == ExportOptionDescription::Kind::File) option->type_name(kInput);
    if (!value.empty()) option->capture_default_str();
  }
}

}  // namespace

void addExport(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<ExportCommandOptions>(
      app, common, "export", "Write a calibration in forms that other software reads",
      "Where --robot is given, the names of links are those of the robot, with every format.\n"
      "Examples:\n  hexoderm-cli export arm.calibration.json --to urdf -o arm.urdf\n"
      "  hexoderm-cli export arm.calibration.json --to robot-urdf --robot robot.urdf "
      "--place r_forearm:0.02,0,0.1,0,1.5708,0 -o robot_with_skin.urdf",
      run);
  std::string formats;
  for (const ExportFormatDescription& format : exportFormats()) {
    formats += "\n  " + std::string(format.name) + ": " + format.summary.english();
    if (!format.not_carried.empty()) formats += ". " + format.not_carried.english();
  }
  addInput(command, "calibration", options.input, "Calibration (*.calibration.json, or TUM XML)")->required();
  command
      .add_option(
          "--to", options.formats,
          "Format, or several with commas between for a folder or archive with all of them and a manifest.json:" +
              formats)
      ->required();
  addOutput(command, "-o,--output", options.output,
            "File to write; for csv and for several formats a folder, or with the ending .zip an archive; - is "
            "standard output")
      ->required();
  addFormatOptions(command, options);
  command.add_option(
      "--place", options.placements,
      "[CELL@]LINK:x,y,z,roll,pitch,yaw: where the patch of a cell is on a link of the robot, in metres and "
      "radians as the origin of a URDF joint; once for each patch");
  addInput(command, "--placements", options.placements_file,
           "File of hexoderm-cli place, which says where patches are on links of the robot");
  command.add_option("--in-link", options.options.in_link,
                     "Write coordinates in the frame of this link, of the patches that are placed on it");
  CLI::Option* patch = takeWholeNumbers(
      command.add_option("--patch", options.patch_of_cell,
                         "Cell whose patch is written; without it all patches are where the format keeps their "
                         "frames apart, else the one with the most cells"));
  command
      .add_flag("--all-patches", options.options.all_patches,
                "Write every patch to a vtp file too, each in its own frame, their origins at one place")
      ->excludes(patch);
}

}  // namespace hexoderm::cli
