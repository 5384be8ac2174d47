#include "hexoderm/solve/sparse/elimination_order.h"

#include "hexoderm/skin/breadth_first.h"

#include <amd.h>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

namespace hexoderm {
namespace {

using Indices = std::vector<std::size_t>;
using RowGraph = boost::compressed_sparse_row_graph<boost::directedS>;
using RowEdge = boost::graph_traits<RowGraph>::edge_descriptor;

/// The rows, and both directions of every couple.
RowGraph graphOf(std::size_t size, const std::vector<BlockCouple>& couples) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  ends.reserve(2 * couples.size());
  for (const BlockCouple& couple : couples) {
    ends.emplace_back(couple.row, couple.column);
    ends.emplace_back(couple.column, couple.row);
  }
  return {boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), size};
}

class Dissection {
 public:
  Dissection(std::size_t size, const std::vector<BlockCouple>& couples)
      : graph_(graphOf(size, couples)), search_(graph_), part_(size, 0), level_(size, 0), order_(size) {
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
    Indices reached = search_.searchFrom(start, [&](const RowEdge& edge) {
      const std::size_t next = target(edge, graph_);
      if (part_[next] != from) return false;
      part_[next] = label_;
      level_[next] = level_[source(edge, graph_)] + 1;
      return true;
    });
    search_.forget();
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
    const auto [begin, end] = adjacent_vertices(v, graph_);
    return std::any_of(begin, end, [&](std::size_t n) { return part_[n] == label_ && level_[n] == level; });
  }

  RowGraph graph_;
  BreadthFirst<RowGraph> search_;
  Indices part_;  // label of the last part or search that a row was in
  Indices level_;
  Indices order_;
  std::vector<Part> parts_;
  std::size_t label_ = 0;
};

}  // namespace

Indices minimumDegreeOrder(std::size_t size, const std::vector<BlockCouple>& couples, Numbering numbering) {
  const auto count = static_cast<int>(size);
  const auto renumbered = [&](std::size_t row) {
    return numbering == Numbering::Forwards ? static_cast<int>(row) : count - 1 - static_cast<int>(row);
  };
  std::vector<std::vector<int>> neighbours(size);
  for (const BlockCouple& couple : couples) {
    neighbours[static_cast<std::size_t>(renumbered(couple.row))].push_back(renumbered(couple.column));
    neighbours[static_cast<std::size_t>(renumbered(couple.column))].push_back(renumbered(couple.row));
  }
  std::vector<int> begin = {0};
  std::vector<int> rows;
  for (std::vector<int>& of_column : neighbours) {
    std::ranges::sort(of_column);
    rows.insert(rows.end(), of_column.begin(), of_column.end());
    begin.push_back(static_cast<int>(rows.size()));
  }
  rows.reserve(1);  // a null pointer would be refused
  std::vector<int> permutation(std::max<std::size_t>(1, size));
  if (amd_order(count, begin.data(), rows.data(), permutation.data(), nullptr, nullptr) < AMD_OK) {
    throw std::bad_alloc();  // all that can go wrong with such a graph
  }
  Indices order(size);
  for (std::size_t k = 0; k < size; ++k) order[k] = static_cast<std::size_t>(renumbered(permutation[k]));
  return order;
}

Indices dissectionOrder(std::size_t size, const std::vector<BlockCouple>& couples) {
  return Dissection(size, couples).run();
}

}  // namespace hexoderm
