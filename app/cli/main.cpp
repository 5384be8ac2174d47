#include "app/cli/command.h"

#include "hexoderm/base/freed_memory.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/library_versions.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/store_version.h"
#include "hexoderm/sim/robot_truth_json.h"
#include "hexoderm/sim/simulated_source.h"

#include <sstream>
#include <string_view>

namespace hexoderm::cli {

/// The commit of the sources, and whether they had changes; empty if it is not known. Defined in a source that is
/// written when the program is built.
extern const char* const kCommit;

namespace {

/// What `--version` says: version and commit, versions of files and wire, and libraries. The first line is the
/// program's name and version.
std::string versionText() {
  std::ostringstream text;
  text << "hexoderm-cli " HEXODERM_VERSION "\n";
  text << "commit: " << (std::string_view(kCommit).empty() ? "not known" : kCommit) << '\n';
  text << "files: session " << kSessionVersion << ", calibration " << kCalibrationVersion << ", placements "
       << kPlacementsVersion << ", robot truth " << kRobotTruthVersion << ", journal (*.hexo) " << kStoreVersion
       << '\n';
  text << "wire: SkinWire " << int{skinwire::kMajor} << '.' << skinwire::kMinor << '\n';
  text << "libraries: CLI11 " CLI11_VERSION;
  for (const LibraryVersion& library : libraryVersions()) text << ", " << library.name << ' ' << library.version;
  return text.str();
}

}  // namespace
}  // namespace hexoderm::cli

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
      "Exit codes: 0 done; 1 the result is not good enough, and the output is still written: the verdict is "
      "not_enough,\n"
      "not_trusted (with export too) or failed, no pose was captured, check found changes, listen an obstacle, "
      "sensors,\n"
      "parts, links or place can't tell; 2 usage; 3 bad input; 4 device; 5 storage; 130 interrupted.\n\n"
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
