// Patches, distances and the origin against those of a copy of the graph in an adjacency_list.

#include "hexoderm/skin/origin_search.h"
#include "hexoderm/skin/shortest_paths.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <numeric>

namespace hexoderm {
namespace {

using Weight = boost::property<boost::edge_weight_t, double>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Weight>;

/// Rows x columns with three links a cell, some missing and some muted, so that it falls into patches; and the weights.
struct Skin {
  SkinGraph graph;
  std::vector<double> weights;
};

Skin randomSkin(std::uint32_t rows, std::uint32_t columns, std::mt19937& random, const auto& drawWeight,
                double missing = 0.1) {
  NeighborList list;
  // IDs far apart and in no order, so that they are no indices.
  std::vector<std::uint32_t> ids(rows * columns);
  for (std::uint32_t k = 0; k < ids.size(); ++k) ids[k] = 17 + 1009 * k;
  std::shuffle(ids.begin(), ids.end(), random);
  for (const std::uint32_t id : ids) list.push_back({CellId(id), "", {}});
  std::uniform_real_distribution<double> uniform;
  const auto join = [&](std::uint32_t a, std::uint32_t port_a, std::uint32_t b, std::uint32_t port_b) {
    if (uniform(random) < missing) return;
    list[a].neighbors.push_back({PortNumber(port_a), CellId(ids[b]), PortNumber(port_b)});
    list[b].neighbors.push_back({PortNumber(port_b), CellId(ids[a]), PortNumber(port_a)});
  };
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t k = row * columns + column;
      if (column + 1 < columns) join(k, 1, k + 1, 4);
      if (row + 1 < rows) join(k, 2, k + columns, 3);
    }
  }
  Skin skin{SkinGraph(test::modelOfMany(), list), {}};
  EXPECT_TRUE(skin.graph.findings().empty());
  std::vector<std::size_t> muted;
  for (std::size_t k = 0; k < skin.graph.links().size(); ++k) {
    skin.weights.push_back(drawWeight());
    if (uniform(random) < missing / 2) muted.push_back(k);
  }
  skin.graph.mute(muted, FindingCode::LinkNotRigid);
  return skin;
}

Graph boostGraph(const Skin& skin) {
  Graph graph(skin.graph.cells().size());
  for (std::size_t k = 0; k < skin.graph.links().size(); ++k) {
    const GraphLink& link = skin.graph.links()[k];
    if (!link.muted()) boost::add_edge(link.source, link.target, Weight(skin.weights[k]), graph);
  }
  return graph;
}

std::vector<double> boostDistances(const Graph& graph, std::size_t root) {
  std::vector<double> distance(boost::num_vertices(graph));
  boost::dijkstra_shortest_paths_no_color_map(
      graph, root,
      boost::distance_map(boost::make_iterator_property_map(distance.begin(), boost::get(boost::vertex_index, graph))));
  return distance;
}

std::vector<double> sumsByBoost(const Skin& skin, std::size_t patch) {
  const Graph graph = boostGraph(skin);
  std::vector<double> sums;
  for (const std::size_t cell : skin.graph.patches()[patch]) {
    const std::vector<double> distance = boostDistances(graph, cell);
    double sum = 0;
    for (const std::size_t other : skin.graph.patches()[patch]) sum += distance[other];
    sums.push_back(sum);
  }
  return sums;
}

std::size_t largestOf(const SkinGraph& graph) {
  const auto size = [](const std::vector<std::size_t>& patch) { return patch.size(); };
  return static_cast<std::size_t>(std::ranges::max_element(graph.patches(), {}, size) - graph.patches().begin());
}

TEST(BoostAgreement, PatchesAreTheConnectedComponents) {
  std::mt19937 random(1);
  const Skin skin = randomSkin(
      20, 21, random, [] { return 1.0; }, 0.5);
  std::vector<std::size_t> component(skin.graph.cells().size());
  const auto count = static_cast<std::size_t>(boost::connected_components(boostGraph(skin), component.data()));
  EXPECT_GT(count, 20U);
  ASSERT_EQ(skin.graph.patches().size(), count);
  for (std::size_t cell = 0; cell < component.size(); ++cell) {
    const GraphCell& graph_cell = skin.graph.cells()[cell];
    EXPECT_EQ(graph_cell.patch.value(), component[cell]);
    EXPECT_EQ(skin.graph.patches()[component[cell]][graph_cell.place], cell);
  }
}

TEST(BoostAgreement, DistancesAreTheSameToTheLastBit) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> whole(1, 3);
  std::uniform_real_distribution<double> real(0.1, 5);
  std::uniform_real_distribution<double> exponent(-6, 6);
  const std::vector<std::function<double()>> draws = {
      [] { return 1.0; }, [&] { return whole(random); }, [&] { return 64.0 * whole(random) / 3; },
      [&] { return real(random); }, [&] { return std::pow(10, exponent(random)); }};
  for (const auto& draw : draws) {
    const Skin skin = randomSkin(15, 16, random, draw);
    const Graph graph = boostGraph(skin);
    for (const std::size_t root : {0U, 57U, 133U, 239U}) {
      const ShortestPaths paths = findShortestPaths(skin.graph, skin.weights, root);
      const std::vector<double> expected = boostDistances(graph, root);
      const std::vector<std::size_t>& cells = skin.graph.patches()[skin.graph.cells()[root].patch.value()];
      ASSERT_EQ(paths.distance.size(), cells.size());
      for (std::size_t k = 0; k < cells.size(); ++k) {
        EXPECT_EQ(paths.distance[k], expected[cells[k]]);
        if (cells[k] == root) continue;
        const double before = expected[paths.predecessor[k]];
        EXPECT_NEAR(before + skin.weights[paths.link[k]], expected[cells[k]], 1e-9 * std::max(1.0, expected[cells[k]]));
        EXPECT_LT(before, expected[cells[k]]);
      }
      EXPECT_TRUE(std::ranges::is_sorted(paths.order, {}, [&](std::size_t cell) {
        return std::pair(paths.distance[skin.graph.cells()[cell].place], cell);
      }));
    }
  }
}

// Trees, sheets and what is between them. Real weights on the whole sheet alone: the two ends of a link that halves a
// patch are alike but for rounding.
TEST(BoostAgreement, TheOriginOfASmallPatchIsThatOfAllPairsWhateverTheWeights) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> whole(1, 3);
  std::uniform_real_distribution<double> real(0.5, 4);
  const std::function<double()> ones = [] { return 1; };
  const std::function<double()> wholes = [&] { return whole(random); };
  const std::function<double()> reals = [&] { return real(random); };
  for (const auto& [missing, draw] :
       {std::pair(0.0, ones), std::pair(0.0, wholes), std::pair(0.0, reals), std::pair(0.1, ones),
        std::pair(0.1, wholes), std::pair(0.5, ones), std::pair(0.5, wholes)}) {
    const Skin skin = randomSkin(14, 15, random, draw, missing);
    for (std::size_t patch = 0; patch < skin.graph.patches().size(); ++patch) {
      const std::vector<double> sums = sumsByBoost(skin, patch);
      const auto best = static_cast<std::size_t>(std::ranges::min_element(sums) - sums.begin());
      EXPECT_EQ(findOrigin(skin.graph, skin.weights, patch), skin.graph.patches()[patch][best]);
    }
  }
}

TEST(BoostAgreement, TheOriginOfALargePatchIsThatOfAllPairs) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> whole(1, 3);
  for (const bool alike : {true, false}) {
    const Skin skin = randomSkin(35, 36, random, [&] { return alike ? 1.0 : whole(random); });
    const std::size_t patch = largestOf(skin.graph);
    const std::vector<std::size_t>& cells = skin.graph.patches()[patch];
    ASSERT_GT(cells.size(), 1000U);
    const std::vector<double> sums = sumsByBoost(skin, patch);
    // All can be it, or every third.
    for (const std::size_t step : {1U, 3U}) {
      std::vector<bool> eligible(cells.size(), false);
      std::size_t best = 0;
      for (std::size_t k = 0; k < cells.size(); k += step) {
        eligible[k] = true;
        if (sums[k] < sums[best]) best = k;
      }
      const OriginFound found = searchOrigin(skin.graph, skin.weights, patch, eligible);
      EXPECT_EQ(found.origin, cells[best]);
      EXPECT_EQ(found.sum, sums[best]);
      EXPECT_LT(found.runs, cells.size() / 5);
    }
  }
}

TEST(BoostAgreement, WithRealWeightsTheOriginIsWithinATwoHundredthOfTheBest) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> real(0.5, 4);
  for (int skins = 0; skins < 3; ++skins) {
    const Skin skin = randomSkin(35, 36, random, [&] { return real(random); });
    const std::size_t patch = largestOf(skin.graph);
    const std::vector<double> sums = sumsByBoost(skin, patch);
    const OriginFound found = searchOrigin(skin.graph, skin.weights, patch);
    EXPECT_LE(found.sum, 1.005 * std::ranges::min(sums));
  }
}

}  // namespace
}  // namespace hexoderm
