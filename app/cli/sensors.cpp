#include "app/cli/command.h"
#include "app/cli/json.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/text.h"
#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/sensor_statistics.h"

#include <iostream>

namespace hexoderm::cli {
namespace {

struct SensorsOptions {
  std::vector<std::string> inputs;
  std::string output;
};

/// A unit in which a sigma is printed.
struct PrintedUnit {
  const char* name;
  double factor;
  int decimals;
};
constexpr PrintedUnit kMilliG = {"mg", 1000, 1};
constexpr PrintedUnit kPercent = {"%", 100, 2};

std::string figure(double value, PrintedUnit unit) {
  return formatFixed(value * unit.factor, unit.decimals) + " " + unit.name;
}

constexpr EnumNames<SigmaKnowledge> kKnowledge = {{"measured", "at_most", "unknown"}};

void printSigma(const std::string& name, const SigmaEstimate& estimate, double model_sigma, PrintedUnit unit) {
  std::cout << name << std::string(name.size() < 14 ? 14 - name.size() : 1, ' ');
  if (estimate.knowledge == SigmaKnowledge::Measured) {
    std::cout << figure(estimate.sigma, unit) << " (95 %: " << figure(estimate.low_95, unit) << " to "
              << figure(estimate.high_95, unit) << "), worth " << formatFixed(estimate.worth, 0) << " errors";
  } else if (estimate.knowledge == SigmaKnowledge::AtMost) {
    std::cout << "at most " << figure(estimate.high_95, unit) << " (95 %)";
  } else {
    std::cout << "can't tell: the readings are worth " << formatFixed(estimate.worth, 1) << " errors";
  }
  std::cout << "; the sessions' model says " << figure(model_sigma, unit) << '\n';
}

void print(const SensorStatistics& statistics, const Accelerometer& model, std::size_t sessions) {
  std::cout << counted(sessions, "session") << ", " << statistics.cells_used << " of " << statistics.cells
            << " accelerometers, " << statistics.readings << " mean readings, solved " << statistics.rounds << " times"
            << (statistics.settled ? "" : " and not settled") << '\n';
  std::cout << "Errors of the accelerometers, 1 sigma an axis:\n";
  const SensorSigmas& sigmas = statistics.sigmas;
  printSigma("offset", sigmas.offset_g, model.ofUnknownLot().largestOffsetSigma_g(), kMilliG);
  printSigma("  of it shared", sigmas.shared_offset_g, model.offset_shared_sigma_g, kMilliG);
  printSigma("own scale", sigmas.scale, model.scale_sigma, kPercent);
  printSigma("shared scale", sigmas.shared_scale, model.scale_shared_sigma, kPercent);
  printSigma("cross-axis", sigmas.cross_axis, model.cross_axis_sigma, kPercent);
  if (sigmas.lot) std::cout << "In common to all: " << lotText(*sigmas.lot) << '\n';
}

Json toJson(const SigmaEstimate& estimate, double model_sigma) {
  const bool is_measured = estimate.knowledge == SigmaKnowledge::Measured;
  return {{"knowledge", kKnowledge.of(estimate.knowledge)},
          {"sigma", is_measured ? Json(estimate.sigma) : Json()},
          {"low_95", is_measured ? Json(estimate.low_95) : Json()},
          {"high_95", estimate.knowledge == SigmaKnowledge::Unknown ? Json() : Json(estimate.high_95)},
          {"worth_errors", estimate.worth},
          {"model", model_sigma}};
}

Json toJson(const SensorStatistics& statistics, const Accelerometer& model, const SensorsOptions& options) {
  const SensorSigmas& sigmas = statistics.sigmas;
  return {{"sessions", options.inputs},
          {"cells", statistics.cells},
          {"cells_used", statistics.cells_used},
          {"readings", statistics.readings},
          {"rounds", statistics.rounds},
          {"settled", statistics.settled},
          {"offset_g", toJson(sigmas.offset_g, model.ofUnknownLot().largestOffsetSigma_g())},
          {"shared_offset_g", toJson(sigmas.shared_offset_g, model.offset_shared_sigma_g)},
          {"scale", toJson(sigmas.scale, model.scale_sigma)},
          {"shared_scale", toJson(sigmas.shared_scale, model.scale_shared_sigma)},
          {"cross_axis", toJson(sigmas.cross_axis, model.cross_axis_sigma)},
          {"lot", sigmas.lot ? cli::toJson(*sigmas.lot) : Json()},
          {"file", options.output.empty() ? Json() : Json(options.output)}};
}

SensorStatistics estimateFrom(const std::vector<std::shared_ptr<const SessionSnapshot>>& sessions) {
  try {
    return *estimateSensorStatistics(sessions);
  } catch (const InvalidArgument& error) {
    throw BadInput(error.message());  // the sessions don't belong together
  }
}

int run(const SensorsOptions& options, const Common& common) {
  const Output output(options.output, common);
  std::vector<std::shared_ptr<const SessionSnapshot>> sessions;
  for (const std::string& input : options.inputs) {
    common.progress("Reading " + input + " ...");
    sessions.push_back(openSession(input).snapshot());
  }
  common.progress("Solving ...");
  const SensorStatistics statistics = estimateFrom(sessions);
  common.endProgress();
  for (const auto& [a, b] : statistics.same_cells) {
    common.note(options.inputs[a] + " and " + options.inputs[b] +
                " have the same cells and links: if they are of one skin, its sensors count twice, and the ranges are "
                "too narrow.");
  }
  if (!options.output.empty()) output.write(cellModelToJson(statistics.model));
  const Accelerometer& model = sessions.front()->model->accelerometer;
  if (common.json) {
    printJson(toJson(statistics, model, options));
  } else {
    print(statistics, model, sessions.size());
    if (!statistics.knowsAnything()) {
      std::cout << "Nothing can be told: take poses in more directions, of more cells.\n";
    }
    if (!options.output.empty()) {
      std::cout << "Cell model written to " << forTerminal(output.inWords())
                << "; what can't be told stands there as in the sessions' model, what is bounded as its bound.\n";
    }
  }
  return statistics.knowsAnything() ? kDone : kNotGoodEnough;
}

}  // namespace

void addSensors(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<SensorsOptions>(
      app, common, "sensors",
      "Estimate how large the errors of the accelerometers are, and write a cell model that says so",
      "One pose tells nothing, two the offsets, three the scale errors too, and six, as of a cube's faces, all.\n"
      "Exit code 1: nothing can be told; the model is written all the same.\n"
      "Example:\n  hexoderm-cli simulate --poses 6 -o arm.session.json\n"
      "  hexoderm-cli sensors arm.session.json -o chip.json\n"
      "  hexoderm-cli simulate --poses 6 --cell-model chip.json -o next.session.json",
      run);
  addInput(command, "sessions", options.inputs,
           "Sessions (*.hexo or *.session.json) with one cell model, of chips of one lot")
      ->required();
  addOutput(command, "-o,--output", options.output,
            "Cell model to write: the sessions' with the estimated sigmas (*.json; - is standard output)");
}

}  // namespace hexoderm::cli
