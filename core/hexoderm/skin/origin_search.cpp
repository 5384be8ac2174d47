#include "hexoderm/skin/origin_search.h"

#include "hexoderm/skin/breadth_first.h"
#include "hexoderm/skin/skin_graph_boost.h"

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace hexoderm {
namespace {

constexpr double kInfiniteSum = std::numeric_limits<double>::infinity();

/// Sums of real-valued distances differ by rounding.
bool isSameSum(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

/// Whether the links of a patch have weights that are small whole numbers, as the paper's are: distances are then whole
/// numbers too.
bool hasWholeWeights(const PatchGraph& view, std::span<const double> link_weights) {
  constexpr double kLargest = 64;
  return std::ranges::all_of(view.cells(), [&](std::size_t cell) {
    const auto [begin, end] = out_edges(cell, view);
    return std::all_of(begin, end, [&](const SkinEdge& edge) {
      const double weight = link_weights[edge.link];
      return weight >= 1 && weight <= kLargest && weight == static_cast<int>(weight);
    });
  });
}

struct Weight {
  double weight = 1;
};
using FlatGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Weight, boost::no_property,
                                                     std::uint32_t, std::uint32_t>;

/// A patch as it is searched again and again: vertex k is the cell `order[k]`.
FlatGraph flatGraph(const PatchGraph& view, std::span<const double> link_weights, std::span<const std::size_t> order) {
  const PlaceInPatch place = get(boost::vertex_index, view);
  std::vector<std::uint32_t> vertex_of(order.size());
  for (std::size_t v = 0; v < order.size(); ++v) vertex_of[place[order[v]]] = static_cast<std::uint32_t>(v);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  std::vector<Weight> weights;
  for (std::size_t v = 0; v < order.size(); ++v) {
    for (const SkinEdge& edge : boost::make_iterator_range(out_edges(order[v], view))) {
      ends.emplace_back(static_cast<std::uint32_t>(v), vertex_of[place[target(edge, view)]]);
      weights.push_back({link_weights[edge.link]});
    }
  }
  return {boost::edges_are_sorted, ends.begin(), ends.end(), weights.begin(), static_cast<std::uint32_t>(order.size())};
}

/// Dial's queue of buckets, a Buffer of the library: one bucket holds the vertices whose distances lie within its
/// width, which is that of the shortest link. Vertices leave it in the order of their distances, but for those of one
/// bucket.
class BucketQueue {
 public:
  /// `distance`: per vertex, also as it changes.
  BucketQueue(const FlatGraph& graph, const std::vector<double>& distance) : distance_(distance) {
    constexpr double kMaxBuckets = 4096;  // few enough where links are very unequal
    double least = kInfiniteSum;
    double most = 0;
    for (const auto& edge : boost::make_iterator_range(edges(graph))) {
      least = std::min(least, graph[edge].weight);
      most = std::max(most, graph[edge].weight);
    }
    per_distance_ = most > 0 ? 1 / std::max(least, most / kMaxBuckets) : 1;
    // As many as the longest link reaches over, one that is being emptied, and one for rounding.
    buckets_.resize(std::bit_ceil(static_cast<std::size_t>(most * per_distance_) + 3));
  }

  void push(std::uint32_t vertex) {
    const double distance = distance_[vertex];
    buckets_[static_cast<std::size_t>(distance * per_distance_) & (buckets_.size() - 1)].push_back({vertex, distance});
    ++waiting_;
  }
  [[nodiscard]] std::uint32_t top() const { return buckets_[at_][next_].vertex; }
  void pop() {
    ++next_;
    --waiting_;
  }
  /// Drops what has become nearer since, and waits in another place too.
  [[nodiscard]] bool empty() {
    while (waiting_ > 0) {
      if (next_ == buckets_[at_].size()) {
        leaveBucket();
      } else if (const Waiting& here = buckets_[at_][next_]; here.distance == distance_[here.vertex]) {
        return false;
      } else {
        pop();
      }
    }
    leaveBucket();
    at_ = 0;
    return true;
  }

 private:
  struct Waiting {
    std::uint32_t vertex;
    double distance;
  };

  void leaveBucket() {
    buckets_[at_].clear();
    next_ = 0;
    at_ = (at_ + 1) & (buckets_.size() - 1);
  }

  const std::vector<double>& distance_;
  double per_distance_ = 1;
  std::vector<std::vector<Waiting>> buckets_;
  std::size_t at_ = 0;
  std::size_t next_ = 0;  ///< in the bucket
  std::size_t waiting_ = 0;
};

/// Relaxes edges. A vertex that becomes nearer when it has been seen is looked at again.
struct Relax : boost::bfs_visitor<> {
  std::vector<double>& distance;
  BucketQueue& queue;

  Relax(std::vector<double>& distances, BucketQueue& waiting) : distance(distances), queue(waiting) {}
  template <class Edge>
  void tree_edge(const Edge& edge, const FlatGraph& graph) {
    distance[target(edge, graph)] = distance[source(edge, graph)] + graph[edge].weight;
  }
  template <class Edge>
  void non_tree_edge(const Edge& edge, const FlatGraph& graph) {
    const double there = distance[source(edge, graph)] + graph[edge].weight;
    double& known = distance[target(edge, graph)];
    if (there >= known) return;
    known = there;
    queue.push(target(edge, graph));
  }
};

/// Single-source distances from a few cells, and what they say about the sums of all others.
class OriginSearch {
 public:
  /// `order`: of the patch's cells, and whether each can be the origin; at least one can.
  OriginSearch(const PatchGraph& view, std::span<const double> link_weights, std::vector<std::size_t> order,
               std::vector<bool> eligible)
      : graph_(flatGraph(view, link_weights, order)),
        cells_(std::move(order)),
        count_(cells_.size()),
        eligible_(std::move(eligible)),
        tried_(count_, false),
        distance_(count_),
        queue_(graph_, distance_) {}
  // The queue refers to the distances.
  OriginSearch(const OriginSearch&) = delete;
  OriginSearch& operator=(const OriginSearch&) = delete;

  /// For whole weights. Distances of a few landmarks bound every other cell's sum from below by the triangle
  /// inequality.
  OriginFound runByBounds() {
    constexpr std::size_t kMaxRuns = 500;
    constexpr std::size_t kEasyRuns = 20;
    constexpr std::size_t kMaxLandmarks = 64;
    spreadLandmarks(kBoundingLandmarks);
    bound_.assign(count_, 0);
    // The most central cell by the landmarks: bounds are tight near it, and it is hard to beat.
    if (const std::size_t central = nearestToLandmarks(); central != kNoIndex) evaluate(central);
    if (best_ != kNoIndex) cutAt(best_);
    // On a skin whose cells are all alike (a closed torus), the bounds exclude no cell: there the search ends with the
    // best cell found, after as many runs as an operator still perceives as immediate.
    while (runs_ < std::min(count_, kMaxRuns)) {
      const std::size_t next = mostPromising();
      if (next == kNoIndex) break;
      evaluate(next);
      // Few landmarks make fast cuts and are mostly enough; where they are not, bounds have to become tighter.
      if (runs_ > kEasyRuns && landmarks_.size() < kMaxLandmarks) landmarks_.push_back(distance_);
      cutAt(next);
    }
    return found();
  }

  /// For real weights. The sum of a cell's distances is about that to the landmarks, each counted for the cells that
  /// are nearest to it.
  OriginFound runBySample() {
    const std::size_t most = mostRuns();
    if (count_ <= most) {
      for (std::size_t v = 0; v < count_; ++v) evaluate(v);
      return found();
    }
    spreadLandmarks(most / 2);
    while (runs_ < most) {
      const std::size_t next = nearestToLandmarks();
      if (next == kNoIndex) break;
      evaluate(next);
    }
    return found();
  }

 private:
  static constexpr std::size_t kBoundingLandmarks = 8;

  [[nodiscard]] OriginFound found() const { return {cells_[best_], best_sum_, runs_}; }

  [[nodiscard]] std::size_t mostRuns() const {
    constexpr double kMaxWork = 5e7;
    const auto affordable = static_cast<std::size_t>(std::sqrt(kMaxWork / static_cast<double>(count_)));
    return std::clamp<std::size_t>(affordable, 64, 500);
  }

  /// The exact sum of vertex `v`, whose distances are in distance_ then.
  void evaluate(std::size_t v) {
    // Dijkstra's algorithm. It writes over all distances of the search before: the cells of a patch reach each other.
    colors_.assign(count_, boost::white_color);
    distance_[v] = 0;
    boost::breadth_first_visit(
        graph_, static_cast<std::uint32_t>(v), queue_, Relax(distance_, queue_),
        boost::make_iterator_property_map(colors_.begin(), boost::get(boost::vertex_index, graph_)));
    assert(std::ranges::find(colors_, boost::white_color) == colors_.end());
    ++runs_;
    tried_[v] = true;
    if (!eligible_[v]) return;
    const double sum = std::accumulate(distance_.begin(), distance_.end(), 0.0);
    const bool is_tie = isSameSum(sum, best_sum_);
    if (best_ == kNoIndex || (is_tie ? cells_[v] < cells_[best_] : sum < best_sum_)) {
      best_ = v;
      best_sum_ = sum;
    }
  }

  /// Each far from those before: first the ends of the patch, from which distances tell most, then evenly.
  void spreadLandmarks(std::size_t most) {
    std::vector<double> nearest(count_, kInfiniteSum);
    nearest_landmark_.assign(count_, 0);
    std::size_t next = 0;
    for (std::size_t l = 0; l < std::min(most, count_) && !tried_[next]; ++l) {
      evaluate(next);
      landmarks_.push_back(distance_);
      double farthest = 0;
      for (std::size_t v = 0; v < count_; ++v) {
        if (distance_[v] < nearest[v]) {
          nearest[v] = distance_[v];
          nearest_landmark_[v] = static_cast<std::uint32_t>(l);
        }
        if (nearest[v] > farthest) {
          farthest = nearest[v];
          next = v;
        }
      }
    }
    estimated_sum_.assign(count_, 0);
    std::vector<double> cells_at(landmarks_.size(), 0);
    for (const std::uint32_t l : nearest_landmark_) ++cells_at[l];
    for (std::size_t l = 0; l < landmarks_.size(); ++l) {
      for (std::size_t v = 0; v < count_; ++v) {
        estimated_sum_[v] += cells_at[l] * landmarks_[l][v];
      }
    }
  }

  /// Of the cells not tried yet; kNoIndex if there is none.
  [[nodiscard]] std::size_t nearestToLandmarks() const {
    std::size_t nearest = kNoIndex;
    for (std::size_t v = 0; v < count_; ++v) {
      if (tried_[v] || !eligible_[v]) continue;
      if (nearest == kNoIndex || estimated_sum_[v] < estimated_sum_[nearest]) nearest = v;
    }
    return nearest;
  }

  /// With sigma_u = +-1 and landmark L(u) chosen so that sigma_u (d_L(k) - d_L(u)) is largest, the triangle inequality
  /// gives for every cell v:  sum_u d(v, u) >= sum_u sigma_u (d_L(u)(v) - d_L(u)(u)), which is linear in v's distances
  /// to the landmarks and tight near k. `k`, whose distances are in distance_, is a landmark too.
  void cutAt(std::size_t k) {
    const std::size_t landmarks = landmarks_.size() + 1;
    const auto distancesOf = [&](std::size_t l) {
      return l < landmarks_.size() ? landmarks_[l].data() : distance_.data();
    };
    std::vector<double> slope(landmarks, 0);
    double constant = 0;
    // In blocks that the fastest memory holds.
    std::array<double, kBlock> largest{};
    std::array<std::int64_t, kBlock> chosen{};  // as wide as a distance
    for (std::size_t from = 0; from < count_; from += kBlock) {
      const std::size_t size = std::min(kBlock, count_ - from);
      largest.fill(-1);
      for (std::size_t l = 0; l < landmarks; ++l) {
        const double* distance = distancesOf(l) + from;
        const double at_k = distancesOf(l)[k];
        for (std::size_t u = 0; u < size; ++u) {
          const double difference = std::abs(at_k - distance[u]);
          chosen[u] = difference > largest[u] ? static_cast<std::int64_t>(l) : chosen[u];
          largest[u] = std::max(largest[u], difference);
        }
      }
      for (std::size_t u = 0; u < size; ++u) {
        const auto l = static_cast<std::size_t>(chosen[u]);
        const double distance = distancesOf(l)[from + u];
        const double sign = distancesOf(l)[k] >= distance ? 1 : -1;
        slope[l] += sign;
        constant -= sign * distance;
      }
    }
    std::array<double, kBlock> cut{};
    for (std::size_t from = 0; from < count_; from += kBlock) {
      const std::size_t size = std::min(kBlock, count_ - from);
      cut.fill(constant);
      for (std::size_t l = 0; l < landmarks; ++l) {
        const double* distance = distancesOf(l) + from;
        const double factor = slope[l];
        if (factor == 0) continue;
        for (std::size_t v = 0; v < size; ++v) cut[v] += factor * distance[v];
      }
      for (std::size_t v = 0; v < size; ++v) bound_[from + v] = std::max(bound_[from + v], cut[v]);
    }
  }

  /// The cell with the smallest bound that may still beat the best one; kNoIndex proves the best one optimal.
  [[nodiscard]] std::size_t mostPromising() const {
    std::size_t found = kNoIndex;
    for (std::size_t v = 0; v < count_; ++v) {
      if (tried_[v] || !eligible_[v] || (found != kNoIndex && bound_[v] >= bound_[found])) continue;
      const bool may_win =
          best_ == kNoIndex || (isSameSum(bound_[v], best_sum_) ? cells_[v] < cells_[best_] : bound_[v] < best_sum_);
      if (may_win) found = v;
    }
    return found;
  }

  static constexpr std::size_t kBlock = 1024;

  FlatGraph graph_;
  std::vector<std::size_t> cells_;  ///< per vertex
  std::size_t count_;
  std::vector<bool> eligible_;
  std::vector<bool> tried_;
  std::vector<double> distance_;  ///< from the vertex tried last
  BucketQueue queue_;
  std::vector<boost::default_color_type> colors_;
  std::vector<std::vector<double>> landmarks_;
  std::vector<std::uint32_t> nearest_landmark_;
  std::vector<double> estimated_sum_;
  std::vector<double> bound_;
  std::size_t runs_ = 0;
  std::size_t best_ = kNoIndex;
  double best_sum_ = kInfiniteSum;
};

}  // namespace

OriginFound searchOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                         const std::vector<bool>& eligible) {
  const PatchGraph view{&graph, patch};
  const std::size_t first = view.cells().front();
  if (view.cells().size() == 1) return {first, 0, 0};
  // Neighbours stand near each other, which is most of what makes a search of a large patch fast.
  std::vector<std::size_t> order = BreadthFirst(view).searchFrom(first);
  std::vector<bool> can_be(order.size(), true);
  if (std::ranges::find(eligible, true) != eligible.end()) {
    for (std::size_t v = 0; v < order.size(); ++v) can_be[v] = eligible[graph.cells()[order[v]].place];
  }
  OriginSearch search(view, link_weights, std::move(order), std::move(can_be));
  return hasWholeWeights(view, link_weights) ? search.runByBounds() : search.runBySample();
}

std::size_t findOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                       const std::vector<bool>& eligible) {
  return searchOrigin(graph, link_weights, patch, eligible).origin;
}

}  // namespace hexoderm
