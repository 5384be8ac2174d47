#pragma once

// All places that fit.

#include "hexoderm/base/triangle_mesh.h"
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

}  // namespace hexoderm
