#include "app/cli/command.h"

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/tum_xml.h"
#include "hexoderm/session/session_store.h"

#include <filesystem>
#include <iostream>

namespace hexoderm::cli {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string cell_model = "hex-bma150";
};

bool isXml(const std::string& path) { return std::filesystem::path(path).extension() == ".xml"; }

int run(const ConvertOptions& options, const Common& common) {
  const bool to_session = isSessionFileName(options.output);
  const bool to_calibration = options.output.ends_with(".calibration.json");
  if (!to_session && !to_calibration) {
    throw InvalidArgument("-o: expected a name that ends in .hexo, .session.json or .calibration.json, found \"" +
                          options.output + "\"");
  }
  if (to_session && isXml(options.input)) {
    const CellModel model = asInput([&] { return loadCellModel(options.cell_model); });
    const TumSkinConfig config = asInput([&] { return readTumXml(options.input); });
    saveSession(sessionFromTum(config, model, options.input), options.output);
    common.note("Only the topology was taken over: the file holds no readings.");
  } else if (to_session) {
    saveSession(openSession(options.input), options.output);
    if (asInput([&] { return isSessionStore(options.input); })) {
      common.note("The session as it is now was taken over; removed poses, raw samples and its history stay in " +
                  options.input + ".");
    }
  } else {
    writeCalibrationJson(*openCalibration(options.input, options.cell_model), options.output);
  }
  if (common.json) {
    printJson({{"input", options.input}, {"output", options.output}});
  } else {
    std::cout << "Written to " << options.output << '\n';
  }
  return kDone;
}

}  // namespace

void addConvert(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand(
      "convert",
      "*.hexo to *.session.json and back; TUM SkinConfig XML to a calibration, or its topology to a session");
  command->add_option("input", options->input, "*.hexo, *.session.json, *.calibration.json or TUM *.xml")->required();
  command
      ->add_option("-o,--output", options->output, "*.hexo (must not exist yet), *.session.json or *.calibration.json")
      ->required();
  command->add_option("--cell-model", options->cell_model, "Of a TUM file: built-in name or JSON file")
      ->capture_default_str();
  common.addTo(*command);
  command->footer("Example:\n  hexoderm-cli convert skin_config.xml -o skin.calibration.json");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
