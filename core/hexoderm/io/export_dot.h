#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// The content of a DOT file: attributes by name, values unescaped.
using DotAttributes = std::map<std::string, std::string>;

struct DotNode {
  std::string name;
  DotAttributes attributes;
  friend bool operator==(const DotNode&, const DotNode&) = default;
};
struct DotEdge {
  std::string tail;
  std::string head;
  DotAttributes attributes;
  friend bool operator==(const DotEdge&, const DotEdge&) = default;
};
struct DotCluster {
  std::string name;
  DotAttributes attributes;
  std::vector<DotNode> nodes;
  friend bool operator==(const DotCluster&, const DotCluster&) = default;
};
struct DotGraph {
  std::string name;
  DotAttributes graph_defaults;
  DotAttributes node_defaults;
  DotAttributes edge_defaults;
  std::vector<DotCluster> clusters;
  std::vector<DotEdge> edges;
  friend bool operator==(const DotGraph&, const DotGraph&) = default;
};

/// A cluster per patch, a node per cell at its place in the flat layout (real size; `neato` and `fdp` read `pos` in
/// inches), two directed edges per link with the ports at their ends and the quality as colour, style and tooltip.
DotGraph dotGraph(const Reconstruction& reconstruction);

std::string dotText(const DotGraph& graph);

/// Reads the part of the DOT language that dotText writes, and refuses everything else. Throws FormatError naming the
/// line. (Boost's read_graphviz drops the clusters; the tests use it as a second opinion.)
DotGraph parseDot(std::string_view bytes, const std::string& file);

/// Throws FormatError unless the bytes say what the graph says.
void verifyDot(std::string_view bytes, const DotGraph& graph, const std::string& file);

}  // namespace hexoderm
