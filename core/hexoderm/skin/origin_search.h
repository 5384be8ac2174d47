#pragma once

#include "hexoderm/skin/shortest_paths.h"

namespace hexoderm {

/// What findOrigin() found, and what it took.
struct OriginFound {
  std::size_t origin = kNoIndex;
  double sum = 0;        ///< of its shortest paths to all cells of the patch
  std::size_t runs = 0;  ///< single-source searches
};

/// findOrigin(). Its answer is exact for weights that are small whole numbers, unless cells are so alike that 500 runs
/// do not tell them apart. With others few cells are quite alike, and no bound tells them apart: half of the runs show
/// how far all cells are from a sample of the patch, and the other half try those that are nearest to it. A patch gets
/// as many runs as its size allows, 500 to 64, so that the work of a large one grows linearly; one with no more cells
/// than that is searched exactly.
OriginFound searchOrigin(const SkinGraph& graph, std::span<const double> link_weights, std::size_t patch,
                         const std::vector<bool>& eligible = {});

}  // namespace hexoderm
