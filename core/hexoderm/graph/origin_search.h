#pragma once

#include "hexoderm/graph/shortest_paths.h"

namespace hexoderm {

/// What findOrigin() found, and what it took.
struct OriginFound {
  std::size_t origin = kNoIndex;
  double sum = 0;        ///< of its shortest paths to all cells of the patch
  std::size_t runs = 0;  ///< single-source searches
};

/// With real weights a patch of more than 1,000 cells or so gets no more runs than its size allows, but these at least.
inline constexpr std::size_t kFewestRunsOfOriginSearch = 64;

/// findOrigin(). Its answer is exact for weights that are whole numbers, unless cells are so alike that 500 runs do not
/// tell them apart; and for real ones in small patches. In large ones it is the best cell found by then.
OriginFound searchOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                         const std::vector<bool>& eligible = {});

}  // namespace hexoderm
