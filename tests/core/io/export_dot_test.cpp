#include "hexoderm/io/export_formats.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/testing.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphviz.hpp>

namespace hexoderm {
namespace {

struct BoostNode {
  std::string name, label, pos, peripheries;
};
struct BoostEdge {
  std::string taillabel, headlabel, label, color, style;
};
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, BoostNode, BoostEdge>;

/// The file as Boost.Graph's reader understands it.
BoostGraph readWithBoost(const std::string& text) {
  BoostGraph graph;
  boost::dynamic_properties properties(boost::ignore_other_properties);
  properties.property("node_id", boost::get(&BoostNode::name, graph));
  properties.property("label", boost::get(&BoostNode::label, graph));
  properties.property("pos", boost::get(&BoostNode::pos, graph));
  properties.property("peripheries", boost::get(&BoostNode::peripheries, graph));
  properties.property("taillabel", boost::get(&BoostEdge::taillabel, graph));
  properties.property("headlabel", boost::get(&BoostEdge::headlabel, graph));
  properties.property("label", boost::get(&BoostEdge::label, graph));
  properties.property("color", boost::get(&BoostEdge::color, graph));
  properties.property("style", boost::get(&BoostEdge::style, graph));
  EXPECT_TRUE(boost::read_graphviz(text, graph, properties, "node_id"));
  return graph;
}

TEST(ExportDot, HoldsCellsAtTheirPlaceInTheLayout) {
  const BoostGraph graph = readWithBoost(dotText(makeTestReconstruction()));
  std::map<std::string, BoostNode> nodes;
  for (const auto vertex : boost::make_iterator_range(boost::vertices(graph)))
    nodes[graph[vertex].name] = graph[vertex];
  ASSERT_EQ(nodes.size(), 4U);
  double x_in = 0;
  double y_in = 0;
  char end = 0;
  ASSERT_EQ(std::sscanf(nodes["12"].pos.c_str(), "%lf,%lf%c", &x_in, &y_in, &end), 3);
  EXPECT_DOUBLE_EQ(x_in * 0.0254, 0.024);
  EXPECT_DOUBLE_EQ(y_in * 0.0254, -0.001);
  EXPECT_EQ(end, '!');
  EXPECT_EQ(nodes["7"].peripheries, "2");  // the origin
  EXPECT_NE(nodes["3"].peripheries, "2");
}

/// By "cell:port-cell:port".
std::map<std::string, BoostEdge> edgesOf(const BoostGraph& graph) {
  std::map<std::string, BoostEdge> edges;
  for (const auto edge : boost::make_iterator_range(boost::edges(graph))) {
    const BoostEdge& properties = graph[edge];
    edges[graph[boost::source(edge, graph)].name + ":" + properties.taillabel + "-" +
          graph[boost::target(edge, graph)].name + ":" + properties.headlabel] = properties;
  }
  EXPECT_EQ(edges.size(), boost::num_edges(graph));
  return edges;
}

TEST(ExportDot, HoldsTwoDirectedEdgesALinkWithPortsAndQuality) {
  auto edges = edgesOf(readWithBoost(dotText(makeTestReconstruction())));
  ASSERT_EQ(edges.size(), 8U);
  for (const char* name : {"3:2-7:3", "7:3-3:2"}) {
    ASSERT_TRUE(edges.contains(name)) << name;
    EXPECT_EQ(edges[name].color, "#17A1CA");
    EXPECT_EQ(edges[name].style, "solid");
  }
  for (const char* name : {"7:2-12:3", "12:3-7:2"}) EXPECT_EQ(edges[name].color, "#3A1FB0:#3A1FB0") << name;
  for (const char* name : {"7:1-12:4", "12:4-7:1", "7:4-20:1", "20:1-7:4"}) {
    EXPECT_EQ(edges[name].color, "#8A939E") << name;
    EXPECT_EQ(edges[name].style, "dashed") << name;
    EXPECT_EQ(edges[name].label, "x") << name;
  }
}

TEST(ExportDot, DrawsTheWeakClassesAsDotsAndDashes) {
  Reconstruction reconstruction = makeTestReconstruction();
  reconstruction.patches[0].links[0].quality = EdgeQuality::Undefined;
  reconstruction.patches[0].links[2].quality = EdgeQuality::Partially;
  auto edges = edgesOf(readWithBoost(dotText(reconstruction)));
  EXPECT_EQ(edges["3:2-7:3"].style, "dotted");
  EXPECT_EQ(edges["3:2-7:3"].color, "#7F0D14");
  EXPECT_EQ(edges["7:2-12:3"].style, "dashed");
  EXPECT_EQ(edges["7:2-12:3"].color, "#E66F15");
}

TEST(ExportDot, GroupsCellsByPatch) {
  const std::string text = dotText(makeTestReconstruction());
  const auto cluster = [&](const std::string& name) {
    const std::size_t begin = text.find("subgraph \"" + name + "\"");
    return text.substr(begin, text.find('}', begin) - begin);
  };
  EXPECT_THAT(cluster("cluster_0"), HasSubstr("; 12;"));
  EXPECT_THAT(cluster("cluster_1"), ::testing::AllOf(HasSubstr(" 20;"), ::testing::Not(HasSubstr(" 12;"))));
}

TEST(ExportDot, EscapesTextsOfUsers) {
  EXPECT_THAT(dotText(makeTestReconstruction()), HasSubstr(R"(label="12\nleft \"arm\", Bernd's <R&amp;D> \\ größer")"));
  Reconstruction reconstruction = makeTestReconstruction();
  reconstruction.patches[0].cells[0].body_part = "ends in \\";
  reconstruction.patches[0].cells[1].body_part = "\"];}\r\n&quot;";
  EXPECT_EQ(boost::num_vertices(readWithBoost(dotText(reconstruction))), 4U);
}

TEST(ExportDot, CellsWithoutALayoutHaveNoPlace) {
  Reconstruction reconstruction = makeTestReconstruction();
  reconstruction.layout = {};
  EXPECT_THAT(dotText(reconstruction), ::testing::Not(HasSubstr("pos=")));
}

TEST(ExportDot, EmptyReconstructionGivesAnEmptyGraph) {
  EXPECT_EQ(boost::num_vertices(readWithBoost(dotText(test::ResultBuilder().build()))), 0U);
}

}  // namespace
}  // namespace hexoderm
