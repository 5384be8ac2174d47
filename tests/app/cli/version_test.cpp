// What --version says.

#include "hexoderm/base/text.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/store_version.h"
#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

using ::testing::MatchesRegex;

TEST_F(Cli, VersionSaysCommitFormatsAndLibraries) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = split(outcome.out, '\n');
  ASSERT_EQ(lines.size(), 6U) << outcome.out;
  EXPECT_EQ(lines[0], "hexoderm-cli " HEXODERM_VERSION);
  EXPECT_THAT(lines[1], MatchesRegex("commit: .+"));
  EXPECT_THAT(lines[2], HasSubstr("session " + std::to_string(kSessionVersion)));
  EXPECT_THAT(lines[2], HasSubstr("calibration " + std::to_string(kCalibrationVersion)));
  EXPECT_THAT(lines[2], HasSubstr("(*.hexo) " + std::to_string(kStoreVersion)));
  EXPECT_EQ(lines[3], "wire: SkinWire " + std::to_string(skinwire::kMajor) + "." + std::to_string(skinwire::kMinor));
  EXPECT_THAT(lines[4], MatchesRegex("libraries: [A-Za-z_0-9 ]+ [0-9.]+(, [A-Za-z_ ]+ [0-9.]+)*"));
  for (const char* library : {"CLI11", "Boost", "Eigen", "fmt", "libzip", "nlohmann_json", "OpenSSL", "Orocos KDL",
                              "Protocol Buffers", "pugixml", "SQLite", "urdfdom"}) {
    EXPECT_THAT(lines[4], HasSubstr(std::string(library) + " "));
  }
  EXPECT_EQ(lines[5], "");
}

}  // namespace
}  // namespace hexoderm
