#include "hexoderm/base/finding.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(FindingTable, SaysOfEveryCodeItsNameItsReasonAndWhatToDo) {
  for (std::size_t k = 0; k < findingTable().size(); ++k) {
    const FindingDescription& entry = findingTable()[k];
    const std::string name(entry.name);
    EXPECT_EQ(static_cast<std::size_t>(entry.code), k) << name;
    EXPECT_EQ(&descriptionOf(entry.code), &entry) << name;
    EXPECT_EQ(codeName(entry.code), entry.name);
    EXPECT_EQ(codeFromName(entry.name), entry.code) << name << " names two codes";
    EXPECT_FALSE(entry.meaning.empty()) << name;
    for (const Message& text : {entry.why, entry.what_to_do}) {
      ASSERT_FALSE(text.empty()) << name;
      EXPECT_EQ(text.english().back(), '.') << name;
      EXPECT_NE(text, entry.meaning) << name << " only says it again";
    }
    const std::set<FindingRemedy> once(entry.remedies.begin(), entry.remedies.end());
    EXPECT_EQ(once.size(), entry.remedies.size()) << name;
  }
  EXPECT_EQ(codeFromName("no-such-code"), std::nullopt);
  EXPECT_EQ(codeFromName(""), std::nullopt);
}

TEST(FindingTable, WhatIsWrongWithAPoseCanBeDoneAboutThePose) {
  for (const FindingCode code : {FindingCode::PartMoved, FindingCode::InconsistentPose}) {
    const std::vector<FindingRemedy>& remedies = descriptionOf(code).remedies;
    EXPECT_EQ(remedies, (std::vector{FindingRemedy::RecapturePose, FindingRemedy::DisablePose}));
  }
  for (const FindingCode code : {FindingCode::LinkNotRigid, FindingCode::ImplausibleBend}) {
    EXPECT_EQ(std::ranges::count(descriptionOf(code).remedies, FindingRemedy::MuteLink), 1);
  }
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
