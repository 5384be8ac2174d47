#pragma once

#include "hexoderm/skin/cell_model.h"
#include "hexoderm/skin/neighbor_list.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hexoderm {

/// The broken part of a port. A link needs both directions: a route never runs over such a port. A message that still
/// gets through in the working direction is reported by the side that hears it, as a real skin would.
enum class PortFaultKind {
  Deaf,  ///< hears nothing
  Mute,  ///< sends nothing
  Cut,   ///< both
};

/// A port that fails while neighbours are explored.
struct PortFault {
  PortFaultKind kind{};
  LinkEnd at;
  friend bool operator==(const PortFault&, const PortFault&) = default;
};

/// The static waits are chosen so that a closed ring of 31 cells takes about the 130 ms that the paper states, most of
/// them waiting; how they really divide, the paper does not say.
struct ExplorationOptions {
  double power_up_s = 0.100;         ///< from power to a cell's first word
  double power_up_spread_s = 0.005;  ///< ... and up to so much more, drawn for each cell
  double hello_every_s = 0.002;      ///< how often a port that is not answered says hello
  unsigned hellos = 4;
  double discovery_wait_s = 0.010;  ///< the interface waits for the cells to find their ports
  double settle_s = 0.005;          ///< without a better route: it is the best
  double neighbor_wait_s = 0.005;   ///< a cell listens for its neighbours' IDs
  double bits_per_s = 12e6;         ///< rate of a port, 10 bits a byte
  double processing_s = 20e-6;      ///< from the end of a message to what is said next
  std::uint64_t seed = 1;
  bool ids_remembered = true;      ///< cells know the ID that they had before
  std::vector<CellId> dead_cells;  ///< say nothing at all
  std::vector<PortFault> port_faults;

  /// Throws InvalidArgument naming the option.
  void validate() const;
};

/// The interface's knowledge at the end.
struct Exploration {
  /// The cells' reports, in the order of their IDs; each lists its connected ports in the order of their numbers. The
  /// interface appears as a neighbour, not as a cell.
  NeighborList cells;
  double duration_s = 0;
  double waiting_s = 0;           ///< static waits, which every exploration contains
  std::size_t messages = 0;       ///< packets from port to port, over all links, also those that nobody hears
  std::size_t longest_route = 0;  ///< links between the farthest cell and the interface
};

/// Explores a skin as its cells do, each of which knows nothing but its own ports: a simulation, event by event, of the
/// messages between joined ports.
///
/// 1. Power-up, with a wait; then each cell says hello at each of its ports, and answers. A port whose hello was
///    answered works in both directions.
/// 2. Routes: the interface offers itself with 0 hops; a cell takes the shortest offer, joins the neighbour that made
///    it and offers one hop more.
/// 3. IDs: from the leaves inwards, every cell sends its own and its branches' roll call; the interface numbers it, and
///    the IDs are dealt out again from branch to branch. A cell that remembers the ID it had before keeps it, unless
///    another cell was first; the others get the smallest that are free.
/// 4. Neighbours: when all have IDs, every cell tells its neighbours' ports ID and port, and reports what it heard;
///    the reports go in hop by hop along the routes.
///
/// `wiring` says which ports are really joined (both ends or one end of each link named), and by the cells' IDs which
/// ones they remember. `interface_at` are the ports to which the computer interface (model.interface_id) is connected,
/// by its own ports 1, 2, ... Cells that can't be reached from there are absent. Ports that are not connected are not
/// reported.
///
/// Throws InvalidArgument if a port is not the model's, does not belong to a cell of the wiring or is joined twice, or
/// options make no sense. Source: Mittendorfer and Cheng, IROS 2012, II-A, which names the steps; the messages are our
/// own.
Exploration exploreNetwork(const NeighborList& wiring, const CellModel& model, const std::vector<LinkEnd>& interface_at,
                           const ExplorationOptions& options = {});

/// Where an interface reaches all cells: of each patch, which is cells that are joined to each other, the first port
/// (smallest cell, then smallest port) that is not connected. Throws InvalidArgument if a patch has none, and if there
/// is no patch.
std::vector<LinkEnd> firstFreePorts(const NeighborList& wiring, const CellModel& model);

}  // namespace hexoderm
