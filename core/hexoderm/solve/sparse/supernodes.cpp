#include "hexoderm/solve/sparse/supernodes.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace hexoderm {
namespace {

using Indices = std::vector<std::size_t>;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

Indices inverseOf(const Indices& order) {
  Indices place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  return place;
}

/// Per place in the elimination order: the places before it that it is coupled with.
std::vector<Indices> earlierNeighbours(const Indices& place, const std::vector<BlockCouple>& couples) {
  std::vector<Indices> earlier(place.size());
  for (const BlockCouple& couple : couples) {
    const auto [low, high] = std::minmax(place[couple.row], place[couple.column]);
    earlier[high].push_back(low);
  }
  return earlier;
}

/// Liu, "The role of elimination trees in sparse factorization", SIAM J. Matrix Anal. Appl. 11, 1990, algorithm 4.2.
Indices eliminationTree(const std::vector<Indices>& earlier) {
  Indices parent(earlier.size(), kNone);
  Indices ancestor(earlier.size(), kNone);
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    for (std::size_t j : earlier[i]) {
      while (j != kNone && j != i) {
        const std::size_t next = std::exchange(ancestor[j], i);
        if (next == kNone) parent[j] = i;
        j = next;
      }
    }
  }
  return parent;
}

/// Calls visit(s, i) for every row i below the diagonal of every column (or supernode) s of the factor: row i is there
/// in whatever is on the ways up the tree from its earlier neighbours to itself. Ascending i.
template <typename Visit>
void forEachRow(const std::vector<Indices>& earlier, const Indices& node_of, const Indices& parent, Visit visit) {
  Indices last(parent.size(), kNone);
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    last[node_of[i]] = i;
    for (const std::size_t j : earlier[i]) {
      for (std::size_t s = node_of[j]; last[s] != i; s = parent[s]) {
        last[s] = i;
        visit(s, i);
      }
    }
  }
}

/// A factor's columns in an elimination order, not joined yet.
struct ColumnPattern {
  Indices order;
  Indices parent;
  Indices front;        // per column: blocks in it, the diagonal included
  double products = 0;  // number of block products of the factorisation
};

ColumnPattern columnPattern(Indices order, const std::vector<BlockCouple>& couples) {
  const std::vector<Indices> earlier = earlierNeighbours(inverseOf(order), couples);
  ColumnPattern columns{std::move(order), eliminationTree(earlier), Indices(earlier.size(), 1), 0};
  Indices itself(earlier.size());
  std::iota(itself.begin(), itself.end(), std::size_t{0});
  forEachRow(earlier, itself, columns.parent, [&](std::size_t column, std::size_t) { ++columns.front[column]; });
  for (const std::size_t front : columns.front) columns.products += static_cast<double>(front * front);
  return columns;
}

/// Per column the last column of its supernode: a column joins its parent where the two differ by the column's own
/// diagonal only. (Joining more, for the price of stored zeros, was measured to gain nothing with blocks of this size.)
Indices joinColumns(const Indices& parent, const Indices& front) {
  Indices joining(parent.size(), kNone);  // one child per column; a second one would not be free
  for (std::size_t v = 0; v < parent.size(); ++v) {
    const std::size_t p = parent[v];
    if (p != kNone && joining[p] == kNone && front[v] == front[p] + 1) joining[p] = v;
  }
  Indices last(parent.size());
  for (std::size_t v = parent.size(); v-- > 0;) {
    last[v] = parent[v] != kNone && joining[parent[v]] == v ? last[parent[v]] : v;
  }
  return last;
}

/// Children before their parents, and a whole subtree before the next.
Indices postorder(const Indices& parent) {
  std::vector<Indices> children(parent.size());
  Indices stack;
  for (std::size_t v = 0; v < parent.size(); ++v) {
    if (parent[v] == v) continue;
    (parent[v] == kNone ? stack : children[parent[v]]).push_back(v);
  }
  // Read backwards, parents come before their children.
  Indices order;
  while (!stack.empty()) {
    const std::size_t v = stack.back();
    stack.pop_back();
    order.push_back(v);
    stack.insert(stack.end(), children[v].begin(), children[v].end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// Index of a row in a front that contains it.
std::size_t placeInFront(const Supernode& node, std::size_t row) {
  if (row < node.first + node.pivots) return row - node.first;
  const auto found = std::lower_bound(node.rows.begin(), node.rows.end(), row);
  return node.pivots + static_cast<std::size_t>(found - node.rows.begin());
}

}  // namespace

SupernodalPattern analysePattern(std::size_t size, const std::vector<BlockCouple>& couples) {
  assert(std::all_of(couples.begin(), couples.end(), [&](const BlockCouple& couple) {
    return couple.row != couple.column && couple.row < size && couple.column < size;
  }));
  ColumnPattern columns = columnPattern(minimumDegreeOrder(size, couples), couples);
  const auto tryOrder = [&](Indices order) {
    ColumnPattern other = columnPattern(std::move(order), couples);
    if (other.products < columns.products) columns = std::move(other);
  };
  tryOrder(minimumDegreeOrder(size, couples, Numbering::Backwards));
  tryOrder(dissectionOrder(size, couples));
  const Indices& parent = columns.parent;

  // Supernodes, named by their last column until they are in their own order.
  const Indices last = joinColumns(parent, columns.front);
  Indices parent_of_last(size);
  for (std::size_t v = 0; v < size; ++v) {
    parent_of_last[v] = last[v] != v ? v : (parent[v] == kNone ? kNone : last[parent[v]]);
  }
  const Indices lasts = postorder(parent_of_last);
  Indices number(size, kNone);
  for (std::size_t s = 0; s < lasts.size(); ++s) number[lasts[s]] = s;

  SupernodalPattern pattern;
  pattern.couples = couples.size();
  pattern.supernodes.resize(lasts.size());
  Indices node_parent(lasts.size(), kNone);
  for (std::size_t v = 0; v < size; ++v) ++pattern.supernodes[number[last[v]]].pivots;
  std::size_t first = 0;
  for (std::size_t s = 0; s < lasts.size(); ++s) {
    Supernode& node = pattern.supernodes[s];
    node.first = first;
    first += node.pivots;
    if (parent_of_last[lasts[s]] == kNone) continue;
    node.parent = node_parent[s] = number[parent_of_last[lasts[s]]];
    pattern.supernodes[node_parent[s]].children.push_back(s);
  }

  Indices next(lasts.size());
  for (std::size_t s = 0; s < lasts.size(); ++s) next[s] = pattern.supernodes[s].first;
  Indices node_of(size);
  pattern.order.resize(size);
  for (std::size_t v = 0; v < size; ++v) {
    const std::size_t s = number[last[v]];
    node_of[next[s]] = s;
    pattern.order[next[s]++] = columns.order[v];
  }

  const Indices place = inverseOf(pattern.order);
  forEachRow(earlierNeighbours(place, couples), node_of, node_parent,
             [&](std::size_t s, std::size_t row) { pattern.supernodes[s].rows.push_back(row); });
  for (std::size_t s = 0; s < lasts.size(); ++s) {
    Supernode& node = pattern.supernodes[s];
    node.in_parent.reserve(node.rows.size());
    for (const std::size_t row : node.rows) {
      node.in_parent.push_back(placeInFront(pattern.supernodes[node_parent[s]], row));
    }
  }
  for (std::size_t k = 0; k < couples.size(); ++k) {
    const bool transposed = place[couples[k].row] < place[couples[k].column];
    const auto [low, high] = std::minmax(place[couples[k].row], place[couples[k].column]);
    Supernode& node = pattern.supernodes[node_of[low]];
    node.entries.push_back({k, placeInFront(node, high), low - node.first, transposed});
  }
  return pattern;
}

}  // namespace hexoderm
