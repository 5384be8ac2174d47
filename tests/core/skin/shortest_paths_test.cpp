#include "hexoderm/skin/shortest_paths.h"

#include "hexoderm/skin/origin_search.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::joinCells;
using test::listOfCells;
using test::listOfSheet;
using test::modelOfMany;

TEST(Origin, RealWeightsOfALargePatchTakeFewRuns) {
  for (const unsigned seed : {3U, 104U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.5, 4);
    const SkinGraph graph(modelOfMany(), listOfSheet(100, 101));
    std::vector<double> weights(graph.links().size());
    for (double& weight : weights) weight = uniform(random);
    EXPECT_LE(searchOrigin(graph, weights, 0).runs, 71U) << "seed " << seed;
  }
}

TEST(Origin, TiesGoToTheSmallestId) {
  const SkinGraph ring(modelOfMany(), listOfSheet(1, 8, true));
  const std::vector<double> ones(ring.links().size(), 1);
  EXPECT_EQ(findOrigin(ring, ones, 0), 0);
  const SkinGraph even_line(modelOfMany(), listOfSheet(1, 8));
  EXPECT_EQ(findOrigin(even_line, std::vector<double>(7, 1), 0), 3);
}

TEST(ShortestPaths, PreferFewerLinksThenTheSmallestPredecessor) {
  //   1 - 2 - 3        1-2-3 costs 1 + 1, 1-4-3 costs 1 + 1: through 2, the smaller ID.
  //   |       |        1-5 costs 2 by one link and 1 + 1 by two (1-2, 2-5): the one link.
  //   4 ------+
  NeighborList list = listOfCells(5);
  joinCells(list, 1, 1, 2, 4);
  joinCells(list, 2, 1, 3, 4);
  joinCells(list, 1, 2, 4, 3);
  joinCells(list, 4, 1, 3, 3);
  joinCells(list, 1, 3, 5, 2);
  joinCells(list, 2, 2, 5, 3);
  const SkinGraph graph(modelOfMany(), list);
  std::vector<double> weights(graph.links().size(), 1);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const GraphLink& link = graph.links()[k];
    if (link.source == 0 && link.target == 4) weights[k] = 2;
  }
  const ShortestPaths paths = findShortestPaths(graph, weights, 0);
  EXPECT_EQ(paths.predecessor[2], 1);
  EXPECT_EQ(paths.predecessor[4], 0);
  EXPECT_EQ(paths.distance[4], 2);
  EXPECT_EQ(paths.predecessor[0], kNoIndex);
}

TEST(ShortestPaths, AreAsLargeAsTheirPatch) {
  SkinGraph graph(modelOfMany(), listOfSheet(1, 7));
  const std::size_t muted[] = {3};
  graph.mute(muted, FindingCode::LinkNotRigid);
  const ShortestPaths paths = findShortestPaths(graph, std::vector<double>(6, 2), 5);
  EXPECT_THAT(paths.order, ElementsAre(5, 4, 6));
  EXPECT_THAT(paths.distance, ElementsAre(2, 0, 2));
  EXPECT_THAT(paths.predecessor, ElementsAre(5, kNoIndex, 5));
  EXPECT_THAT(paths.link, ElementsAre(4, kNoIndex, 5));
}

}  // namespace
}  // namespace hexoderm
