#include "hexoderm/skin/cut_elements.h"

#include "hexoderm/skin/skin_graph_boost.h"

#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/filtered_graph.hpp>

#include <iterator>

namespace hexoderm {
namespace {

/// All links but one.
struct Without {
  std::size_t link = 0;
  bool operator()(const SkinEdge& edge) const { return edge.link != link; }
};

/// Of a graph whose vertices and edges are those of `skin`. A link beside another of the same two cells is not seen,
/// but SkinGraph mutes such links.
template <class Graph>
CutElements cutElementsOf(const Graph& graph, const SkinGraph& skin) {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> component(skin.links().size(), kNone);
  std::vector<std::size_t> articulations;
  const std::size_t count =
      boost::biconnected_components(graph, PerLink(component.begin()), std::back_inserter(articulations)).first;
  std::vector<std::size_t> links_of(count, 0);
  for (const std::size_t of_link : component) {
    if (of_link != kNone) ++links_of[of_link];
  }
  CutElements found{std::vector<bool>(component.size()), std::vector<bool>(skin.cells().size())};
  for (std::size_t link = 0; link < component.size(); ++link) {
    found.is_bridge[link] = component[link] != kNone && links_of[component[link]] == 1;
  }
  for (const std::size_t cell : articulations) found.is_articulation[cell] = true;
  return found;
}

}  // namespace

CutElements findCutElements(const SkinGraph& graph) { return cutElementsOf(graph, graph); }

std::vector<std::size_t> linksOfAllLoopsThrough(const SkinGraph& graph, std::size_t link) {
  std::vector<std::size_t> links;
  if (graph.links()[link].muted()) return links;
  const std::vector<bool> with = findCutElements(graph).is_bridge;
  if (with[link]) return links;
  // What becomes a bridge where the link is missing.
  const boost::filtered_graph rest(graph, Without{link});
  const std::vector<bool> without = cutElementsOf(rest, graph).is_bridge;
  for (std::size_t k = 0; k < without.size(); ++k) {
    if (k == link || (without[k] && !with[k])) links.push_back(k);
  }
  return links;
}

}  // namespace hexoderm
