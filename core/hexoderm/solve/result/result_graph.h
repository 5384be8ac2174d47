#pragma once

// Private: the cells and links of a result as a graph of the Boost Graph Library. A result may be imported, and has no
// SkinGraph.

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

}  // namespace hexoderm
