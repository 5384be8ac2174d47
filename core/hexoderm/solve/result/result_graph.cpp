#include "hexoderm/solve/result/result_graph.h"

#include <utility>

namespace hexoderm {

ResultGraph::ResultGraph(const std::vector<PatchReconstruction>& patches) {
  std::vector<ResultCell> cells;
  std::vector<CellId> ids;
  std::vector<Vertex> first;  // of each patch, and the end
  std::size_t link_count = 0;
  for (const PatchReconstruction& patch : patches) {
    first.push_back(static_cast<Vertex>(cells.size()));
    for (const CellPlacement& cell : patch.cells) {
      cells.push_back({&cell, &patch});
      ids.push_back(cell.cell);
    }
    link_count += patch.links.size();
  }
  first.push_back(static_cast<Vertex>(cells.size()));
  table_ = CellTable(ids);

  std::vector<std::pair<Vertex, Vertex>> ends;
  std::vector<ResultEdge> edges;
  ends.reserve(2 * link_count);
  edges.reserve(2 * link_count);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto isHere = [&](Vertex cell) { return cell >= first[k] && cell < first[k + 1]; };
    for (const LinkEstimate& link : patches[k].links) {
      const auto source = find(link.source.cell);
      const auto target = find(link.target.cell);
      if (!source || !target) continue;
      const bool joins = link.used && isHere(*source) && isHere(*target);
      ends.emplace_back(*source, *target);
      edges.push_back({&link, true, joins});
      ends.emplace_back(*target, *source);
      edges.push_back({&link, false, joins});
    }
  }
  graph_ = Graph(boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), edges.begin(),
                 static_cast<Vertex>(cells.size()));
  for (Vertex cell = 0; cell < cells.size(); ++cell) graph_[cell] = cells[cell];
}

std::optional<ResultGraph::Vertex> ResultGraph::find(CellId cell) const {
  const std::optional<std::size_t> found = table_.find(cell);
  return found ? std::optional(static_cast<Vertex>(*found)) : std::nullopt;
}

const ResultGraph& CachedGraph::of(const std::vector<PatchReconstruction>& patches) const {
  const std::lock_guard lock(mutex_);
  if (!graph_) graph_ = std::make_shared<const ResultGraph>(patches);
  return *graph_;
}

std::vector<ResultEdge> ChainSearch::between(ResultGraph::Vertex from, ResultGraph::Vertex to,
                                             const LinkEstimate* but) {
  // Searched backwards, so that the links come out in order.
  search_.searchFrom(to, [&](const ResultGraph::Edge& edge) {
    if (!graph_[edge].joins || graph_[edge].link == but) return false;
    came_by_[target(edge, graph_)] = edge;
    if (target(edge, graph_) == from) search_.end();
    return true;
  });
  std::vector<ResultEdge> chain;
  if (search_.isReached(from)) {
    for (ResultGraph::Vertex cell = from; cell != to; cell = source(came_by_[cell], graph_)) {
      const ResultEdge& edge = graph_[came_by_[cell]];
      chain.push_back({edge.link, !edge.forwards, edge.joins});
    }
  }
  search_.forget();
  return chain;
}

double lengthAcross(const CellModel& model, const LinkEstimate& link) {
  return model.port(link.source.port).vector_m.norm() + model.port(link.target.port).vector_m.norm();
}

}  // namespace hexoderm
