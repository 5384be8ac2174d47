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

  nlohmann::json solvers = namesOf(solverName);
  solvers.push_back("imported");
  const std::pair<const char*, nlohmann::json> enumerations[] = {
      {"/$defs/finding_code", codes},
      {"/$defs/link/properties/quality", namesOf(qualityName)},
      {"/properties/findings/items/properties/severity", namesOf(severityName)},
      {"/properties/verdict/properties/level", namesOf(verdictName)},
      {"/properties/verdict/properties/limit", namesOf(limitName)},
      {"/properties/verdict/properties/remedy", namesOf(remedyName)},
      {"/properties/solver", solvers},
      {"/allOf/0/then/properties/gap_model", namesOf(gapModelName)},
      {"/properties/options/properties/centre", namesOf(centringName)},
      {"/properties/options/properties/support-axes", namesOf(supportAxesName)},
      {"/properties/options/properties/weights", namesOf(linkWeightsName)}};
  for (const auto& [pointer, names] : enumerations) {
    EXPECT_EQ(calibration.at(nlohmann::json::json_pointer(pointer)).at("enum"), names) << pointer;
  }
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
