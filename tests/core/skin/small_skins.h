#pragma once

#include "hexoderm/skin/skin_graph.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

namespace hexoderm::test {

/// Cells 1 to `count`, and links between them in this order, each at the next free ports of its cells; four at most for
/// a cell.
inline SkinGraph skin(std::uint32_t count, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links) {
  NeighborList list = listOfCells(count);
  const auto nextPort = [&](std::uint32_t id) { return static_cast<std::uint32_t>(list[id - 1].neighbors.size() + 1); };
  for (const auto& [a, b] : links) joinCells(list, a, nextPort(a), b, nextPort(b));
  return {builtInCellModel("hex-bma150"), list};
}

}  // namespace hexoderm::test
