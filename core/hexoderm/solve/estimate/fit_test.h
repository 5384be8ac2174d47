#pragma once

#include "hexoderm/solve/estimate/patch_solver.h"

#include <span>
#include <vector>

namespace hexoderm {

/// The last judge: names the patches whose joint estimate leaves more unexplained than their model can, however many
/// faults were found before. Three sums of squares are compared with a chi-squared, each for the patch as a whole and
/// for every cell with its neighbours up to two links away: the readings' residuals (GlobalRefinement::misfitOf(), each
/// cell free to turn and its sensor's errors granted), the angles of the links in the elastomer's sigmas, and, where
/// links close loops, the distances between their ends in units of the spread that the patch shows, the model's at
/// least. The limit follows from the number of tests and one false alarm in 4,000 sessions; a sum must also be twice as
/// large as is to be expected, of angles five times and of openings six times, for strongly curved skins keep neither.
/// A single link that is twisted as in no skin counts too.
void namePoorFit(const SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings);

}  // namespace hexoderm
