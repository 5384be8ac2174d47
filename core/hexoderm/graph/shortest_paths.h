#pragma once

#include "hexoderm/graph/skin_graph.h"

#include <span>
#include <vector>

namespace hexoderm {

inline constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);

/// Shortest paths from one cell along links that are not muted. Among equally short paths the one with fewer links is
/// taken, then the one whose predecessor has the smallest ID.
struct ShortestPaths {
  std::size_t root = kNoIndex;
  std::vector<double> distance;          ///< per cell; infinite in other patches
  std::vector<std::size_t> predecessor;  ///< per cell; kNoIndex at the root and in other patches
  std::vector<std::size_t> link;         ///< per cell: the link to the predecessor
  std::vector<std::size_t> order;        ///< cells of the root's patch so that predecessors come first
};

/// `link_weights`: one positive weight per link of the graph (Dijkstra, by the Boost Graph Library).
ShortestPaths findShortestPaths(const SkinGraph& graph, std::span<const double> link_weights, std::size_t root);

/// The cell of a patch whose shortest paths to all other cells of the patch have the smallest sum (ties: smallest ID).
/// Exact, but without all pairs: single-source distances of a few landmarks bound every other cell's sum from below by
/// the triangle inequality, and only cells whose bound does not exceed the best sum are tried.
///
/// `eligible`: per cell of the graph, whether it can be the origin; empty: all can. If no cell of the patch is, all are.
std::size_t findOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                       const std::vector<bool>& eligible = {});

}  // namespace hexoderm
