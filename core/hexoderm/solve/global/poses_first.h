#pragma once

#include "hexoderm/solve/global/global_system.h"

#include <memory>

namespace hexoderm {

/// The forces of the poses are eliminated first, one by one, then the sensors and cells, as dense matrices: for skins
/// of a few hundred cells in any number of poses. Problems must not have accelerations, and must have readings of a
/// cell besides the origin.
///
/// A cell's reading in pose p depends on its own unknowns through t_c, its twelve derivatives by offset and gain; a
/// turn of the cell is a change of its gain. With r = (1, v) and G = d residual / d force, both of one cell and pose,
/// the pose couples t_c with the force by U = -w (r x G), w the reading's precision and x the Kronecker product, and
/// taking out the force leaves the information S = diag_c(sum_p w I x r r^T) - sum_p U_p H_p^-1 U_p^T about all t_c,
/// H_p being the force's own. Since r = T (1, f_p), with T and G of the cell alone, the pair of cells a and b has in
/// the sum (T_a x G_a) [sum_p w_ap w_bp (phi_p phi_p^T x H_p^-1)] (T_b x G_b)^T with phi_p = (1, f_p): the sums of all
/// pairs are products of matrices, 60 numbers a pose.
std::unique_ptr<GlobalSystem> makePosesFirst();

/// About how many multiplications a step takes.
double workOfPosesFirst(const GlobalProblem& problem);

}  // namespace hexoderm
