#include "hexoderm/solve/metrics/cell_links.h"

#include "hexoderm/solve/result/result_graph.h"

#include <boost/range/iterator_range.hpp>

#include <algorithm>

namespace hexoderm {
namespace {

/// Adds the links of a cell, in the order of its ports. A link from a cell to itself counts once.
void addLinks(const ResultGraph& graph, ResultGraph::Vertex cell, std::vector<const LinkEstimate*>& links) {
  const std::size_t first = links.size();
  for (const ResultGraph::Edge& edge : boost::make_iterator_range(out_edges(cell, graph.graph()))) {
    const ResultEdge& link = graph.graph()[edge];
    if (link.forwards || target(edge, graph.graph()) != cell) links.push_back(link.link);
  }
  const CellId id = graph.graph()[cell].placement->cell;
  std::ranges::stable_sort(links.begin() + static_cast<std::ptrdiff_t>(first), links.end(), {},
                           [id](const LinkEstimate* link) { return portOf(*link, id); });
}

void raiseFigure(std::optional<double>& worst, const std::optional<double>& value) {
  if (value) worst = std::max(worst.value_or(*value), *value);
}

}  // namespace

CellLinks::CellLinks(const Reconstruction& reconstruction) {
  const ResultGraph& graph = reconstruction.graph();
  for (const ResultGraph::Vertex cell : boost::make_iterator_range(vertices(graph.graph()))) {
    first_.push_back(links_.size());
    addLinks(graph, cell, links_);
  }
  first_.push_back(links_.size());
}

LinksOfCell CellLinks::of(std::size_t index) const {
  if (index + 1 >= first_.size()) return {};
  return LinksOfCell(links_).subspan(first_[index], first_[index + 1] - first_[index]);
}

std::vector<const LinkEstimate*> linksOf(const Reconstruction& reconstruction, CellId cell) {
  std::vector<const LinkEstimate*> links;
  if (const auto found = reconstruction.graph().find(cell)) addLinks(reconstruction.graph(), *found, links);
  return links;
}

CellId neighborAcross(const LinkEstimate& link, CellId cell) {
  return link.source.cell == cell ? link.target.cell : link.source.cell;
}

PortNumber portOf(const LinkEstimate& link, CellId cell) {
  return link.source.cell == cell ? link.source.port : link.target.port;
}

WorstLinkMetrics worstOf(LinksOfCell links) {
  WorstLinkMetrics worst;
  for (const LinkEstimate* link : links) {
    if (!link->used) continue;
    worst.quality = std::min(worst.quality.value_or(link->quality), link->quality);
    raiseFigure(worst.residual_rad, link->knownResidual());
    raiseFigure(worst.sigma_rad, link->knownSigma());
  }
  return worst;
}

}  // namespace hexoderm
