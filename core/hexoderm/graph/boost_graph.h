#pragma once

// Private to graph/: Boost types stay out of the headers that other folders include.

#include "hexoderm/graph/skin_graph.h"

#include <boost/graph/adjacency_list.hpp>

#include <span>

namespace hexoderm {

/// The paper's representation (II-C.1): bundled properties on vertices and directed edges.
struct VertexProperties {
  CellId id;
  PatchId patch;
};
struct EdgeProperties {
  std::size_t link = 0;  ///< the link this is one direction of
  PortNumber source_port;
  PortNumber target_port;
  double weight = 1;
};
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, VertexProperties, EdgeProperties>;

/// The two directed edges of a link, between the vertices `source` and `target`.
inline void addLink(const GraphLink& link, std::size_t index, double weight, std::size_t source, std::size_t target,
                    BoostGraph& graph) {
  boost::add_edge(source, target, {index, link.source_port, link.target_port, weight}, graph);
  boost::add_edge(target, source, {index, link.target_port, link.source_port, weight}, graph);
}

/// All links that are not muted, each with a weight of 1; vertex k is cell k.
inline BoostGraph makeBoostGraph(std::span<const GraphCell> cells, std::span<const GraphLink> links) {
  BoostGraph graph(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) graph[k] = {cells[k].id, cells[k].patch};
  for (std::size_t k = 0; k < links.size(); ++k) {
    const GraphLink& link = links[k];
    if (!link.muted()) addLink(link, k, 1, link.source, link.target, graph);
  }
  return graph;
}

}  // namespace hexoderm
