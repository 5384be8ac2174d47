// A hand turns the part while it is sampled. Over so few samples that does not average out, and far from the middle
// cells read another force than near it: no cell is to blame for that.

#include "hexoderm/reconstruction/reconstructor.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace hexoderm {
namespace {

using ::testing::IsEmpty;

class SwungSkin : public ::testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, SwungSkin, ::testing::Values(Solver::Global, Solver::Tree), test::solverOfTest);

/// What was found about attitudes. A reading of more than 1.3 g or less than 0.7 g is another matter.
std::vector<std::string> blamed(const Reconstruction& result) {
  std::vector<std::string> about;
  for (const Finding& finding : result.findings) {
    if (finding.code == FindingCode::WrongNorm || finding.severity == Severity::Info) continue;
    about.push_back(finding.message.english());
  }
  return about;
}

TEST_P(SwungSkin, NoCellIsBlamedForWhatAHandDoes) {
  constexpr std::uint64_t kSeeds = 12;
  constexpr int kSamples = 10;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Session session =
        test::simulatedSession(test::skinOptions("sheet:10x12", "cylinder:r=0.1", seed), 4, kSamples);
    EXPECT_THAT(blamed(*reconstruct(*session.snapshot(), test::by(GetParam()))), IsEmpty()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hexoderm
