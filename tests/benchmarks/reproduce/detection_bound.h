#pragma once

#include "tests/benchmarks/reproduce/trials.h"

namespace hexoderm::cli {

/// The share of sessions, in percent, in which the best test there is would find a fault: a likelihood ratio with one
/// false alarm in 500 sessions (0.2 %).
struct BestDetection {
  double cell_known = 0;    ///< it knows which cell it is about, how far that is turned, and about which axis
  double cell_unknown = 0;  ///< it has to ask of every cell, and, where the axis is drawn, of every axis
};

/// For a cell that is Yawed or Reglued, or Swapped with its neighbour, in a scripted session.
///
/// The test does not know the errors of the sensors, which are normal with the model's deviations; the angles of the
/// links beyond what the surface makes them, with the elastomer's deviations; the directions of gravity; and the noise
/// of a mean with a hand's tremor (3 mg). All of that is linear and normal: with d the change of all readings by the
/// fault and V the covariance of the healthy ones, the test is normal with mean sqrt(d^T V^-1 d) = e, and finds with
/// the probability Phi(e - z), where z is exceeded with 0.2 %, or 0.2 % over the number of cells; with two angles of a
/// turn to find it is a chi-squared with two degrees of freedom about e^2. Links must make a tree.
BestDetection bestDetection(const SimulatedSkin& skin, const CellFault& fault, std::size_t poses);

/// The same of a fault that is known, but for which of so many places it is at, and shows by so many deviations.
double bestDetection(double deviations, std::size_t places);

}  // namespace hexoderm::cli
