#include "app/cli/command.h"

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/session/session_store.h"

#include <iostream>

namespace hexoderm::cli {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string cell_model = "hex-bma150";
};

void writeCalibration(const Reconstruction& calibration, const Output& output) {
  output.write([&](const WriteBytes& write) { writeCalibrationJson(calibration, write); });
}

int run(const ConvertOptions& options, const Common& common) {
  const Output output(options.output, common);
  const bool to_calibration = options.output.ends_with(".calibration.json");
  if (!output.isStandard() && !to_calibration && !isSessionFileName(options.output)) {
    throw InvalidArgument("-o: expected a name that ends in .hexo, .session.json or .calibration.json, or -, found \"" +
                          options.output + "\"");
  }
  if (to_calibration) {
    writeCalibration(*openCalibration(options.input, options.cell_model), output);
  } else {
    // To standard output goes what a file is; a session's name makes a session of a TUM file, too.
    const OpenedFile opened =
        openInput(options.input, options.cell_model, output.isStandard() ? TumAs::Calibration : TumAs::Session);
    if (const auto* session = std::get_if<Session>(&opened)) {
      output.write(*session);
      if (session->poses().empty()) common.note("Only the topology was taken over: the file holds no readings.");
      if (asInput([&] { return isSessionStore(options.input); })) {
        common.note("The session as it is now was taken over; removed poses, raw samples and its history stay in " +
                    options.input + ".");
      }
    } else if (output.isStandard()) {
      writeCalibration(*std::get<std::shared_ptr<const Reconstruction>>(opened), output);
    } else {
      throw noSession(options.input);
    }
  }
  if (common.json) {
    printJson({{"input", options.input}, {"output", options.output}});
  } else {
    std::cout << "Written to " << forTerminal(output.inWords()) << '\n';
  }
  return kDone;
}

}  // namespace

void addConvert(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<ConvertOptions>(
      app, common, "convert",
      "*.hexo to *.session.json and back; TUM SkinConfig XML to a calibration, or its topology to a session",
      "Example:\n  hexoderm-cli convert skin_config.xml -o skin.calibration.json", run);
  addInput(command, "input", options.input, "*.hexo, *.session.json, *.calibration.json or TUM *.xml")->required();
  addOutput(command, "-o,--output", options.output,
            "*.hexo (must not exist yet), *.session.json or *.calibration.json; - is standard output, which gets the "
            "JSON of what the input is")
      ->required();
  addInput(command, "--cell-model", options.cell_model, "Of a TUM file: built-in name or JSON file")
      ->capture_default_str();
}

}  // namespace hexoderm::cli
