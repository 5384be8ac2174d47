#pragma once

#include "hexoderm/reconstruction/reconstruction.h"

#include <memory>

namespace hexoderm {

/// Algorithm 1 of the paper, steps 2 to 9 and 13 of SPEC section 2, on one snapshot: graph, patches, edge rotations,
/// classes, origin, placements, every sensor, findings and verdict.
///
/// Throws InvalidArgument for options out of range. Everything that can be wrong with a skin or its poses is a finding;
/// no poses, one pose, an empty skin and a single cell give a result. No value in the result is NaN or infinite.
std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options = {});

}  // namespace hexoderm
