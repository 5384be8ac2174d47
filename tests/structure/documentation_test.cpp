// The documents say what the code says.

#include "hexoderm/device/offence.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/io/robot_truth_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/store_version.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/finding.h"
#include "hexoderm/util/finding_advice.h"
#include "hexoderm/util/text.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {
namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The rows of the first Markdown table after `heading`, without its two head lines, cells trimmed.
std::vector<std::vector<std::string>> tableAfter(const std::string& markdown, const std::string& heading) {
  std::vector<std::vector<std::string>> rows;
  bool under_heading = false;
  for (const std::string& line : split(markdown, '\n')) {
    if (line == heading) under_heading = true;
    if (!under_heading) continue;
    if (line.starts_with("|")) {
      std::vector<std::string> row;
      for (const std::string& cell : split(line.substr(1, line.rfind('|') - 1), '|')) row.push_back(trimmed(cell));
      rows.push_back(row);
    } else if (!rows.empty()) {
      break;
    }
  }
  if (rows.size() >= 2) rows.erase(rows.begin(), rows.begin() + 2);
  return rows;
}

TEST(Documentation, FindingsTableSaysWhatTheCodeSays) {
  const std::filesystem::path readme = std::filesystem::path(HEXODERM_SOURCE_DIR) / "core/hexoderm/util/README.md";
  std::vector<std::vector<std::string>> expected;
  for (const FindingDescription& entry : findingTable()) {
    expected.push_back(
        {"`" + std::string(entry.name) + "`", std::string(severityName(entry.severity)), entry.meaning.english()});
  }
  EXPECT_THAT(tableAfter(readFile(readme), "## Findings"), testing::ElementsAreArray(expected));
}

TEST(Documentation, TheTableOfAdviceSaysWhatTheCodeSays) {
  const std::filesystem::path readme = std::filesystem::path(HEXODERM_SOURCE_DIR) / "core/hexoderm/util/README.md";
  std::vector<std::vector<std::string>> expected;
  for (const FindingAdvice& advice : findingAdvice()) {
    std::string buttons;
    for (const FindingRemedy remedy : advice.remedies) {
      buttons += (buttons.empty() ? "" : "; ") + std::string(remedyInWords(remedy));
    }
    expected.push_back({"`" + std::string(codeName(advice.code)) + "`", advice.why.english(),
                        advice.what_to_do.english(), buttons.empty() ? "-" : buttons});
  }
  EXPECT_THAT(tableAfter(readFile(readme), "## Advice on findings"), testing::ElementsAreArray(expected));
}

TEST(Documentation, OffencesTableHasEveryKindInTheOrderOfTheCode) {
  const std::filesystem::path readme =
      std::filesystem::path(HEXODERM_SOURCE_DIR) / "core/hexoderm/device/skinwire/README.md";
  std::vector<std::string> found;
  for (const std::vector<std::string>& row : tableAfter(readFile(readme), "## Offences")) found.push_back(row.at(0));
  std::vector<std::string> expected;
  for (const OffenceKind kind : offenceKinds()) expected.push_back("`" + std::string(offenceName(kind)) + "`");
  EXPECT_EQ(found, expected);
}

std::string formatsPage() {
  return readFile(std::filesystem::path(HEXODERM_SOURCE_DIR) / "resources/formats/README.md");
}

/// Keys by their path in a document, "patches.cells.id": those of an array's items are below the array.
using KeyPaths = std::set<std::string>;

std::string below(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

struct DocumentedKeys {
  KeyPaths written;  ///< by this program, at least in some documents
  KeyPaths always;   ///< in all documents: neither optional nor part of something optional

  void add(const std::string& path, bool optional) {
    written.insert(path);
    const std::size_t dot = path.rfind('.');
    const bool in_optional = dot != std::string::npos && !always.contains(path.substr(0, dot));
    if (!optional && !in_optional) always.insert(path);
  }
};

constexpr const char* kMessageSuffix = "_message";

/// The heading of the page that a link of a table leads to, "[cell model](#cell-model)". Empty: there is none.
std::string linkedHeading(const std::string& value) {
  static const std::regex kLink(R"(\]\(#([\w-]+)\))");
  std::smatch link;
  if (!std::regex_search(value, link, kLink)) return "";
  for (const std::string& line : split(formatsPage(), '\n')) {
    if (!line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : trimmed(line.substr(line.find(' ')))) {
      anchor += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (anchor == link[1]) return line;
  }
  ADD_FAILURE() << "no heading is linked by " << value;
  return "";
}

/// Adds the keys of the table after `heading`, and of the parts that stand in them, below `path`.
void addTable(const std::string& heading, const std::string& path, DocumentedKeys& keys) {
  for (const std::vector<std::string>& row : tableAfter(formatsPage(), heading)) {
    ASSERT_EQ(row.size(), 5U) << heading;
    const std::string key = below(path, std::regex_replace(row[0], std::regex(R"(`|\[\])"), ""));
    if (row[3] == "read") continue;
    keys.add(key, row[3] != "yes" && row[3] != "written");
    const std::string part = linkedHeading(row[1]);
    if (!part.empty() && !key.ends_with(kMessageSuffix)) addTable(part, key, keys);
  }
}

DocumentedKeys documentedKeys(const std::string& heading) {
  DocumentedKeys keys;
  addTable(heading, "", keys);
  return keys;
}

/// Within messages nothing is looked at: they differ from text to text.
void collect(const nlohmann::json& json, const std::string& path, KeyPaths& written) {
  if (json.is_array()) {
    for (const nlohmann::json& item : json) collect(item, path, written);
  }
  if (!json.is_object() || path.ends_with(kMessageSuffix)) return;
  for (const auto& [key, value] : json.items()) {
    written.insert(below(path, key));
    collect(value, below(path, key), written);
  }
}

KeyPaths writtenKeys(const std::string& document) {
  KeyPaths written;
  collect(nlohmann::json::parse(document), "", written);
  return written;
}

/// With every key that a cell model can have.
CellModel fullModel() {
  CellModel model = builtInCellModel("hex-bma150");
  model.name = "own";
  model.forbidden_port_pairs = {{PortNumber(1), PortNumber(1)}};
  model.accelerometer.shared_offset_sigma_g = 0.01;
  model.accelerometer.T_u_a.R = expSO3({0.1, 0.2, 0.3});
  model.sensors = {{"thermometer", "temperature", model.accelerometer.T_u_a}};
  return model;
}

/// With the keys alone that every cell model has, written as an object.
CellModel bareModel() {
  CellModel model = builtInCellModel("hex-bma150");
  model.name = "own";
  return model;
}

/// With every key that a placement can have.
PatchPlacement fullPlacement() {
  PatchPlacement placement;
  placement.origin = CellId(1);
  placement.link = "forearm";
  placement.link_chosen = true;
  placement.points = {{CellId(1), {0, 0, 0.1}, 0.001}};
  placement.distances = {{CellId(1), CellId(2), 0.1, 0.001}};
  placement.place = PatchOnLink{CellId(1), "forearm", {}, Matrix6d(Matrix6d::Identity())};
  return placement;
}

/// With every key that a calibration can have.
Reconstruction fullCalibration() {
  Reconstruction result = makeTestReconstruction();
  result.solver = "global";
  result.options.left_out = {CellId(3)};
  result.model = std::make_shared<const CellModel>(fullModel());
  result.source.text = message("Cell {}", 1);
  result.poses.at(0).label = message("Pose {}", 1);
  PatchReconstruction& patch = result.patches.at(0);
  patch.gap_share = {0.5, 0.1};
  patch.cells.at(0).shape_cov_t_r = Matrix6d::Identity();
  patch.cells.at(0).accel_offset_g = Eigen::Vector3d::Zero();
  patch.cells.at(0).accel_scale = Eigen::Vector3d::Ones();
  result.findings = {makeFinding(FindingCode::LeftOut, message("Cell {}", 3), {CellId(3)})};
  result.assessment = {.level = VerdictLevel::Good,
                       .reason = message("Cell {}", 1),
                       .position_95_m = 0.001,
                       .orientation_95_rad = 0.01,
                       .next_action = message("Cell {}", 1)};
  result.robot = RobotDescription{"arm.urdf", "00", {{"arm", "/arm"}}};
  result.placements = {fullPlacement()};
  return result;
}

/// One of everything that a calibration always has, without whatever may be missing.
Reconstruction bareCalibration() {
  Reconstruction result = test::ResultBuilder().build();
  result.solver = "imported";
  result.model = std::make_shared<const CellModel>(bareModel());
  result.poses.resize(1);
  PatchReconstruction patch;
  patch.gravity.resize(1);
  patch.cells.resize(1);
  patch.cells[0].sensors.resize(1);
  patch.links.resize(1);
  result.patches = {patch};
  result.findings.resize(1);
  return result;
}

TEST(Documentation, KeysOfACalibrationAreThoseThatAreWritten) {
  const DocumentedKeys documented = documentedKeys("## Calibration");
  EXPECT_THAT(writtenKeys(calibrationToJson(fullCalibration())), testing::ContainerEq(documented.written));
  EXPECT_THAT(writtenKeys(calibrationToJson(bareCalibration())), testing::ContainerEq(documented.always));
}

/// With every key that a session can have.
Session fullSession() {
  const CellReport cell = {CellId(1), "arm", {{PortNumber(1), CellId(2), PortNumber(3)}}};
  Session session(fullModel(), {cell}, {message("Cell {}", 1), {}, {}});
  PoseCapture pose;
  pose.label = message("Pose {}", 1);
  pose.taken_at_ms = 1;
  GravitySample sample;
  sample.cov_g2 = Eigen::Matrix3d::Identity();
  sample.count = 1;
  sample.temperature_c = 20;
  pose.samples = {sample};
  session.addPose({std::make_shared<const PoseCapture>(pose), true, "bumped", {{{"elbow", 0.5}}}});
  session.setLinkMuted({CellId(1), PortNumber(1)}, {CellId(2), PortNumber(3)}, true, "a cable");
  session.setTruth({"body", {{CellId(1), {}}}});
  session.setRobot(RobotDescription{"arm.urdf", "00", {{"arm", "/arm"}}});
  session.setPlacement(fullPlacement());
  return session;
}

/// One of everything that a session always has, without whatever may be missing.
Session bareSession() {
  Session session(bareModel(), {{CellId(1), "", {{PortNumber(1), CellId(2), std::nullopt}}}});
  PoseCapture pose;
  pose.samples.resize(1);
  session.addPose({std::make_shared<const PoseCapture>(pose)});
  return session;
}

TEST(Documentation, KeysOfASessionAreThoseThatAreWritten) {
  const DocumentedKeys documented = documentedKeys("## Session");
  EXPECT_THAT(writtenKeys(sessionToJson(fullSession())), testing::ContainerEq(documented.written));
  EXPECT_THAT(writtenKeys(sessionToJson(bareSession())), testing::ContainerEq(documented.always));
}

TEST(Documentation, KeysOfPlacementsAreThoseThatAreWritten) {
  const DocumentedKeys documented = documentedKeys("## Placements");
  PatchOnLink place{CellId(1), "forearm", {}, Matrix6d(Matrix6d::Identity())};
  EXPECT_THAT(writtenKeys(placementsToJson({place})), testing::ContainerEq(documented.written));
  place.cov_t_r.reset();
  EXPECT_THAT(writtenKeys(placementsToJson({place})), testing::ContainerEq(documented.always));
}

nlohmann::json schemaOf(const std::string& document) {
  return nlohmann::json::parse(
      readFile(std::filesystem::path(HEXODERM_SOURCE_DIR) / "resources/formats" / (document + ".schema.json")));
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

TEST(Documentation, SchemasHaveTheNamesAndVersionsOfTheCode) {
  const nlohmann::json calibration = schemaOf("calibration");
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

  EXPECT_EQ(keys["format"]["const"], kCalibrationFormat);
  ASSERT_EQ(keys["version"]["enum"].size(), kCalibrationVersion);
  EXPECT_EQ(keys["version"]["enum"].back(), kCalibrationVersion);
  const auto expectVersion = [](const std::string& document, std::string_view format, std::uint32_t version) {
    const nlohmann::json schema = schemaOf(document);
    EXPECT_EQ(schema["properties"]["format"]["const"], format);
    EXPECT_EQ(schema["properties"]["version"]["const"], version) << document;
  };
  expectVersion("session", kSessionFormat, kSessionVersion);
  expectVersion("placements", kPlacementsFormat, kPlacementsVersion);
  expectVersion("robot_truth", kRobotTruthFormat, kRobotTruthVersion);
}

TEST(Documentation, ChangelogAndCitationHaveTheVersionsOfTheCode) {
  const std::filesystem::path root = HEXODERM_SOURCE_DIR;
  const std::string changes = readFile(root / "CHANGELOG.md");
  std::smatch newest;
  ASSERT_TRUE(std::regex_search(changes, newest, std::regex(R"(\n## (\d\S*\d)\b)")));
  EXPECT_EQ(newest[1], HEXODERM_VERSION);
  EXPECT_THAT(readFile(root / ".github" / "CITATION.cff"), testing::HasSubstr("\nversion: " HEXODERM_VERSION "\n"));

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
