#include "hexoderm/graph/shortest_paths.h"

#include "hexoderm/graph/boost_graph.h"
#include "hexoderm/graph/origin_search.h"

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hexoderm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sums of real-valued weights along different paths differ by rounding.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

std::vector<double> distancesFrom(const BoostGraph& graph, std::size_t root) {
  std::vector<double> distance(boost::num_vertices(graph), kInfinity);
  boost::dijkstra_shortest_paths_no_color_map(
      graph, root,
      boost::weight_map(boost::get(&EdgeProperties::weight, graph))
          .distance_inf(kInfinity)
          .distance_map(boost::make_iterator_property_map(distance.begin(), boost::get(boost::vertex_index, graph))));
  return distance;
}

/// One patch of the skin: vertex k is its k-th cell.
BoostGraph patchGraph(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch) {
  const std::vector<std::size_t>& cells = graph.patches()[patch];
  BoostGraph boost_graph(cells.size());
  for (const std::size_t cell : cells) {
    for (const std::size_t k : graph.linksAt(cell)) {
      const GraphLink& link = graph.links()[k];
      if (!link.muted() && link.source == cell) {
        addLink(link, k, link_weights[k], graph.cells()[cell].place, graph.cells()[link.target].place, boost_graph);
      }
    }
  }
  return boost_graph;
}

/// Single-source distances from a few cells, and what they prove about the sums of all others.
class OriginSearch {
 public:
  /// `eligible`: per cell of the patch; at least one is.
  OriginSearch(BoostGraph graph, std::vector<bool> eligible, bool has_whole_weights)
      : graph_(std::move(graph)),
        has_whole_weights_(has_whole_weights),
        count_(boost::num_vertices(graph_)),
        eligible_(std::move(eligible)),
        bound_(count_, 0),
        exact_(count_, false) {}

  OriginFound run() {
    spreadLandmarks();
    // On a skin whose cells are all alike (a closed torus), the bounds exclude no cell: there the search ends with the
    // best cell found, after as many runs as an operator still perceives as immediate.
    while (landmarks_.size() < std::min(count_, mostRuns())) {
      const std::size_t next = mostPromising();
      if (next == kNoIndex) break;
      evaluate(next);
      cutAt(next);
    }
    return {best_, best_sum_, landmarks_.size()};
  }

 private:
  /// With real weights few cells are quite alike, and the bounds need the more landmarks to tell them apart, the more
  /// cells there are; each run costs as much as all landmarks before it. The work of a large patch grows linearly then.
  [[nodiscard]] std::size_t mostRuns() const {
    constexpr std::size_t kMostRuns = 500;
    constexpr double kMostWork = 5e7;
    if (has_whole_weights_) return kMostRuns;
    const auto affordable = static_cast<std::size_t>(std::sqrt(kMostWork / static_cast<double>(count_)));
    return std::clamp(affordable, kFewestRunsOfOriginSearch, kMostRuns);
  }

  /// Runs Dijkstra from vertex `k`: its exact sum, and one more landmark.
  void evaluate(std::size_t k) {
    std::vector<double> distance = distancesFrom(graph_, k);
    const double sum = std::accumulate(distance.begin(), distance.end(), 0.0);
    landmarks_.push_back(std::move(distance));
    exact_[k] = true;
    if (!eligible_[k]) return;
    const bool tie = same(sum, best_sum_);
    if (best_ == kNoIndex || (tie ? k < best_ : sum < best_sum_)) {
      best_ = k;
      best_sum_ = sum;
    }
  }

  /// Each far from those before: ends of the patch, from which distances tell most.
  void spreadLandmarks() {
    constexpr std::size_t kLandmarks = 8;
    std::vector<double> nearest(count_, kInfinity);
    std::size_t next = 0;
    for (std::size_t i = 0; i < std::min(kLandmarks, count_) && !exact_[next]; ++i) {
      evaluate(next);
      for (std::size_t v = 0; v < count_; ++v) nearest[v] = std::min(nearest[v], landmarks_.back()[v]);
      next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
    }
    if (best_ != kNoIndex) cutAt(best_);
  }

  /// With sigma_u = +-1 and landmark L(u) chosen so that sigma_u (d_L(k) - d_L(u)) is largest, the triangle inequality
  /// gives for every cell v:  sum_u d(v, u) >= sum_u sigma_u (d_L(u)(v) - d_L(u)(u)), which is linear in v's distances
  /// to the landmarks and tight near k.
  void cutAt(std::size_t k) {
    std::vector<double> slope(landmarks_.size(), 0);
    double constant = 0;
    for (std::size_t u = 0; u < count_; ++u) {
      std::size_t chosen = 0;
      double largest = -1;
      for (std::size_t l = 0; l < landmarks_.size(); ++l) {
        const double difference = std::abs(landmarks_[l][k] - landmarks_[l][u]);
        if (difference > largest) {
          largest = difference;
          chosen = l;
        }
      }
      const double sign = landmarks_[chosen][k] >= landmarks_[chosen][u] ? 1 : -1;
      slope[chosen] += sign;
      constant -= sign * landmarks_[chosen][u];
    }
    std::vector<double> cut(count_, constant);
    for (std::size_t l = 0; l < landmarks_.size(); ++l) {
      if (slope[l] == 0) continue;
      for (std::size_t v = 0; v < count_; ++v) cut[v] += slope[l] * landmarks_[l][v];
    }
    for (std::size_t v = 0; v < count_; ++v) bound_[v] = std::max(bound_[v], cut[v]);
  }

  /// The cell with the smallest bound that may still beat the best one; kNoIndex proves the best one optimal.
  [[nodiscard]] std::size_t mostPromising() const {
    std::size_t found = kNoIndex;
    for (std::size_t v = 0; v < count_; ++v) {
      if (exact_[v] || !eligible_[v]) continue;
      const bool may_win = same(bound_[v], best_sum_) ? v < best_ : bound_[v] < best_sum_;
      if (may_win && (found == kNoIndex || bound_[v] < bound_[found])) found = v;
    }
    return found;
  }

  BoostGraph graph_;
  bool has_whole_weights_;
  std::size_t count_;
  std::vector<bool> eligible_;
  std::vector<std::vector<double>> landmarks_;
  std::vector<double> bound_;
  std::vector<bool> exact_;
  std::size_t best_ = kNoIndex;
  double best_sum_ = kInfinity;
};

}  // namespace

ShortestPaths findShortestPaths(const SkinGraph& graph, std::span<const double> link_weights, std::size_t root) {
  const auto place = [&graph](std::size_t cell) { return graph.cells()[cell].place; };
  const std::size_t patch = graph.cells()[root].patch.value();
  ShortestPaths paths;
  paths.root = root;
  paths.distance = distancesFrom(patchGraph(graph, link_weights, patch), place(root));
  paths.order = graph.patches()[patch];
  const std::size_t count = paths.order.size();
  paths.predecessor.assign(count, kNoIndex);
  paths.link.assign(count, kNoIndex);
  std::ranges::sort(paths.order, {}, [&](std::size_t cell) { return std::pair(paths.distance[place(cell)], cell); });

  // Dijkstra gives the distances. Among equally short paths the choice follows the documented rule, not the heap's
  // order: fewer links first, then the smallest predecessor (cells are in order of their IDs).
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

OriginFound searchOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                         const std::vector<bool>& eligible) {
  const std::vector<std::size_t>& cells = graph.patches()[patch];
  if (cells.size() == 1) return {cells.front(), 0, 0};
  const bool any = std::ranges::find(eligible, true) != eligible.end();
  const bool whole = std::ranges::all_of(link_weights, [](double weight) { return weight == std::floor(weight); });
  OriginFound found =
      OriginSearch(patchGraph(graph, link_weights, patch), any ? eligible : std::vector(cells.size(), true), whole)
          .run();
  found.origin = cells[found.origin];
  return found;
}

std::size_t findOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                       const std::vector<bool>& eligible) {
  return searchOrigin(graph, link_weights, patch, eligible).origin;
}

}  // namespace hexoderm
