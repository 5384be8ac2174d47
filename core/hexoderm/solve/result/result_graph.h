#pragma once

// Private: the cells and links of a result as a graph of the Boost Graph Library. A result may be imported, and has no
// SkinGraph.

#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/skin/cell_table.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <cstdint>
#include <optional>
#include <vector>

namespace hexoderm {

/// A vertex.
struct ResultCell {
  const CellPlacement* placement = nullptr;
  const PatchReconstruction* patch = nullptr;
};

/// An edge: a link as it leaves one of its cells.
struct ResultEdge {
  const LinkEstimate* link = nullptr;
  bool forwards = true;  ///< from the link's source to its target
  bool joins = false;    ///< the link is used, and both of its cells are in its patch

  [[nodiscard]] LinkEnd tail() const { return forwards ? link->source : link->target; }
  [[nodiscard]] LinkEnd head() const { return forwards ? link->target : link->source; }
};

/// Vertices are the cells in order of patch and ID. Edges are all links between them, muted ones and those into other
/// patches too, twice each; those of a cell come in the order of the patches' links. The patches must outlive it.
class ResultGraph {
 public:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, ResultCell, ResultEdge, boost::no_property,
                                                   std::uint32_t, std::uint32_t>;
  using Vertex = std::uint32_t;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;

  explicit ResultGraph(const std::vector<PatchReconstruction>& patches);

  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] std::optional<Vertex> find(CellId cell) const;

 private:
  Graph graph_;
  CellTable table_;
};

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
