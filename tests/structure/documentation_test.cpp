// The documents say what the code says.

#include "hexoderm/base/file.h"
#include "hexoderm/base/finding.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/store_version.h"
#include "hexoderm/sim/robot_truth_json.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {
namespace {

std::string fileOfTheProject(const std::string& path) {
  return readFile(std::filesystem::path(HEXODERM_SOURCE_DIR) / path);
}

TEST(Documentation, FindingsTableSaysWhatTheCodeSays) {
  std::string table = "| code | severity | meaning |\n| --- | --- | --- |\n";
  for (const FindingDescription& entry : findingTable()) {
    table += "| `" + std::string(entry.name) + "` | " + std::string(severityName(entry.severity)) + " | " +
             entry.meaning.english() + " |\n";
  }
  EXPECT_THAT(fileOfTheProject("core/hexoderm/base/README.md"), testing::HasSubstr("\n\n" + table + "\n"));
}

TEST(Documentation, ProtocolViolationsTableHasEveryKindInTheOrderOfTheCode) {
  const std::string page = fileOfTheProject("core/hexoderm/device/skinwire/README.md");
  const std::size_t begin = page.find("## Offences");
  std::vector<std::string> found;
  for (const std::string& line : split(page.substr(begin, page.find("\n## ", begin) - begin), '\n')) {
    if (line.starts_with("| `")) found.push_back(line.substr(3, line.find("` |") - 3));
  }
  std::vector<std::string> expected;
  for (const ProtocolViolationKind kind : offenceKinds()) expected.emplace_back(offenceName(kind));
  EXPECT_EQ(found, expected);
}

/// The names of an enumeration as in files, in its order.
template <class Enum>
nlohmann::json namesOf(std::string_view (*name)(Enum)) {
  nlohmann::json names = nlohmann::json::array();
  try {
    for (int value = 0;; ++value) names.push_back(name(static_cast<Enum>(value)));
  } catch (const std::out_of_range&) {
    return names;
  }
}

TEST(Documentation, TheSchemaOfCalibrationsHasTheNamesOfTheCode) {
  const auto calibration = nlohmann::json::parse(fileOfTheProject("resources/formats/calibration.schema.json"));
  nlohmann::json codes = nlohmann::json::array();
  for (const FindingDescription& entry : findingTable()) codes.push_back(entry.name);
  EXPECT_EQ(calibration["$defs"]["finding_code"]["enum"], codes);

  const nlohmann::json& keys = calibration["properties"];
  EXPECT_EQ(keys["findings"]["items"]["properties"]["severity"]["enum"], namesOf(severityName));
  const nlohmann::json& verdict = keys["verdict"]["properties"];
  EXPECT_EQ(verdict["level"]["enum"], namesOf(verdictName));
  EXPECT_EQ(verdict["limit"]["enum"], namesOf(limitName));
  EXPECT_EQ(verdict["remedy"]["enum"], namesOf(remedyName));
  EXPECT_EQ(calibration["$defs"]["link"]["properties"]["quality"]["enum"], namesOf(qualityName));
  nlohmann::json solvers = namesOf(solverName);
  solvers.push_back("imported");
  EXPECT_EQ(keys["solver"]["enum"], solvers);
  EXPECT_EQ(calibration["allOf"][0]["then"]["properties"]["gap_model"]["enum"], namesOf(gapModelName));
  const nlohmann::json& options = keys["options"]["properties"];
  EXPECT_EQ(options["centre"]["enum"], namesOf(centringName));
  EXPECT_EQ(options["support-axes"]["enum"], namesOf(supportAxesName));
  EXPECT_EQ(options["weights"]["enum"], namesOf(linkWeightsName));
}

TEST(Documentation, ChangelogAndCitationHaveTheVersionsOfTheCode) {
  const std::string changes = fileOfTheProject("CHANGELOG.md");
  std::smatch newest;
  ASSERT_TRUE(std::regex_search(changes, newest, std::regex(R"(\n## (\d\S*\d)\b)")));
  EXPECT_EQ(newest[1], HEXODERM_VERSION);
  EXPECT_THAT(fileOfTheProject(".github/CITATION.cff"), testing::HasSubstr("\nversion: " HEXODERM_VERSION "\n"));

  const auto expectVersion = [&](const std::string& what, const std::string& version) {
    EXPECT_THAT(changes, testing::HasSubstr("\n| " + what + " | " + version + " | "));
  };
  expectVersion("`*.session.json`", std::to_string(kSessionVersion));
  expectVersion("`*.calibration.json`", std::to_string(kCalibrationVersion));
  expectVersion("`*.placements.json`", std::to_string(kPlacementsVersion));
  expectVersion("`*.truth.json`", std::to_string(kRobotTruthVersion));
  expectVersion("`*.hexo`", std::to_string(kStoreVersion));
  expectVersion("SkinWire", std::to_string(skinwire::kMajor) + "." + std::to_string(skinwire::kMinor));
}

}  // namespace
}  // namespace hexoderm
