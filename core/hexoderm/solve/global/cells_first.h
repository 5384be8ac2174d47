#pragma once

#include "hexoderm/solve/global/global_system.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// Sensors and cells are eliminated first: a sparse matrix with 6 x 6 blocks for the cells, and a dense one of all
/// poses' unknowns and the gap share. For skins of any size in few poses.
std::unique_ptr<GlobalSystem> makeCellsFirst();

/// The covariances of all cells at a given state (GlobalCovariance::cell()), by the least memory that they take. Throws
/// Error if its information matrix is not positive definite, which priors prevent.
std::vector<Matrix6d> cellCovariancesAt(const GlobalProblem& problem, const GlobalState& state);

/// About how many multiplications a step takes.
double workOfCellsFirst(const GlobalProblem& problem);

}  // namespace hexoderm
