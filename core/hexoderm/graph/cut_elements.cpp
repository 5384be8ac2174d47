#include "hexoderm/graph/cut_elements.h"

#include "hexoderm/graph/skin_graph_boost.h"

#include <boost/graph/biconnected_components.hpp>

#include <array>
#include <iterator>

namespace hexoderm {

CutElements findCutElements(const SkinGraph& graph) {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> component(graph.links().size(), kNone);
  std::vector<std::size_t> articulations;
  const std::size_t count =
      boost::biconnected_components(graph, PerLink(component.begin()), std::back_inserter(articulations)).first;
  std::vector<std::size_t> links_of(count, 0);
  for (const std::size_t of_link : component) {
    if (of_link != kNone) ++links_of[of_link];
  }
  CutElements found{std::vector<bool>(component.size()), std::vector<bool>(graph.cells().size())};
  for (std::size_t link = 0; link < component.size(); ++link) {
    found.is_bridge[link] = component[link] != kNone && links_of[component[link]] == 1;
  }
  for (const std::size_t cell : articulations) found.is_articulation[cell] = true;
  return found;
}

std::vector<std::size_t> linksOfAllLoopsThrough(const SkinGraph& graph, std::size_t link) {
  std::vector<std::size_t> links;
  if (graph.links()[link].muted()) return links;
  const std::vector<bool> with = findCutElements(graph).is_bridge;
  if (with[link]) return links;
  // What becomes a bridge where the link is missing.
  SkinGraph rest = graph;
  rest.mute(std::array{link}, FindingCode::LinkDoesNotClose);
  const std::vector<bool> without = findCutElements(rest).is_bridge;
  for (std::size_t k = 0; k < without.size(); ++k) {
    if (k == link || (without[k] && !with[k])) links.push_back(k);
  }
  return links;
}

}  // namespace hexoderm
