#include "hexoderm/graph/shortest_paths.h"

#include "hexoderm/graph/origin_search.h"
#include "tests/support/neighbor_lists.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <random>

namespace hexoderm {
namespace {

using test::joinCells;
using test::listOfCells;
using test::listOfSheet;
using ::testing::ElementsAre;

CellModel bigModel() {
  CellModel model = builtInCellModel("hex-bma150");
  model.interface_id = CellId(std::numeric_limits<std::uint32_t>::max());
  return model;
}

/// The definition, cell by cell.
std::size_t originByAllPairs(const SkinGraph& graph, const std::vector<double>& weights, std::size_t patch) {
  std::size_t best = kNoIndex;
  double best_sum = std::numeric_limits<double>::infinity();
  for (const std::size_t cell : graph.patches()[patch]) {
    const ShortestPaths paths = findShortestPaths(graph, weights, cell);
    double sum = 0;
    for (const double distance : paths.distance) sum += distance;
    if (best == kNoIndex || sum < best_sum * (1 - 1e-9)) {
      best = cell;
      best_sum = sum;
    }
  }
  return best;
}

TEST(Origin, AgreesWithAllPairsOnSheetsTubesAndTrees) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> whole(1, 3);
  std::uniform_real_distribution<double> real(0.5, 4);
  const std::vector<std::function<double()>> draws = {[] { return 1; }, [&] { return whole(random); },
                                                      [&] { return real(random); }};
  std::vector<NeighborList> skins = {listOfSheet(1, 1), listOfSheet(1, 9), listOfSheet(5, 7), listOfSheet(14, 15),
                                     listOfSheet(6, 16, true)};
  for (int k = 0; k < 4; ++k) {
    // A random tree; a cell whose parent has no port left starts a patch of its own.
    NeighborList tree = listOfCells(120);
    for (std::uint32_t id = 2; id <= 120; ++id) {
      const std::uint32_t parent = std::uniform_int_distribution<std::uint32_t>(id > 3 ? id / 3 : 1, id - 1)(random);
      const auto port = static_cast<std::uint32_t>(1 + tree[parent - 1].neighbors.size());
      if (port <= 4) joinCells(tree, parent, port, id, 1);
    }
    skins.push_back(tree);
  }
  for (const NeighborList& skin : skins) {
    const SkinGraph graph(bigModel(), skin);
    for (const auto& draw : draws) {
      std::vector<double> weights(graph.links().size());
      std::ranges::generate(weights, draw);
      for (std::size_t patch = 0; patch < graph.patches().size(); ++patch) {
        EXPECT_EQ(findOrigin(graph, weights, patch), originByAllPairs(graph, weights, patch));
      }
    }
  }
}

TEST(Origin, RealWeightsOfALargePatchTakeFewRuns) {
  for (const unsigned seed : {3U, 104U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.5, 4);
    const SkinGraph graph(bigModel(), listOfSheet(100, 101));
    std::vector<double> weights(graph.links().size());
    for (double& weight : weights) weight = uniform(random);
    EXPECT_LE(searchOrigin(graph, weights, 0).runs, 71U) << "seed " << seed;
  }
}

TEST(Origin, TiesGoToTheSmallestId) {
  const SkinGraph ring(bigModel(), listOfSheet(1, 8, true));
  const std::vector<double> ones(ring.links().size(), 1);
  EXPECT_EQ(findOrigin(ring, ones, 0), 0);
  const SkinGraph even_line(bigModel(), listOfSheet(1, 8));
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
  const SkinGraph graph(bigModel(), list);
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
  SkinGraph graph(bigModel(), listOfSheet(1, 7));
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
