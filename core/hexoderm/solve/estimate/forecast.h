#pragma once

#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/metrics/assess.h"

#include <optional>
#include <span>

namespace hexoderm {

/// What the largest of the solved patches would be known to with more readings: the estimate's own information matrix
/// with the readings added that the estimate foretells. Absent without a joint estimate, without poses, and where the
/// result is certain enough to be good.
std::optional<Forecast> forecastOf(const SkinLinks& skin, std::span<const PatchSolver> patches);

}  // namespace hexoderm
