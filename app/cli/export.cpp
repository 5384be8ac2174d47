#include "app/cli/command.h"

#include "hexoderm/io/exporter.h"
#include "hexoderm/util/text.h"

#include <iostream>

namespace hexoderm::cli {
namespace {

struct ExportCommandOptions {
  std::string input;
  std::string format;
  std::string output;
  std::string stl_unit = "mm";
  std::string urdf_links = "cell";
  std::uint32_t patch_of_cell = 0;
  ExportOptions options;
};

nlohmann::ordered_json toJson(const std::vector<PatchLeftOut>& patches) {
  auto array = nlohmann::ordered_json::array();
  for (const PatchLeftOut& patch : patches) {
    auto cells = nlohmann::ordered_json::array();
    for (const CellId cell : patch.cells) cells.push_back(cell.value());
    array.push_back({{"patch", patch.patch.value()}, {"origin", patch.origin.value()}, {"cells", cells}});
  }
  return array;
}

int run(ExportCommandOptions command, bool one_patch, const Common& common) {
  const ExportFormat format = exportFormatFromName(command.format);
  command.options.stl_unit = command.stl_unit == "m" ? LengthUnit::Metres : LengthUnit::Millimetres;
  command.options.urdf_link_per_cell = command.urdf_links == "cell";
  if (one_patch) command.options.patch = CellId(command.patch_of_cell);
  command.options.validate();
  const Output output(command.output, common);
  if (output.isStandard() && format == ExportFormat::Csv) {
    throw InvalidArgument("-o -: csv is a folder of several files, which standard output can't be: give a folder");
  }
  const auto calibration = openCalibration(command.input);
  const std::vector<PatchLeftOut> left_out = patchesLeftOut(*calibration, format, command.options);
  const auto sayLeftOut = [&] {
    if (left_out.empty()) return;
    common.note(leftOutInWords(left_out).english() + " --patch CELL writes the patch of a cell to a file of its own.");
  };
  common.progress("Writing " + output.inWords() + " ...");
  if (output.isStandard()) {
    output.write(exportBytes(*calibration, format, command.options, output.inWords()));
    common.endProgress();
    sayLeftOut();
    return kDone;
  }
  const auto files = exportReconstruction(*calibration, format, command.output, command.options);
  common.endProgress();
  if (common.json) {
    auto names = nlohmann::ordered_json::array();
    for (const auto& file : files) names.push_back(file.string());
    printJson({{"format", command.format}, {"files", names}, {"left_out", toJson(left_out)}});
  } else {
    for (const auto& file : files) std::cout << "Written and read back: " << forTerminal(file.string()) << '\n';
    sayLeftOut();
  }
  return kDone;
}

}  // namespace

void addExport(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ExportCommandOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a calibration in a form that other software reads");
  std::string formats;
  for (const ExportFormatDescription& format : exportFormats()) {
    formats += "\n  " + std::string(format.name) + ": " + format.summary.english();
  }
  command->add_option("calibration", options->input, "Calibration (*.calibration.json, or TUM XML)")->required();
  command->add_option("--to", options->format, "Format, one of:" + formats)->required();
  command->add_option("-o,--output", options->output, "File to write; for csv a folder; - is standard output")
      ->required();
  command->add_option("--stl-unit", options->stl_unit, "mm or m; STL itself has no unit")
      ->check(CLI::IsMember({"mm", "m"}))
      ->capture_default_str();
  command->add_option("--urdf-links", options->urdf_links, "One link per cell or per patch")
      ->check(CLI::IsMember({"cell", "patch"}))
      ->capture_default_str();
  command->add_option("--urdf-robot", options->options.urdf_robot, "Name of the robot")->capture_default_str();
  command->add_option("--urdf-parent", options->options.urdf_parent_link, "Link that the skin is fixed to")
      ->capture_default_str();
  command->add_option("--urdf-prefix", options->options.urdf_prefix, "Prefix of link and joint names")
      ->capture_default_str();
  CLI::Option* patch = command->add_option("--patch", options->patch_of_cell,
                                           "Cell whose patch is written; without it all patches are where the format "
                                           "keeps their frames apart (csv, dot), else the one with the most cells");
  command
      ->add_flag("--all-patches", options->options.all_patches,
                 "Write every patch to a vtp file too, each in its own frame, their origins at one place")
      ->excludes(patch);
  common.addTo(*command);
  command->footer("Example:\n  hexoderm-cli export arm.calibration.json --to urdf -o arm.urdf");
  command->callback([options, patch, &common] { common.exit_code = run(*options, patch->count() > 0, common); });
}

}  // namespace hexoderm::cli
