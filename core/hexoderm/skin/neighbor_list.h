#pragma once

#include "hexoderm/base/ids.h"

#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// A cell's report about one of its ports after the exploration of its neighbours.
struct NeighborReport {
  PortNumber port;
  CellId cell;                          ///< 0: nothing is connected
  std::optional<PortNumber> cell_port;  ///< absent where the skin does not report the other side's port
  friend bool operator==(const NeighborReport&, const NeighborReport&) = default;
};

/// What a cell found at its ports.
struct CellReport {
  CellId id;
  std::string body_part;  ///< empty if not known
  std::vector<NeighborReport> neighbors;
  friend bool operator==(const CellReport&, const CellReport&) = default;
};

/// The result of network exploration, exactly as reported: it may contradict itself (SkinGraph sorts that out).
using NeighborList = std::vector<CellReport>;

}  // namespace hexoderm
