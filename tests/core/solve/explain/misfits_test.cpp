#include "hexoderm/solve/explain/explainer.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Misfits, OfCellsFarApartAreExplainedInOneRound) {
  SimulatedSkinOptions options = test::skinOptions("sheet:12x13", "cylinder:r=0.1", 3);
  options.faults = {
      {SkinFault::Reglued, CellId(20)}, {SkinFault::Reglued, CellId(80)}, {SkinFault::Reglued, CellId(140)}};
  const Session session = test::simulatedSession(options, 6);
  const std::shared_ptr<const SessionSnapshot> snapshot = session.snapshot();
  const SolverOptions options_of_solver;
  Estimate estimate(*snapshot, options_of_solver);
  ASSERT_EQ(estimate.bringTo(Estimate::Stage::Patches, {}), Completion::Finished);
  const std::optional<Explanation> found = makeMisfitExplainer().explain(estimate);
  ASSERT_TRUE(found);
  std::vector<CellId> cells;
  for (const std::size_t cell : found->cells) cells.push_back(estimate.skin().graph().cells()[cell].id);
  EXPECT_GT(cells.size(), 1U);
  EXPECT_THAT(cells, Each(testing::AnyOf(CellId(20), CellId(80), CellId(140))));
}

}  // namespace
}  // namespace hexoderm
