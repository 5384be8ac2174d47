#pragma once

// In which ways a placed patch can still be moved.

#include "hexoderm/mounting/place/place.h"
#include "hexoderm/mounting/place/placement_fit.h"

#include <vector>

namespace hexoderm {

/// What surface, points and distances leave open of a patch's place (directions in which its cells are less certain
/// than `free_m`, rms), as slides, turns and screws: slides along the link's axes where there are several, turns about
/// the patch's normal first. Each is followed as far as places fit, up to `most_chi_squared`; those that the known
/// rotation decides are not.
///
/// Misfits may rise steeply on one side of a place and stay on the other, as at the end of a flat piece. So directions
/// that are certain to a quarter as much are followed, too, and named where they are as open as that. `extent` gets
/// what following says of how certain the place is.
std::vector<FreeDirection> freeDirections(const FitProblem& problem, const FitSolution& solution,
                                          const FitEquations& equations, std::size_t patch, double free_m,
                                          double most_chi_squared, FitExtent& extent);

/// "the link's z axis", "the direction (0.71, 0.00, 0.71) of the link".
Message axisText(const Eigen::Vector3d& axis);

}  // namespace hexoderm
