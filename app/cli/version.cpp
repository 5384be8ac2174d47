#include "app/cli/version.h"

#include "hexoderm/base/library_versions.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/store_version.h"
#include "hexoderm/sim/robot_truth_json.h"

#include <CLI/CLI.hpp>
#include <sstream>
#include <string_view>

namespace hexoderm::cli {

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

}  // namespace hexoderm::cli
