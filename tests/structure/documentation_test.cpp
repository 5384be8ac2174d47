// The documents say what the code says.

#include "hexoderm/device/offence.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/finding.h"
#include "hexoderm/util/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
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

TEST(Documentation, OffencesTableHasEveryKindInTheOrderOfTheCode) {
  const std::filesystem::path readme =
      std::filesystem::path(HEXODERM_SOURCE_DIR) / "core/hexoderm/device/skinwire/README.md";
  std::vector<std::string> found;
  for (const std::vector<std::string>& row : tableAfter(readFile(readme), "## Offences")) found.push_back(row.at(0));
  std::vector<std::string> expected;
  for (const OffenceKind kind : offenceKinds()) expected.push_back("`" + std::string(offenceName(kind)) + "`");
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace hexoderm
