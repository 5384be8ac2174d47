#include "hexoderm/solve/checks/link_chain.h"

namespace hexoderm {

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
