#pragma once

#include "hexoderm/reconstruction/patch/patch_solver.h"

#include <cstddef>
#include <set>
#include <span>
#include <vector>

namespace hexoderm {

/// Takes out of the skin what the attitudes of solved patches show to be no part of it (AttitudeSearch): links are
/// muted, and the readings of cells that are mounted otherwise, or whose readings are each other's, are dropped. What
/// is only suspicious, because there are too few poses, is named and stays. A tree's readings are freed from what a
/// hand that turned the part added to them.
class AttitudeIsolation {
 public:
  explicit AttitudeIsolation(SkinLinks& skin) : skin_(skin) {}

  /// True if anything was changed: then edges and patches have to be estimated again, and looked at once more. Where
  /// only swings were taken out, the next look does not search for faults again: the last one knew of the swings.
  [[nodiscard]] bool isolate(std::span<const PatchSolver> patches, std::vector<Finding>& findings);

 private:
  SkinLinks& skin_;
  bool searched_ = false;                ///< no faults are left to be found
  std::set<std::size_t> contradicting_;  ///< cells of patches that fit no surface, of the graph
};

}  // namespace hexoderm
