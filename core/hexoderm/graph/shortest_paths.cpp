#include "hexoderm/graph/shortest_paths.h"

#include "hexoderm/graph/patch_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace hexoderm {
namespace {

/// Sums of real-valued weights along different paths differ by rounding.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

template <class Distance>
std::vector<Distance> distancesFrom(const SkinGraph& graph, std::span<const double> link_weights,
                                    std::span<const std::size_t> cells, std::size_t root) {
  std::vector<Distance> distance(cells.size());
  PatchWays<Distance>(graph, link_weights, cells).findDistances(root, distance);
  return distance;
}

/// The cells of a patch in the order of their distances, equally far ones in the order of their IDs, as they come.
std::vector<std::size_t> nearestFirst(std::span<const std::size_t> cells, std::span<const std::int32_t> distance) {
  std::vector<std::size_t> next(static_cast<std::size_t>(std::ranges::max(distance)) + 2, 0);
  for (const std::int32_t d : distance) ++next[static_cast<std::size_t>(d) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::size_t> order(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) order[next[static_cast<std::size_t>(distance[k])]++] = cells[k];
  return order;
}

std::vector<std::size_t> nearestFirst(std::span<const std::size_t> cells, std::span<const double> distance) {
  std::vector<std::pair<double, std::size_t>> sorted;
  sorted.reserve(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) sorted.emplace_back(distance[k], cells[k]);
  std::ranges::sort(sorted);
  std::vector<std::size_t> order;
  order.reserve(cells.size());
  for (const auto& [far, cell] : sorted) order.push_back(cell);
  return order;
}

}  // namespace

ShortestPaths findShortestPaths(const SkinGraph& graph, std::span<const double> link_weights, std::size_t root) {
  const auto place = [&graph](std::size_t cell) { return graph.cells()[cell].place; };
  const std::size_t patch = graph.cells()[root].patch.value();
  ShortestPaths paths;
  paths.root = root;
  const std::vector<std::size_t>& cells = graph.patches()[patch];
  if (hasWholeWeights(graph, link_weights, patch)) {
    const std::vector<std::int32_t> distance = distancesFrom<std::int32_t>(graph, link_weights, cells, place(root));
    paths.distance.assign(distance.begin(), distance.end());
    paths.order = nearestFirst(cells, distance);
  } else {
    paths.distance = distancesFrom<double>(graph, link_weights, cells, place(root));
    paths.order = nearestFirst(cells, paths.distance);
  }
  const std::size_t count = cells.size();
  paths.predecessor.assign(count, kNoIndex);
  paths.link.assign(count, kNoIndex);

  // Among equally short paths the choice follows the documented rule, not the queue's order: fewer links first, then
  // the smallest predecessor (cells are in order of their IDs).
  std::vector<std::size_t> hops(count, 0);
  for (const std::size_t cell : paths.order) {
    if (cell == root) continue;
    const std::size_t here = place(cell);
    for (const std::size_t link_index : graph.linksAt(cell)) {
      const GraphLink& link = graph.links()[link_index];
      if (link.muted()) continue;
      const std::size_t other = link.other(cell);
      const double through_other = paths.distance[place(other)];
      if (through_other >= paths.distance[here] ||
          !same(through_other + link_weights[link_index], paths.distance[here])) {
        continue;
      }
      const auto candidate = std::pair(hops[place(other)] + 1, other);
      if (paths.predecessor[here] == kNoIndex || candidate < std::pair(hops[here], paths.predecessor[here])) {
        hops[here] = candidate.first;
        paths.predecessor[here] = other;
        paths.link[here] = link_index;
      }
    }
  }
  return paths;
}

}  // namespace hexoderm
