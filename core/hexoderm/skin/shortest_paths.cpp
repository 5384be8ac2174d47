#include "hexoderm/skin/shortest_paths.h"

#include "hexoderm/skin/skin_graph_boost.h"

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

/// Sums of real-valued weights along different paths differ by rounding.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

/// Cells in the order in which their shortest paths are known.
struct RecordOrder : boost::dijkstra_visitor<> {
  std::vector<std::size_t>* order;

  explicit RecordOrder(std::vector<std::size_t>& cells) : order(&cells) {}
  void examine_vertex(std::size_t cell, const PatchGraph& /*view*/) { order->push_back(cell); }
};

}  // namespace

ShortestPaths findShortestPaths(const SkinGraph& graph, std::span<const double> link_weights, std::size_t root) {
  const PatchGraph view{&graph, graph.cells()[root].patch.value()};
  const PlaceInPatch place = get(boost::vertex_index, view);
  const std::size_t count = view.cells().size();
  ShortestPaths paths;
  paths.root = root;
  paths.distance.resize(count);
  paths.order.reserve(count);
  boost::dijkstra_shortest_paths_no_color_map(
      view, root,
      boost::weight_map(PerLink(link_weights.begin()))
          .distance_map(boost::make_iterator_property_map(paths.distance.begin(), place))
          .visitor(RecordOrder(paths.order)));
  paths.predecessor.assign(count, kNoIndex);
  paths.link.assign(count, kNoIndex);

  // The order of equally far cells, and the choice among equally short paths, follow the documented rule, not the heap:
  // cells by their IDs, as they are numbered; the path with fewer links, then the one with the smallest predecessor.
  const auto distanceOf = [&](std::size_t cell) { return paths.distance[place[cell]]; };
  for (auto first = paths.order.begin(); first != paths.order.end();) {
    const auto last = std::find_if(first, paths.order.end(),
                                   [&](std::size_t cell) { return distanceOf(cell) != distanceOf(*first); });
    std::sort(first, last);
    first = last;
  }
  std::vector<std::size_t> hops(count, 0);
  for (const std::size_t cell : paths.order) {
    if (cell == root) continue;
    const std::size_t here = place[cell];
    for (const SkinEdge& edge : boost::make_iterator_range(out_edges(cell, view))) {
      const std::size_t other = target(edge, view);
      const double through_other = distanceOf(other);
      if (through_other >= paths.distance[here] ||
          !same(through_other + link_weights[edge.link], paths.distance[here])) {
        continue;
      }
      const auto candidate = std::pair(hops[place[other]] + 1, other);
      if (paths.predecessor[here] == kNoIndex || candidate < std::pair(hops[here], paths.predecessor[here])) {
        hops[here] = candidate.first;
        paths.predecessor[here] = other;
        paths.link[here] = edge.link;
      }
    }
  }
  return paths;
}

}  // namespace hexoderm
