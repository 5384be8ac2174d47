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

/// Two directed edges per link that is not muted; vertex k is cell k. Weights of 1 where none are given.
inline BoostGraph makeBoostGraph(std::span<const GraphCell> cells, std::span<const GraphLink> links,
                                 std::span<const double> link_weights = {}) {
  BoostGraph graph(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) graph[k] = {cells[k].id, cells[k].patch};
  for (std::size_t k = 0; k < links.size(); ++k) {
    const GraphLink& link = links[k];
    if (link.muted()) continue;
    const double weight = link_weights.empty() ? 1.0 : link_weights[k];
    boost::add_edge(link.source, link.target, {k, link.source_port, link.target_port, weight}, graph);
    boost::add_edge(link.target, link.source, {k, link.target_port, link.source_port, weight}, graph);
  }
  return graph;
}

}  // namespace hexoderm
