#pragma once

#include "hexoderm/solve/global/global_cost.h"
#include "hexoderm/solve/global/linearize_kernels.h"

namespace hexoderm {

// The bulk of linearize(), several cells or links at once.

/// Adds what the readings of cells say. Of the border's matrix only the lower triangle is added to.
void linearizeCellsInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
                           NormalEquations& equations);

/// Adds what links say.
void linearizeLinksInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
                           NormalEquations& equations);

}  // namespace hexoderm
