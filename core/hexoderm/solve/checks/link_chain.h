#pragma once

// Shortest chains of links.

#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/solve/result/result_graph.h"

#include <vector>

namespace hexoderm {

/// Chains of the fewest used links between two cells of a patch. A large skin has thousands of loops: what a search
/// costs depends on how far it gets.
class ChainSearch {
 public:
  explicit ChainSearch(const ResultGraph& graph)
      : graph_(graph.graph()), search_(graph_), came_by_(num_vertices(graph_)) {}

  /// Edges that lead from one cell to the other, none of them the link `but`; empty if there is no chain.
  std::vector<ResultEdge> between(ResultGraph::Vertex from, ResultGraph::Vertex to, const LinkEstimate* but = nullptr);

 private:
  const ResultGraph::Graph& graph_;
  BreadthFirst<ResultGraph::Graph> search_;
  std::vector<ResultGraph::Edge> came_by_;  ///< of the cells that the last search reached
};

/// Sum of the lengths of the two port vectors of a link.
double lengthAcross(const CellModel& model, const LinkEstimate& link);

}  // namespace hexoderm
