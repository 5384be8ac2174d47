#include "hexoderm/graph/shortest_paths.h"

#include "hexoderm/graph/origin_search.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;

CellModel bigModel() {
  CellModel model = builtInCellModel("hex-bma150");
  model.interface_id = CellId(std::numeric_limits<std::uint32_t>::max());
  return model;
}

void join(NeighborList& list, std::uint32_t a, std::uint32_t port_a, std::uint32_t b, std::uint32_t port_b) {
  list[a - 1].neighbors.push_back({PortNumber(port_a), CellId(b), PortNumber(port_b)});
  list[b - 1].neighbors.push_back({PortNumber(port_b), CellId(a), PortNumber(port_a)});
}

NeighborList cells(std::uint32_t count) {
  NeighborList list;
  for (std::uint32_t id = 1; id <= count; ++id) list.push_back({CellId(id), "", {}});
  return list;
}

/// Rows x columns, links 1-4 along rows and 2-3 across; `closed` joins the rows' ends (a tube).
NeighborList sheet(std::uint32_t rows, std::uint32_t columns, bool closed = false) {
  NeighborList list = cells(rows * columns);
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t id = 1 + row * columns + column;
      if (column + 1 < columns) join(list, id, 1, id + 1, 4);
      if (row + 1 < rows) join(list, id, 2, id + columns, 3);
    }
    if (closed) join(list, (row + 1) * columns, 1, 1 + row * columns, 4);
  }
  return list;
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
  std::vector<NeighborList> skins = {sheet(1, 1), sheet(1, 9), sheet(5, 7), sheet(12, 13), sheet(6, 16, true)};
  for (int k = 0; k < 4; ++k) {
    // A random tree; a cell whose parent has no port left starts a patch of its own.
    NeighborList tree = cells(120);
    for (std::uint32_t id = 2; id <= 120; ++id) {
      const std::uint32_t parent = std::uniform_int_distribution<std::uint32_t>(id > 3 ? id / 3 : 1, id - 1)(random);
      const auto port = static_cast<std::uint32_t>(1 + tree[parent - 1].neighbors.size());
      if (port <= 4) join(tree, parent, port, id, 1);
    }
    skins.push_back(tree);
  }
  for (const NeighborList& skin : skins) {
    const SkinGraph graph(bigModel(), skin);
    for (const bool weighted : {false, true}) {
      std::vector<double> weights(graph.links().size(), 1);
      if (weighted) {
        for (double& weight : weights) weight = std::uniform_int_distribution<int>(1, 3)(random);
      }
      for (std::size_t patch = 0; patch < graph.patches().size(); ++patch) {
        EXPECT_EQ(findOrigin(graph, weights, patch), originByAllPairs(graph, weights, patch));
      }
    }
  }
}

TEST(Origin, RealWeightsAgreeWithAllPairsToo) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.5, 4);
  const SkinGraph graph(bigModel(), sheet(14, 15));
  std::vector<double> weights(graph.links().size());
  for (double& weight : weights) weight = uniform(random);
  EXPECT_EQ(findOrigin(graph, weights, 0), originByAllPairs(graph, weights, 0));
}

TEST(Origin, RealWeightsOfALargePatchTakeFewRunsToNearlyTheBest) {
  for (const unsigned seed : {3U, 104U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.5, 4);
    const SkinGraph graph(bigModel(), sheet(100, 101));
    std::vector<double> weights(graph.links().size());
    for (double& weight : weights) weight = uniform(random);
    const OriginFound found = searchOrigin(graph, weights, 0);
    EXPECT_LE(found.runs, 71U) << "seed " << seed;
    // None of its surroundings is much better.
    double best = found.sum;
    for (std::size_t cell = 0; cell < graph.cells().size(); ++cell) {
      const auto row = static_cast<int>(cell / 101);
      const auto column = static_cast<int>(cell % 101);
      if (row % 3 != 0 || column % 3 != 0 || std::abs(row - 50) > 12 || std::abs(column - 50) > 12) continue;
      const ShortestPaths paths = findShortestPaths(graph, weights, cell);
      best = std::min(best, std::accumulate(paths.distance.begin(), paths.distance.end(), 0.0));
    }
    EXPECT_LE(found.sum, 1.005 * best) << "seed " << seed;
  }
}

TEST(Origin, TiesGoToTheSmallestId) {
  const SkinGraph ring(bigModel(), sheet(1, 8, true));
  const std::vector<double> ones(ring.links().size(), 1);
  EXPECT_EQ(findOrigin(ring, ones, 0), 0);
  const SkinGraph even_line(bigModel(), sheet(1, 8));
  EXPECT_EQ(findOrigin(even_line, std::vector<double>(7, 1), 0), 3);
}

TEST(ShortestPaths, PreferFewerLinksThenTheSmallestPredecessor) {
  //   1 - 2 - 3        1-2-3 costs 1 + 1, 1-4-3 costs 1 + 1: through 2, the smaller ID.
  //   |       |        1-5 costs 2 by one link and 1 + 1 by two (1-2, 2-5): the one link.
  //   4 ------+
  NeighborList list = cells(5);
  join(list, 1, 1, 2, 4);
  join(list, 2, 1, 3, 4);
  join(list, 1, 2, 4, 3);
  join(list, 4, 1, 3, 3);
  join(list, 1, 3, 5, 2);
  join(list, 2, 2, 5, 3);
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

TEST(ShortestPaths, PredecessorsComeFirstInTheOrder) {
  const SkinGraph graph(bigModel(), sheet(6, 6));
  const ShortestPaths paths = findShortestPaths(graph, std::vector<double>(graph.links().size(), 1), 14);
  std::vector<bool> seen(36, false);
  for (const std::size_t cell : paths.order) {
    if (cell != 14) {
      EXPECT_TRUE(seen[paths.predecessor[cell]]);
    }
    seen[cell] = true;
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 36);
}

TEST(ShortestPaths, MutedLinksAreNoWay) {
  SkinGraph graph(bigModel(), sheet(1, 3));
  const std::size_t muted[] = {1};
  graph.mute(muted, FindingCode::LinkNotRigid);
  const ShortestPaths paths = findShortestPaths(graph, std::vector<double>(2, 1), 0);
  EXPECT_THAT(paths.order, ElementsAre(0, 1));
}

TEST(ShortestPaths, AreAsLargeAsTheirPatch) {
  SkinGraph graph(bigModel(), sheet(1, 7));
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
