#pragma once

#include "hexoderm/solve/global/global_cost.h"
#include "hexoderm/solve/global/sensor_evidence.h"

#include <span>

namespace hexoderm {

/// What the readings of a solved patch say about the errors of its sensors (of cells with readings, in their order),
/// when placements, forces, accelerations and gap share are as uncertain as the rest of the joint estimate leaves them:
///   M = B^T W B - B^T W J (J^T W J + K)^-1 J^T W B,    h = (M + L^-1) x,
/// with the readings' derivatives B to the sensors' errors and J to all other unknowns, weights W, the information K of
/// links and priors about these, the prior L of the sensors' errors that the patch was solved with, and the most
/// probable errors x that came out. Neither depends on L but by the point at which all is linear.
///
/// `sensors`: per cell, as at `state`, the optimum. Dense: time grows with the cube of the cells.
SensorEvidence evidenceOfPatch(const GlobalProblem& problem, const GlobalState& state,
                               std::span<const SensorState> sensors);

}  // namespace hexoderm
