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
  ExportOptions options;
};

int run(ExportCommandOptions command, const Common& common) {
  const ExportFormat format = exportFormatFromName(command.format);
  command.options.stl_unit = command.stl_unit == "m" ? LengthUnit::Metres : LengthUnit::Millimetres;
  command.options.urdf_link_per_cell = command.urdf_links == "cell";
  command.options.validate();
  const Output output(command.output, common);
  if (output.isStandard() && format == ExportFormat::Csv) {
    throw InvalidArgument("-o -: csv is a folder of several files, which standard output can't be: give a folder");
  }
  const auto calibration = openCalibration(command.input);
  common.progress("Writing " + output.inWords() + " ...");
  if (output.isStandard()) {
    output.write(exportBytes(*calibration, format, command.options, output.inWords()));
    common.endProgress();
    return kDone;
  }
  const auto files = exportReconstruction(*calibration, format, command.output, command.options);
  common.endProgress();
  if (common.json) {
    auto names = nlohmann::ordered_json::array();
    for (const auto& file : files) names.push_back(file.string());
    printJson({{"format", command.format}, {"files", names}});
  } else {
    for (const auto& file : files) std::cout << "Written and read back: " << forTerminal(file.string()) << '\n';
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
  common.addTo(*command);
  command->footer("Example:\n  hexoderm-cli export arm.calibration.json --to urdf -o arm.urdf");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
