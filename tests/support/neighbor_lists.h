#pragma once

#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"

#include <cstdint>
#include <limits>

namespace hexoderm::test {

/// The built-in model for skins of any size: no ID of a cell is that of its interfaces.
inline CellModel modelOfMany() {
  CellModel model = builtInCellModel("hex-bma150");
  model.interface_id = CellId(std::numeric_limits<std::uint32_t>::max());
  return model;
}

/// Cells 1 to `count` that report no neighbours.
inline NeighborList listOfCells(std::uint32_t count) {
  NeighborList list;
  for (std::uint32_t id = 1; id <= count; ++id) list.push_back({CellId(id), "", {}});
  return list;
}

/// Joins two cells of such a list; both report the link.
inline void joinCells(NeighborList& list, std::uint32_t a, std::uint32_t port_a, std::uint32_t b,
                      std::uint32_t port_b) {
  list[a - 1].neighbors.push_back({PortNumber(port_a), CellId(b), PortNumber(port_b)});
  list[b - 1].neighbors.push_back({PortNumber(port_b), CellId(a), PortNumber(port_a)});
}

/// Rows x columns, links 1-4 along rows and 2-3 across; `closed` joins the rows' ends (a tube).
inline NeighborList listOfSheet(std::uint32_t rows, std::uint32_t columns, bool closed = false) {
  NeighborList list = listOfCells(rows * columns);
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t id = 1 + row * columns + column;
      if (column + 1 < columns) joinCells(list, id, 1, id + 1, 4);
      if (row + 1 < rows) joinCells(list, id, 2, id + columns, 3);
    }
    if (closed) joinCells(list, (row + 1) * columns, 1, 1 + row * columns, 4);
  }
  return list;
}

}  // namespace hexoderm::test
