#include "hexoderm/skin/cut_elements.h"

#include "tests/core/skin/small_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// The definition, link by link and cell by cell.
CutElements byTakingOut(const SkinGraph& graph) {
  CutElements cuts;
  for (std::size_t link = 0; link < graph.links().size(); ++link) {
    SkinGraph without = graph;
    without.mute(std::vector{link}, FindingCode::LinkNotRigid);
    cuts.is_bridge.push_back(without.patches().size() > graph.patches().size());
  }
  for (std::size_t cell = 0; cell < graph.cells().size(); ++cell) {
    SkinGraph without = graph;
    const auto at = graph.linksAt(cell);
    without.mute(std::vector(at.begin(), at.end()), FindingCode::LinkNotRigid);
    // The cell itself is one more patch then.
    cuts.is_articulation.push_back(without.patches().size() > graph.patches().size() + 1);
  }
  return cuts;
}

TEST(CutElements, AreTheLinksAndCellsWithoutWhichAPatchFallsApart) {
  std::mt19937 random(1);
  std::ptrdiff_t bridges = 0;
  std::ptrdiff_t links_in_loops = 0;
  std::ptrdiff_t articulations = 0;
  for (int skins = 0; skins < 50; ++skins) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
    std::vector<int> free_ports(31, 4);
    std::uniform_int_distribution<std::uint32_t> draw(1, 30);
    for (int k = 0; k < 45; ++k) {
      const std::uint32_t a = draw(random);
      const std::uint32_t b = draw(random);
      const std::pair<std::uint32_t, std::uint32_t> link = std::minmax(a, b);
      const bool is_joined = std::ranges::count(links, link) > 0;
      if (a == b || is_joined || free_ports[a] == 0 || free_ports[b] == 0) continue;
      links.push_back(link);
      --free_ports[a];
      --free_ports[b];
    }
    const SkinGraph graph = test::skin(30, links);
    ASSERT_TRUE(graph.findings().empty());
    const CutElements expected = byTakingOut(graph);
    const CutElements found = findCutElements(graph);
    EXPECT_EQ(found.is_bridge, expected.is_bridge);
    EXPECT_EQ(found.is_articulation, expected.is_articulation);
    bridges += std::ranges::count(expected.is_bridge, true);
    links_in_loops += std::ranges::count(expected.is_bridge, false);
    articulations += std::ranges::count(expected.is_articulation, true);
  }
  // Each kind was there to be found.
  EXPECT_GT(bridges, 50);
  EXPECT_GT(links_in_loops, 50);
  EXPECT_GT(articulations, 50);
}

TEST(LinksOfAllLoops, AreAllLinksOfARing) {
  const SkinGraph graph = test::skin(5, {{1, 2}, {2, 3}, {3, 4}, {1, 4}, {4, 5}});
  const std::vector<std::size_t> ring = linksOfAllLoopsThrough(graph, 0);
  EXPECT_THAT(ring, ElementsAre(0, 1, 2, 3));
}

TEST(LinksOfAllLoops, AreTheLinkAloneWhereItsLoopsShareNoOther) {
  // Two squares side by side; 2-5 is the side that they share.
  const SkinGraph graph = test::skin(6, {{1, 2}, {2, 3}, {1, 4}, {2, 5}, {3, 6}, {4, 5}, {5, 6}});
  const auto shared = graph.indexOf(LinkEnd{CellId(2), PortNumber(3)}, LinkEnd{CellId(5), PortNumber(1)});
  ASSERT_TRUE(shared);
  EXPECT_THAT(linksOfAllLoopsThrough(graph, *shared), ElementsAre(*shared));
  // A corner's two links share all of their loops with the third side of their square.
  const std::vector<std::size_t> of_corner = linksOfAllLoopsThrough(graph, 0);
  EXPECT_EQ(of_corner.size(), 3);
}

TEST(LinksOfAllLoops, AreNoneOfABridgeAndOfAMutedLink) {
  SkinGraph graph = test::skin(4, {{1, 2}, {2, 3}, {1, 3}, {3, 4}});
  EXPECT_THAT(linksOfAllLoopsThrough(graph, 3), IsEmpty());
  graph.mute(std::vector<std::size_t>{0}, FindingCode::LinkNotRigid);
  EXPECT_THAT(linksOfAllLoopsThrough(graph, 0), IsEmpty());
  EXPECT_THAT(linksOfAllLoopsThrough(graph, 1), IsEmpty());
}

}  // namespace
}  // namespace hexoderm
