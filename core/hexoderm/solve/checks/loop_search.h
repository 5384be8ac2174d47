#pragma once

#include "hexoderm/solve/checks/evaluation.h"

#include <vector>

namespace hexoderm {

/// A closed chain of cells, or one that a link between two free ports would close (the paper's closed-loop test).
struct FoundLoop {
  PatchId patch;
  bool closed = false;        ///< `closure` is about a link; else about two free ports
  std::vector<CellId> cells;  ///< from first to second, along the fewest links
  LoopEvaluation closure;
  double limit_m = 0;  ///< largest gap of a closed loop that a skin's links can explain (SolverOptions::max_opening)

  /// Leaves no more open than a skin link may.
  [[nodiscard]] bool closesWithinLimit() const { return closed && closure.length_m <= limit_m; }
};

/// The loops of every patch, those with the largest gaps first, open ones before closed ones; empty: no patch has one.
///
/// Open: pairs of free ports of two cells of a patch, not joined, that face each other, closed by evaluateLoop(). Their
/// link points are no further apart than half a pitch, the longest port vector, as a whole one leaves room for a cell;
/// and each points at the centre of the other's cell to within 45 degrees. In a ring that is half of a link's bend: 36
/// degrees with five cells.
///
/// Closed: for each used link that is not in the shortest-path tree, the shortest loop through it, so that every
/// independent loop of the patch is there at least once. Its gap is the remainder when the loop is walked port vector
/// by port vector with the estimated orientations alone, sum of R_c p_c + s k - R_n p_n over its links with the gap
/// model's s k (jointCost(); s = 0 if none was estimated). Positions play no part in it, so that a solver that has
/// spread the gap over all links can't hide it. If a reconstruction has no tree (an imported one), any spanning tree is
/// taken.
std::vector<FoundLoop> findLoops(const Reconstruction& reconstruction);

}  // namespace hexoderm
