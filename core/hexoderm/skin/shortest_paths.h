#pragma once

#include "hexoderm/skin/skin_graph.h"

#include <span>
#include <vector>

namespace hexoderm {

inline constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);  ///< there is none

/// Shortest paths from one cell along links that are not muted. Among equally short paths the one with fewer links is
/// taken, then the one whose predecessor has the smallest ID. It is as large as the root's patch: a skin may fall apart
/// into thousands.
struct ShortestPaths {
  std::size_t root = kNoIndex;           ///< index in SkinGraph::cells(), as all cells below
  std::vector<double> distance;          ///< per cell of the patch, at its GraphCell::place
  std::vector<std::size_t> predecessor;  ///< the same; kNoIndex at the root
  std::vector<std::size_t> link;         ///< the same: the link to the predecessor
  std::vector<std::size_t> order;        ///< cells of the patch so that predecessors come first
};

/// `link_weights`: one positive weight per link of the graph (Dijkstra's algorithm).
ShortestPaths findShortestPaths(const SkinGraph& graph, std::span<const double> link_weights, std::size_t root);

/// The cell of a patch whose shortest paths to all other cells of the patch have the smallest sum (ties: smallest ID).
/// Exact where weights are small whole numbers, as the paper's are, but without all pairs: single-source distances of a
/// few landmarks bound every other cell's sum from below by the triangle inequality, and only cells whose bound does
/// not exceed the best sum are tried. With other weights a large patch gets a cell that is nearly the best.
///
/// `eligible`: per cell of the patch, whether it can be the origin; empty: all can. If no cell of the patch is, all
/// are.
std::size_t findOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                       const std::vector<bool>& eligible = {});

}  // namespace hexoderm
