#include "hexoderm/solve/reconstructor.h"
#include "tests/support/corrupted_readings.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(ShiftedIds, AreTheOnlyFindingAndNothingIsTrusted) {
  for (const auto& [patch, surface] :
       {std::pair("sheet:5x5", "cylinder:r=0.08"), std::pair("sheet:8x8", "sphere:r=0.2")}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Session session = test::simulatedSession(test::skinOptions(patch, surface, seed), 4);
      EXPECT_THAT(reconstruct(*session.snapshot())->findings, IsEmpty()) << patch << ", seed " << seed;
      const auto result = reconstruct(*test::mixedWithPrevious(session, 1).snapshot());
      EXPECT_THAT(result->findings, ElementsAre(Field(&Finding::code, FindingCode::ContradictsModel)))
          << patch << ", seed " << seed;
      EXPECT_EQ(result->assessment.level, VerdictLevel::NotTrusted);
    }
  }
}

}  // namespace
}  // namespace hexoderm
