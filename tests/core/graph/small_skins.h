#pragma once

#include "hexoderm/graph/skin_graph.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace hexoderm::test {

/// Cells 1 to `count`, and links between them in this order, each at the next free ports of its cells; four at most for
/// a cell.
inline SkinGraph skin(std::uint32_t count, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links) {
  NeighborList list;
  for (std::uint32_t id = 1; id <= count; ++id) list.push_back({CellId(id), "", {}});
  for (const auto& [a, b] : links) {
    std::vector<NeighborReport>& at_a = list[a - 1].neighbors;
    std::vector<NeighborReport>& at_b = list[b - 1].neighbors;
    const PortNumber port_a(static_cast<std::uint32_t>(at_a.size() + 1));
    const PortNumber port_b(static_cast<std::uint32_t>(at_b.size() + 1));
    at_a.push_back({port_a, CellId(b), port_b});
    at_b.push_back({port_b, CellId(a), port_a});
  }
  return {builtInCellModel("hex-bma150"), list};
}

}  // namespace hexoderm::test
