#pragma once

#include "hexoderm/base/se3.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace hexoderm {

/// The covariances of a patch's cells relative to the patch as a whole (CellPlacement::shape_cov_t_r), by the
/// S-transformation S = I - G (G^T W G)^-1 G^T W of their covariance C relative to the origin: block k of G is what a
/// small motion of the whole patch does to cell k, and W takes the centres alone, so that S moves the patch to where
/// the trace of the centres' covariance is least. Where the centres leave a turn open, because they lie on one line or
/// are one, W takes the cells' attitudes too, by arms of a millimetre.
///
/// `T_o_u`: per cell. `times`: C B for a 6 N x 6 matrix B, which is called once: time is a solution with six columns,
/// and memory 6 N x 6. `own`: a cell's block of C (errors as in CellPlacement::cov_t_r); called after `times`.
std::vector<Matrix6d> shapeCovariancesOf(const std::vector<SE3>& T_o_u,
                                         const std::function<Eigen::MatrixXd(Eigen::MatrixXd)>& times,
                                         const std::function<Matrix6d(std::size_t)>& own);

}  // namespace hexoderm
