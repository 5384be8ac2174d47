#pragma once

// Private to graph/: distances within one patch, which are found again and again.

#include "hexoderm/graph/skin_graph.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace hexoderm {

/// Whether the links of a patch have weights that are small whole numbers, as the paper's are: distances are then whole
/// numbers too.
inline bool hasWholeWeights(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch) {
  constexpr double kLargest = 64;
  for (const std::size_t cell : graph.patches()[patch]) {
    for (const std::size_t k : graph.linksAt(cell)) {
      const double weight = link_weights[k];
      if (!graph.links()[k].muted() && !(weight >= 1 && weight <= kLargest && weight == static_cast<int>(weight))) {
        return false;
      }
    }
  }
  return true;
}

/// The links of a patch that are not muted, both ways, one cell's after the other's. A vertex is a cell by its place in
/// `order`, a permutation of the patch's cells. `Distance` is std::int32_t for whole weights, and double else.
template <class Distance>
class PatchWays {
 public:
  static constexpr Distance kFar = std::numeric_limits<Distance>::max();

  PatchWays(const SkinGraph& graph, std::span<const double> link_weights, std::span<const std::size_t> order) {
    std::vector<std::uint32_t> vertex_of(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
      vertex_of[graph.cells()[order[v]].place] = static_cast<std::uint32_t>(v);
    }
    first_.reserve(order.size() + 1);
    first_.push_back(0);
    for (const std::size_t cell : order) {
      for (const std::size_t k : graph.linksAt(cell)) {
        const GraphLink& link = graph.links()[k];
        if (link.muted()) continue;
        ways_.push_back({vertex_of[graph.cells()[link.other(cell)].place], static_cast<Distance>(link_weights[k])});
        least_ = std::min(least_, ways_.back().weight);
        most_ = std::max(most_, ways_.back().weight);
      }
      first_.push_back(ways_.size());
    }
    makeQueue();
  }

  [[nodiscard]] std::size_t size() const { return first_.size() - 1; }

  /// Distances of all vertices from `root`, by Dijkstra's algorithm with Dial's queue of buckets: one holds the
  /// vertices that are as far within its width. A vertex that becomes nearer while its bucket is emptied is looked at
  /// again, so that buckets may be wider than the shortest link. What a path's length is rounded to does not depend on
  /// that.
  void findDistances(std::size_t root, std::span<Distance> distance) {
    std::ranges::fill(distance, kFar);
    distance[root] = 0;
    const std::size_t mask = buckets_.size() - 1;
    buckets_[0].push_back({static_cast<std::uint32_t>(root), 0});
    std::size_t waiting = 1;
    for (std::size_t at = 0; waiting > 0; at = (at + 1) & mask) {
      std::vector<Waiting>& bucket = buckets_[at];
      for (std::size_t k = 0; k < bucket.size(); ++k) {  // grows on the way
        const Waiting here = bucket[k];
        if (here.distance != distance[here.vertex]) continue;  // has become nearer since
        for (std::size_t way = first_[here.vertex]; way < first_[here.vertex + 1]; ++way) {
          const Distance there = here.distance + ways_[way].weight;
          if (there >= distance[ways_[way].to]) continue;
          distance[ways_[way].to] = there;
          buckets_[bucketOf(there) & mask].push_back({ways_[way].to, there});
          ++waiting;
        }
      }
      waiting -= bucket.size();
      bucket.clear();
    }
  }

 private:
  struct Way {
    std::uint32_t to;
    Distance weight;
  };
  struct Waiting {
    std::uint32_t vertex;
    Distance distance;
  };

  /// As many buckets as the longest link reaches over, and a power of two; few enough where links are very unequal.
  void makeQueue() {
    constexpr double kMostBuckets = 4096;
    double reach = static_cast<double>(most_);
    if constexpr (!std::is_integral_v<Distance>) {
      const double width = ways_.empty() ? 1 : std::max(least_, most_ / kMostBuckets);
      per_distance_ = 1 / width;
      reach *= per_distance_;
    }
    // One that is being emptied, and one for rounding.
    buckets_.resize(std::bit_ceil(static_cast<std::size_t>(reach) + 3));
  }

  [[nodiscard]] std::size_t bucketOf(Distance distance) const {
    if constexpr (std::is_integral_v<Distance>) {
      return static_cast<std::size_t>(distance);
    } else {
      return static_cast<std::size_t>(distance * per_distance_);
    }
  }

  std::vector<std::size_t> first_;  ///< per vertex, and the end
  std::vector<Way> ways_;
  Distance least_ = kFar;
  Distance most_ = 0;
  double per_distance_ = 1;
  std::vector<std::vector<Waiting>> buckets_;
};

}  // namespace hexoderm
