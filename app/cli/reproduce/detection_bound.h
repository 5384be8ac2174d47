#pragma once

#include "app/cli/reproduce/trials.h"

namespace hexoderm::cli {

/// The share of sessions in which the best test there is would find a fault of the given kind at a cell, in percent: a
/// likelihood ratio that knows which fault at which cell, how large and about which axis, all other cells' attitudes and
/// the directions of gravity, and has one false alarm in 500 sessions (0.2 %). It does not know the errors of the
/// sensor, which are normal with the model's deviations, the angles of the cell's links beyond what the surface makes
/// them, with the elastomer's deviations, and the noise of a mean with a hand's tremor (3 mg). Of swapped cells it knows
/// the attitudes up to the mould's jitter: no test knows more.
///
/// All of that is linear and normal: with d the change of the readings by the fault and V the covariance of the healthy
/// ones, the test is normal with mean sqrt(d^T V^-1 d) = e, and finds with the probability Phi(e - 2.878).
double bestDetection(const SimulatedSkin& skin, const CellFault& fault, std::size_t poses);

}  // namespace hexoderm::cli
