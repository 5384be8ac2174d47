#include "hexoderm/util/finding.h"

#include <gtest/gtest.h>

#include <set>

namespace hexoderm {
namespace {

TEST(FindingTable, HasOneEntryPerCodeInOrder) {
  std::set<std::string_view> names;
  ASSERT_FALSE(findingTable().empty());
  for (std::size_t k = 0; k < findingTable().size(); ++k) {
    const FindingDescription& entry = findingTable()[k];
    EXPECT_EQ(static_cast<std::size_t>(entry.code), k) << entry.name;
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " names two codes";
    EXPECT_FALSE(entry.meaning.empty()) << entry.name;
  }
}

TEST(FindingTable, NamesLeadBackToTheirCodes) {
  for (const FindingDescription& entry : findingTable()) {
    EXPECT_EQ(codeName(entry.code), entry.name);
    EXPECT_EQ(codeFromName(entry.name), entry.code);
  }
  EXPECT_EQ(codeFromName("no-such-code"), std::nullopt);
  EXPECT_EQ(codeFromName(""), std::nullopt);
}

TEST(Severity, NamesLeadBack) {
  for (const Severity severity : {Severity::Info, Severity::Warning, Severity::Error}) {
    EXPECT_EQ(severityFromName(severityName(severity)), severity);
  }
  EXPECT_EQ(severityFromName("fatal"), std::nullopt);
}

TEST(MakeFinding, TakesTheSeverityOfItsCode) {
  const Finding finding = makeFinding(FindingCode::StuckSensor, Message::verbatim("Cell 7 is stuck."), {CellId(7)},
                                      {PortNumber(2)}, {PoseId(3)});
  EXPECT_EQ(finding.severity, Severity::Error);
  EXPECT_EQ(finding.message.english(), "Cell 7 is stuck.");
  EXPECT_EQ(finding.cells, std::vector{CellId(7)});
  EXPECT_EQ(finding.ports, std::vector{PortNumber(2)});
  EXPECT_EQ(finding.poses, std::vector{PoseId(3)});
  EXPECT_EQ(makeFinding(FindingCode::InterfaceLink, Message()).severity, Severity::Info);
}

}  // namespace
}  // namespace hexoderm
