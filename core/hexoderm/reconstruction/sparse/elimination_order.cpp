#include "hexoderm/reconstruction/sparse/elimination_order.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace hexoderm {
namespace {

using Indices = std::vector<std::size_t>;

class Dissection {
 public:
  Dissection(std::size_t size, const std::vector<BlockCouple>& couples)
      : neighbours_(size), part_(size, 0), level_(size, 0), order_(size) {
    for (const BlockCouple& couple : couples) {
      neighbours_[couple.row].push_back(couple.column);
      neighbours_[couple.column].push_back(couple.row);
    }
    std::iota(order_.begin(), order_.end(), std::size_t{0});
  }

  Indices run() {
    parts_ = {{0, order_.size()}};
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.end - part.begin > kFewestToDivide) divide(part);
    }
    return std::move(order_);
  }

 private:
  struct Part {  // of order_
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  static constexpr std::size_t kFewestToDivide = 4;

  /// Puts a separator at the end of the part and what it separates before it.
  void divide(const Part& part) {
    ++label_;
    for (std::size_t k = part.begin; k < part.end; ++k) part_[order_[k]] = label_;
    Indices reached = searchFrom(order_[part.begin]);
    std::array<Indices, 3> pieces;  // near, far, separator
    if (reached.size() < part.end - part.begin) {
      pieces[0] = std::move(reached);
      std::copy_if(order_.begin() + part.begin, order_.begin() + part.end, std::back_inserter(pieces[1]),
                   [&](std::size_t v) { return part_[v] != label_; });
    } else {
      // From one end to the other the levels are many and small.
      for (int i = 0; i < 2; ++i) reached = searchFrom(reached.back());
      const std::size_t level = separatingLevel(reached);
      if (level == 0) return;
      for (const std::size_t v : reached) {
        pieces[level_[v] > level ? 1 : (level_[v] == level && touchesLevel(v, level + 1) ? 2 : 0)].push_back(v);
      }
    }
    auto out = order_.begin() + part.begin;
    for (const Indices& piece : pieces) out = std::copy(piece.begin(), piece.end(), out);
    const std::size_t middle = part.begin + pieces[0].size();
    parts_.push_back({part.begin, middle});
    parts_.push_back({middle, middle + pieces[1].size()});
  }

  /// Breadth first through the part of `start`, which gets a new label: what is reached, by levels.
  Indices searchFrom(std::size_t start) {
    const std::size_t from = part_[start];
    part_[start] = ++label_;
    level_[start] = 0;
    Indices reached = {start};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const std::size_t v = reached[k];
      for (const std::size_t n : neighbours_[v]) {
        if (part_[n] != from) continue;
        part_[n] = label_;
        level_[n] = level_[v] + 1;
        reached.push_back(n);
      }
    }
    return reached;
  }

  /// A small level with about as much before as behind it; 0 if there is none between the first and the last.
  [[nodiscard]] std::size_t separatingLevel(const Indices& reached) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const std::size_t deepest = level_[reached.back()];
    std::size_t end = 1;  // of level 0
    for (std::size_t level = 1; level < deepest; ++level) {
      const std::size_t before = end;
      while (level_[reached[end]] == level) ++end;
      const std::size_t behind = reached.size() - end;
      const double imbalance =
          static_cast<double>(std::max(before, behind)) / static_cast<double>(std::min(before, behind));
      const double cost = static_cast<double>(end - before) * imbalance;
      if (cost < least) {
        least = cost;
        best = level;
      }
    }
    return best;
  }

  [[nodiscard]] bool touchesLevel(std::size_t v, std::size_t level) const {
    return std::any_of(neighbours_[v].begin(), neighbours_[v].end(),
                       [&](std::size_t n) { return part_[n] == label_ && level_[n] == level; });
  }

  std::vector<Indices> neighbours_;
  Indices part_;  // label of the last part or search that a row was in
  Indices level_;
  Indices order_;
  std::vector<Part> parts_;
  std::size_t label_ = 0;
};

}  // namespace

Indices minimumDegreeOrder(std::size_t size, const std::vector<BlockCouple>& couples) {
  if (size == 0) return {};
  std::vector<Eigen::Triplet<double, int>> triplets;
  triplets.reserve(size + couples.size());
  // Rows without a diagonal element would be left for the end.
  for (std::size_t k = 0; k < size; ++k) triplets.emplace_back(static_cast<int>(k), static_cast<int>(k), 1.0);
  for (const BlockCouple& couple : couples) {
    triplets.emplace_back(static_cast<int>(couple.row), static_cast<int>(couple.column), 1.0);
  }
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> graph(static_cast<int>(size), static_cast<int>(size));
  graph.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  return {permutation.indices().begin(), permutation.indices().end()};
}

Indices dissectionOrder(std::size_t size, const std::vector<BlockCouple>& couples) {
  return Dissection(size, couples).run();
}

}  // namespace hexoderm
