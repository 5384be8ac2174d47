#include "hexoderm/skin/skin_graph_boost.h"

#include "hexoderm/skin/breadth_first.h"
#include "tests/core/skin/small_skins.h"
#include "tests/support/testing.h"

#include <boost/graph/graph_concepts.hpp>

namespace hexoderm {
namespace {

template <class Graph>
void assertConcepts() {
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;
  BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Vertex, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<PerLink<std::span<const double>::iterator>, Edge>));
  BOOST_CONCEPT_ASSERT((boost::LvaluePropertyMapConcept<PerLink<std::vector<std::size_t>::iterator>, Edge>));
}

TEST(SkinGraphAsABoostGraph, ModelsTheConceptsOfTheLibrary) {
  assertConcepts<SkinGraph>();
  assertConcepts<PatchGraph>();
  BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<SkinGraph>));
}

TEST(SkinGraphAsABoostGraph, LeavesMutedLinksOut) {
  SkinGraph graph = test::skin(4, {{1, 2}, {2, 3}, {3, 4}, {2, 4}});
  graph.mute(std::vector<std::size_t>{1}, FindingCode::LinkNotRigid);
  EXPECT_EQ(num_vertices(graph), 4);
  EXPECT_EQ(num_edges(graph), 3);
  EXPECT_EQ(out_degree(1, graph), 2);
  std::vector<std::size_t> targets;
  for (const SkinEdge& edge : boost::make_iterator_range(out_edges(1, graph))) {
    EXPECT_EQ(source(edge, graph), 1);
    targets.push_back(target(edge, graph));
  }
  EXPECT_THAT(targets, ElementsAre(0, 3));
}

TEST(SkinGraphAsABoostGraph, AnEdgeIsTheSameFromBothEnds) {
  EXPECT_EQ((SkinEdge{3, 1}), (SkinEdge{3, 2}));
  EXPECT_FALSE((SkinEdge{3, 1}) == (SkinEdge{4, 1}));
}

TEST(SkinGraphAsABoostGraph, APatchIsIndexedByThePlacesOfItsCells) {
  const SkinGraph graph = test::skin(5, {{1, 3}, {2, 4}, {4, 5}});
  const PatchGraph second{&graph, 1};
  EXPECT_EQ(num_vertices(second), 3);
  EXPECT_THAT(std::vector<std::size_t>(vertices(second).first, vertices(second).second), ElementsAre(1, 3, 4));
  EXPECT_EQ(get(boost::vertex_index, second, 3), 1);
  EXPECT_EQ(out_degree(3, second), 2);
}

TEST(BreadthFirst, DoesNotGoAlongRefusedEdges) {
  const SkinGraph graph = test::skin(4, {{1, 2}, {2, 3}, {3, 4}, {4, 1}});
  BreadthFirst search(graph);
  const auto notToTheSecond = [&](const SkinEdge& edge) { return target(edge, graph) != 1; };
  EXPECT_THAT(search.searchFrom(0, notToTheSecond), ElementsAre(0, 3, 2));
  EXPECT_FALSE(search.isReached(1));
}

TEST(BreadthFirst, EndsWhereItIsToldTo) {
  const SkinGraph graph = test::skin(4, {{1, 2}, {2, 3}, {3, 4}});
  BreadthFirst search(graph);
  const auto untilTheThird = [&](const SkinEdge& edge) {
    if (target(edge, graph) == 2) search.end();
    return true;
  };
  EXPECT_THAT(search.searchFrom(0, untilTheThird), ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace hexoderm
