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
};
struct DotEdge {
  std::string tail;
  std::string head;
  DotAttributes attributes;
};
struct DotCluster {
  std::string name;
  DotAttributes attributes;
  std::vector<DotNode> nodes;
};
struct DotGraph {
  std::string name;
  DotAttributes graph_defaults;
  DotAttributes node_defaults;
  DotAttributes edge_defaults;
  std::vector<DotCluster> clusters;
  std::vector<DotEdge> edges;
};

/// A cluster per patch, a node per cell at its place in the flat layout (real size; `neato` and `fdp` read `pos` in
/// inches), two directed edges per link with the ports at their ends and the quality as colour, style and tooltip.
DotGraph dotGraph(const Reconstruction& reconstruction);

std::string dotText(const DotGraph& graph);

}  // namespace hexoderm
