#pragma once

#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/skinwire/messages.h"

#include <map>
#include <optional>
#include <vector>

namespace hexoderm::skinwire {

/// The device's description of itself, as a message. A built-in cell model goes by name, others as JSON.
Hello helloOf(const SkinDescription& skin, double rate_hz = 0, std::uint32_t stream = 0);

/// A topology in as many parts as it takes for each body to be at most `max_body` bytes (kMaxDatagram for UDP). Throws
/// InvalidArgument if a single cell is too large for that.
std::vector<Topology> topologyParts(const NeighborList& cells, std::uint32_t id, std::size_t max_body = kMaxBody);

/// Puts the parts of a topology together, in whatever order and however often they come.
class TopologyAssembler {
 public:
  /// The whole topology with the part that completes it, else nullopt. A part of another topology (id or number of
  /// parts) drops what was gathered of the one before, and so does one that would make it larger than kMaxCells.
  std::optional<NeighborList> add(Topology part);
  void clear();  ///< forgets what it was told

 private:
  std::uint32_t id_ = 0;
  std::uint32_t part_count_ = 0;
  std::size_t cell_count_ = 0;
  std::map<std::uint32_t, NeighborList> parts_;
};

/// The cell model that a Hello names or holds. Throws FormatError or InvalidArgument; never opens a file.
CellModel cellModelOf(const Hello& hello);

}  // namespace hexoderm::skinwire
