// The documents say what the code says.

#include "hexoderm/device/offence.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/finding.h"
#include "hexoderm/util/finding_advice.h"
#include "hexoderm/util/text.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
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

std::string ioReadme() { return readFile(std::filesystem::path(HEXODERM_SOURCE_DIR) / "core/hexoderm/io/README.md"); }

/// Keys by their path in a document, "patches.cells.id": those of an array's items are below the array.
using KeyPaths = std::set<std::string>;

std::string below(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

struct DocumentedKeys {
  KeyPaths all;
  KeyPaths required;  ///< neither optional nor part of something optional

  void add(const std::string& path, bool optional) {
    all.insert(path);
    const std::size_t dot = path.rfind('.');
    const bool in_optional = dot != std::string::npos && !required.contains(path.substr(0, dot));
    if (!optional && !in_optional) required.insert(path);
  }
};

/// Keys of an object as the documents write it, `{"id", "ports": [{"port", "cell_port"?}]}`, below `path`.
void addObject(const std::string& object, const std::string& path, DocumentedKeys& keys) {
  std::vector<std::string> stack;  // of the objects that are open
  std::string latest = path;
  static const std::regex kKey(R"re([{,]\s*"(\w+)"(\?)?)re");
  for (std::size_t at = 0; at < object.size(); ++at) {
    if (object[at] == '}') stack.pop_back();
    if (object[at] == '{') stack.push_back(latest);
    std::smatch match;
    const auto here = object.begin() + static_cast<std::ptrdiff_t>(at);
    if (!std::regex_search(here, object.end(), match, kKey, std::regex_constants::match_continuous)) continue;
    latest = below(stack.back(), match[1]);
    keys.add(latest, match[2].matched);
  }
}

/// Keys of the table after `heading`: one or several keys or a path in the first column, and perhaps the object that
/// stands there in the second.
DocumentedKeys documentedKeys(const std::string& heading) {
  static const std::regex kKey(R"(`([\w.\[\]]+)`(\?)?)");
  static const std::regex kObject(R"(`(\{[^`]*\})`)");
  DocumentedKeys keys;
  for (const std::vector<std::string>& row : tableAfter(ioReadme(), heading)) {
    std::string path;
    for (std::sregex_iterator key(row.at(0).begin(), row.at(0).end(), kKey), end; key != end; ++key) {
      path = std::regex_replace((*key)[1].str(), std::regex(R"(\[\])"), "");
      if (!keys.all.contains(path)) keys.add(path, (*key)[2].matched);
    }
    std::smatch object;
    if (std::regex_search(row.at(1), object, kObject)) addObject(object[1], path, keys);
  }
  return keys;
}

struct WrittenKeys {
  KeyPaths keys;
  std::set<std::string> messages;  ///< keys with a message behind them
};

/// What the document describes elsewhere, the cell model and the solver's options, is looked at no further.
void collect(const nlohmann::json& json, const std::string& path, WrittenKeys& written) {
  if (path == "cell_model" || path == "options") return;
  if (json.is_array()) {
    for (const nlohmann::json& item : json) collect(item, path, written);
  }
  if (!json.is_object()) return;
  const std::string suffix = "_message";
  for (const auto& [key, value] : json.items()) {
    if (key.ends_with(suffix)) {
      written.messages.insert(key.substr(0, key.size() - suffix.size()));
      continue;
    }
    written.keys.insert(below(path, key));
    collect(value, below(path, key), written);
  }
}

WrittenKeys writtenKeys(const std::string& document) {
  WrittenKeys written;
  collect(nlohmann::json::parse(document), "", written);
  return written;
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
  const DocumentedKeys documented = documentedKeys("## Calibration, `*.calibration.json`");
  const WrittenKeys full = writtenKeys(calibrationToJson(fullCalibration()));
  EXPECT_THAT(full.keys, testing::ContainerEq(documented.all));
  EXPECT_THAT(writtenKeys(calibrationToJson(bareCalibration())).keys, testing::ContainerEq(documented.required));

  std::smatch sentence;
  const std::string readme = ioReadme();
  ASSERT_TRUE(std::regex_search(readme, sentence, std::regex(R"(\n(`.*`) are English; where Hexoderm made them)")));
  std::set<std::string> messages;
  const std::string names = sentence[1];
  static const std::regex kName("`(\\w+)`");
  for (std::sregex_iterator name(names.begin(), names.end(), kName), end; name != end; ++name) {
    messages.insert((*name)[1]);
  }
  EXPECT_EQ(full.messages, messages);
}

/// With every key that a session can have.
Session fullSession() {
  const CellReport cell = {CellId(1), "arm", {{PortNumber(1), CellId(2), PortNumber(3)}}};
  Session session(builtInCellModel("hex-bma150"), {cell}, {message("Cell {}", 1), {}, {}});
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
  Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {{PortNumber(1), CellId(2), std::nullopt}}}});
  PoseCapture pose;
  pose.samples.resize(1);
  session.addPose({std::make_shared<const PoseCapture>(pose)});
  return session;
}

TEST(Documentation, KeysOfASessionAreThoseThatAreWritten) {
  const DocumentedKeys documented = documentedKeys("## Session, `*.session.json`");
  EXPECT_THAT(writtenKeys(sessionToJson(fullSession())).keys, testing::ContainerEq(documented.all));
  EXPECT_THAT(writtenKeys(sessionToJson(bareSession())).keys, testing::ContainerEq(documented.required));
}

}  // namespace
}  // namespace hexoderm
