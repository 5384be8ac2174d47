#include "hexoderm/util/finding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace hexoderm {
namespace {

TEST(FindingAdvice, EveryCodeHasItsReasonAndWhatToDo) {
  for (std::size_t k = 0; k < findingTable().size(); ++k) {
    const FindingDescription& advice = findingTable()[k];
    const std::string name(advice.name);
    EXPECT_EQ(static_cast<std::size_t>(advice.code), k) << name;
    EXPECT_EQ(&descriptionOf(advice.code), &advice) << name;
    for (const Message& text : {advice.why, advice.what_to_do}) {
      ASSERT_FALSE(text.empty()) << name;
      EXPECT_EQ(text.english().back(), '.') << name;
      EXPECT_NE(text, advice.meaning) << name << " only says it again";
    }
    const std::set<FindingRemedy> once(advice.remedies.begin(), advice.remedies.end());
    EXPECT_EQ(once.size(), advice.remedies.size()) << name;
  }
}

TEST(FindingAdvice, WhatIsWrongWithAPoseCanBeDoneAboutThePose) {
  for (const FindingCode code : {FindingCode::PartMoved, FindingCode::InconsistentPose}) {
    const std::vector<FindingRemedy>& remedies = descriptionOf(code).remedies;
    EXPECT_EQ(remedies, (std::vector{FindingRemedy::RecapturePose, FindingRemedy::DisablePose}));
  }
  for (const FindingCode code : {FindingCode::LinkNotRigid, FindingCode::ImplausibleBend}) {
    EXPECT_EQ(std::ranges::count(descriptionOf(code).remedies, FindingRemedy::MuteLink), 1);
  }
}

}  // namespace
}  // namespace hexoderm
