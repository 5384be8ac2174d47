#include "app/cli/command.h"
#include "app/cli/reproduce/experiments.h"

#include <array>
#include <iostream>

namespace hexoderm::cli {
namespace {

struct ReproduceOptions {
  std::size_t seeds = 200;
  std::string only;
};

struct Part {
  const char* name;
  nlohmann::ordered_json (*run)(const Trials& trials, bool prints);
};
constexpr std::array<Part, 6> kParts = {{{"paper", reproducePaper},
                                         {"accuracy", tabulateAccuracy},
                                         {"uncertainty", checkUncertainty},
                                         {"detection", countDetections},
                                         {"check", countChanges},
                                         {"place", placeOnLinks}}};

int run(const ReproduceOptions& options, const Common& common) {
  nlohmann::ordered_json json = {{"seeds", options.seeds}, {"simulated", true}};
  const Trials trials(options.seeds, common);
  bool first = true;
  for (const Part& part : kParts) {
    if (!options.only.empty() && options.only != part.name) continue;
    if (!common.json && !first) std::cout << "\n\n";
    json[part.name] = part.run(trials, !common.json);
    common.endProgress();
    std::cout << std::flush;
    first = false;
  }
  if (common.json) printJson(json);
  return kDone;
}

}  // namespace

void addReproduce(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ReproduceOptions>();
  CLI::App* command = app.add_subcommand(
      "reproduce", "The paper's experiments and the accuracy of every method, measured on simulated skins");
  takeWholeNumbers(addWithDefault(*command, "--seeds", options->seeds, "Skins per row"), 1, 100'000);
  std::vector<std::string> names;
  for (const Part& part : kParts) names.emplace_back(part.name);
  command->add_option("--only", options->only, "One part of it")->check(CLI::IsMember(names));
  complete(*command, common, "Example:\n  hexoderm-cli reproduce --seeds 200",
           [options, &common] { return run(*options, common); });
}

}  // namespace hexoderm::cli
