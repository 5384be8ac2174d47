#pragma once

#include "hexoderm/solve/global/joint_system.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// Sensors and cells are eliminated first: a sparse matrix with 6 x 6 blocks for the cells, and a dense one of all
/// poses' unknowns and the gap share. For skins of any size in few poses.
std::unique_ptr<JointSystem> makeCellsFirst();

/// The covariances of all cells at a given state (JointCovariance::cell()), by the least memory that they take. Throws
/// Error if its information matrix is not positive definite, which priors prevent.
std::vector<Matrix6d> cellCovariancesAt(const JointProblem& problem, const JointState& state);

/// About how many multiplications a step takes.
double workOfCellsFirst(const JointProblem& problem);

}  // namespace hexoderm
