#pragma once

#include "hexoderm/solve/global/global_cost.h"

namespace hexoderm {

/// Prints what the factor of the matrix of an estimate takes, beside Eigen's and CHOLMOD's of the same matrix, and what
/// the kernels gain by vector instructions. No two links join the same cells.
void compareFactors(const GlobalProblem& problem, const GlobalState& state);

}  // namespace hexoderm
