// hexoderm-reproduce: the tables of core/hexoderm/solve/ACCURACY.md, measured on simulated skins.

#include "app/cli/command.h"
#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/freed_memory.h"

#include <array>
#include <iostream>

namespace hexoderm::cli {
namespace {

struct Part {
  const char* name;
  Json (*run)(const Trials& trials, bool prints);
};
constexpr std::array<Part, 8> kParts = {{{"paper", reproducePaper},
                                         {"accuracy", tabulateAccuracy},
                                         {"uncertainty", checkUncertainty},
                                         {"lots", tabulateLots},
                                         {"detection", countDetections},
                                         {"faults", countFaults},
                                         {"check", countChanges},
                                         {"place", placeOnLinks}}};

int run(std::size_t seeds, const std::string& only, const Common& common) {
  Json json = {{"seeds", seeds}, {"simulated", true}};
  const Trials trials(seeds, common);
  bool first = true;
  for (const Part& part : kParts) {
    if (!only.empty() && only != part.name) continue;
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
}  // namespace hexoderm::cli

int main(int argc, char** argv) {
  using namespace hexoderm;
  keepFreedMemory();
  cli::Common common;
  CLI::App app("The paper's experiments and the accuracy of every method, measured on simulated skins",
               "hexoderm-reproduce");
  std::size_t seeds = 200;
  std::string only;
  cli::takeWholeNumbers(cli::addWithDefault(app, "--seeds", seeds, "Skins per row"), 1, 100'000);
  std::vector<std::string> names;
  for (const cli::Part& part : cli::kParts) names.emplace_back(part.name);
  app.add_option("--only", only, "One part of it")->check(CLI::IsMember(names));
  common.addTo(app);
  app.footer("Example:\n  hexoderm-reproduce --seeds 200");
  app.callback([&] { common.exit_code = cli::run(seeds, only, common); });
  return cli::runProgram(app, argc, argv, common);
}
