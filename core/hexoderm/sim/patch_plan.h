#pragma once

// Which cells a simulated patch has and how they are joined.

#include "hexoderm/skin/cell_model.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {

/// Cell k gets the ID k + 1.
struct PlannedLink {
  std::size_t source = 0;
  std::size_t target = 0;
  Port source_port;
  Port target_port;
};

inline PlannedLink reversed(const PlannedLink& link) {
  return {link.target, link.source, link.target_port, link.source_port};
}

struct PatchPlan {
  std::size_t cell_count = 0;
  std::vector<PlannedLink> links;
  std::size_t start = 0;     ///< the cell that is laid first, in the middle of the surface
  double start_yaw_rad = 0;  ///< turn of its x axis from "around the body"
  bool has_loops = false;
  bool is_ring = false;
  std::optional<std::pair<LinkEnd, LinkEnd>> loop;  ///< free ports that would close a ring
  std::optional<PlannedLink> closure;  ///< the link that closes a ring; not in `links`, as it places no cell

  /// `links` and `closure`.
  [[nodiscard]] std::vector<PlannedLink> allLinks() const;
};

enum class PatchKind { X17, Ring, ClosedRing, Sheet };
/// The meaning of a patch's name.
struct NamedPatch {
  PatchKind kind = PatchKind::X17;
  std::size_t rows = 0;  ///< rows of a sheet; all cells of a ring
  std::size_t cols = 0;
};
/// x17 | ringN | ringN:closed | sheet:ROWSxCOLS. Throws InvalidArgument for any other text, a ring of less than 3 or
/// more than 100,000 cells, and a sheet of more than 1,000,000.
NamedPatch parsePatch(const std::string& patch);
/// The same for a patch that is live or worn by a robot, of which every reading of every cell is kept for a while.
/// Throws InvalidArgument for more than 100,000 cells too.
NamedPatch parseLivePatch(const std::string& patch);

/// A patch by its name, made of the model's pairs of opposite ports. Throws as parsePatch(), and InvalidArgument for a
/// model with too few opposite ports.
PatchPlan planPatch(const std::string& patch, const CellModel& model);

/// Radius of the cylinder around which that many cells in a line just close to a ring: by a link that bends (tangents
/// of extended port length that meet) or by pitch along the circumference.
double closingRadius(const CellModel& model, std::size_t ring_cells, bool bends);

/// Length of the extended port vector in the cell's plane.
inline double reachOf(const Port& port) { return port.vector_m.head<2>().norm(); }

}  // namespace hexoderm
