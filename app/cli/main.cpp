#include "app/cli/command.h"
#include "app/cli/version.h"

#include "hexoderm/base/freed_memory.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/sim/simulated_source.h"

int main(int argc, char** argv) {
  using namespace hexoderm;
  keepFreedMemory();
  keepWhatIsRead();
  addSimulatedSources();
  cli::Common common;
  CLI::App app("Finds where every cell of a robot's artificial skin is", "hexoderm-cli");
  app.set_version_flag("--version", cli::versionText, "Display version, commit, formats and libraries, and exit");
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 the verdict is not_enough or failed (the output is still written), check found changes,\n"
      "or parts can't tell;\n"
      "2 usage; 3 bad input; 4 device; 5 storage.\n\n"
      "A first calibration, of a simulated skin:\n"
      "  hexoderm-cli simulate --poses 3 -o arm.session.json\n"
      "  hexoderm-cli solve arm.session.json -o arm.calibration.json\n"
      "  hexoderm-cli export arm.calibration.json --to urdf -o arm.urdf");
  for (cli::AddCommand* add : {cli::addSimulate, cli::addCapture, cli::addListen, cli::addSolve, cli::addEvaluate,
                               cli::addCheck, cli::addExport, cli::addConvert, cli::addInspect, cli::addSensors,
                               cli::addParts, cli::addLinks, cli::addPlace}) {
    add(app, common);
  }
  for (CLI::App* command : app.get_subcommands({})) common.addTo(*command);
  app.parse_complete_callback([&] {
    for (const CLI::App* command : app.get_subcommands()) cli::requireReplaceableOutputs(*command);
  });

  return cli::runProgram(app, argc, argv, common);
}
