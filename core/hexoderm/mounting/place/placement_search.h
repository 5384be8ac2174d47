#pragma once

// All places that fit, and in which ways a placed patch can still be moved.

#include "hexoderm/mounting/place/placement_fit.h"

#include <vector>

namespace hexoderm {

/// A point of a surface from which a fit begins.
struct SurfaceSample {
  Eigen::Vector3d x;
  Eigen::Vector3d normal;
};
/// How far apart points all over a surface are that are to be `spacing_m` apart: farther where that makes too many.
double spacingOn(const TriangleMesh& mesh, double spacing_m);
/// Points all over a surface, spacingOn() apart. The same for the same mesh.
std::vector<SurfaceSample> samplesOf(const TriangleMesh& mesh, const MeshFeet& feet, double spacing_m);

/// From which misfit on a place doesn't fit.
struct FitLimit {
  double absolute = 0;  ///< chi-squared
  double worse = 0;     ///< than the best
  [[nodiscard]] double above(double best) const;
};
FitLimit limitOf(const FitProblem& problem, double false_alarm);
/// Chi-squared's degrees of freedom, at least 1.
int freedomOf(const FitProblem& problem);

/// The minima that the best one does not make improbable, the best first. Those between which a way leads on which all
/// places fit are one.
std::vector<FitSolution> findPlaces(const FitProblem& problem, const std::vector<SurfaceSample>& samples,
                                    double false_alarm);

/// Whether a way leads from one place to another on which all places fit, so that they are one.
bool isWayBetween(const FitProblem& problem, const FitState& from, const FitState& to, double false_alarm);

/// How far one can go from a solution.
struct UnobservableDirection {
  double reach_m = 0;       ///< of the cells, rms, from where they were
  double near_reach_m = 0;  ///< as far as chi-squared grows by 4: where errors are normal, two deviations
  double turn_rad = 0;
  bool all_the_way = false;
  std::vector<FitState> states;  ///< one after the other, without the first
};
/// Along `direction` (unit, in the unknowns) until it no longer fits; `most_chi_squared` is the limit. The turn is that
/// of one patch.
UnobservableDirection followUnobservableDirection(const FitProblem& problem, const FitState& from,
                                                  const Eigen::VectorXd& direction, double most_chi_squared,
                                                  std::size_t patch);

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
