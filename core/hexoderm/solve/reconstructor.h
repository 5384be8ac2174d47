#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "hexoderm/solve/result/solve_progress.h"

#include <memory>
#include <stop_token>

namespace hexoderm {

/// The paper's Algorithm 1 on one snapshot: graph, patches, edge rotations, classes, origin, placements, every sensor,
/// findings and verdict; with the global solver also the joint estimate (core/hexoderm/solve/README.md).
///
/// `earlier`: a result of the same skin with other poses or options, from which the global solver starts where a patch
/// has the same cells and origin; it changes how long the solver takes, not where it ends. May be null.
///
/// `stop`: checked before every step that may take seconds; once it is requested, the result is null.
///
/// `progress`: is told what is being done, and where the cells are as soon as they are placed; may be null.
///
/// Throws InvalidArgument for options out of range and for a cell model that CellModel::validate() refuses. Everything
/// else that can be wrong with a skin or its poses is a finding; no poses, one pose, an empty skin and a single cell
/// give a result. No value in the result is NaN or infinite.
std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options = {},
                                                  const Reconstruction* earlier = nullptr,
                                                  const std::stop_token& stop = {}, SolveProgress* progress = nullptr);

}  // namespace hexoderm
