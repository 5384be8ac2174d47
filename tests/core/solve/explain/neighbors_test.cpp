#include "hexoderm/solve/explain/explainer.h"

#include "hexoderm/solve/faults/suspects.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/estimated_links.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Neighbors, ACellThatContradictsItsNeighboursIsDroppedInsteadOfItsLinks) {
  const Session session = changed(bentX17().session(orthogonalUps(4)), [](std::size_t pose, GravitySample& sample) {
    const Eigen::Vector3d read_g = sample.mean_g;
    if (sample.cell == CellId(3) && pose == 0) sample.mean_g = Eigen::Vector3d(read_g.z(), read_g.x(), read_g.y());
  });
  const auto result = reconstruct(*session.snapshot());
  EXPECT_THAT(result->findings, ElementsAre(Field(&Finding::cells, ElementsAre(CellId(3)))));
  EXPECT_EQ(result->find(CellId(3)).cell->placed_by, PlacedBy::Links);
  EXPECT_THAT(result->patches.at(0).links, Each(Field(&LinkEstimate::used, true)));
}

/// As makeNeighborExplainer() chooses cells, but with everything estimated and judged anew after each: what it must
/// agree with.
std::vector<std::size_t> cellsDroppedTheLongWay(SkinLinks& skin) {
  std::vector<std::size_t> dropped;
  while (true) {
    const SuspectSearch search(skin);
    if (search.worstPose()) return dropped;
    const auto cell = search.worstCell();
    if (!cell) return dropped;
    dropped.push_back(*cell);
    skin.dropCell(*cell);
    skin.estimateEdges();
  }
}

void expectSameEdges(const SkinLinks& a, const SkinLinks& b) {
  ASSERT_EQ(a.edges().size(), b.edges().size());
  for (std::size_t link = 0; link < a.edges().size(); ++link) {
    EXPECT_EQ(a.edges()[link].R_c_n, b.edges()[link].R_c_n) << link;
    EXPECT_EQ(a.edges()[link].covariance, b.edges()[link].covariance) << link;
    EXPECT_EQ(a.edges()[link].quality, b.edges()[link].quality) << link;
    EXPECT_EQ(a.poseResiduals(link), b.poseResiduals(link)) << link;
  }
}

TEST(NeighborsOfManyCells, AreJudgedTheSameToTheLastBitAndCostsNoMoreThanTheLinksConcerned) {
  for (const std::uint64_t seed : {3U, 104U, 105U}) {
    SimulatedSkinOptions options = test::skinOptions("sheet:12x13", "cylinder:r=0.1", seed);
    // Some stand beside each other, so that what a cell without readings is guessed to read depends on others.
    for (const std::uint32_t id : {20U, 21U, 34U, 47U, 60U, 90U, 103U, 120U, 140U}) {
      options.faults.push_back({SkinFault::WrongGain, CellId(id)});
    }
    const Session session = test::simulatedSession(options, 4);
    test::EstimatedLinks all(session);
    test::EstimatedLinks some(session);
    SkinLinks& around = some.links;
    const std::vector<std::size_t> dropped = cellsDroppedTheLongWay(all.links);
    EXPECT_GE(dropped.size(), 3U) << "seed " << seed;
    SuspectSearch search(around);
    std::vector<std::size_t> chosen;
    std::size_t judged = 0;
    while (const auto cell = search.worstCell()) {
      chosen.push_back(*cell);
      around.dropCell(*cell);
      const std::vector<std::size_t> links = around.estimateEdgesAround(*cell);
      judged += links.size();
      search.update(links);
    }
    EXPECT_EQ(chosen, dropped) << "seed " << seed;
    expectSameEdges(around, all.links);
    EXPECT_LE(judged, 4 * dropped.size() * dropped.size()) << "at most all links of those dropped so far, each time";
    EXPECT_LT(judged, 8 * dropped.size()) << "seed " << seed << ": hardly more than their own";
  }
}

}  // namespace
}  // namespace hexoderm
