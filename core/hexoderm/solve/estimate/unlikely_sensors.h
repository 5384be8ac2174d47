#pragma once

#include "hexoderm/solve/estimate/patch_solver.h"

#include <span>
#include <vector>

namespace hexoderm {

/// Says so if the errors of a solved skin's accelerometers are together larger than the sigmas of its cell model
/// explain: offsets, scale errors or cross-axis sensitivities.
///
/// Each cell is compared with the forces that the patch has in it, turned freely (ownEvidence()). With P the inverse
/// covariance that the most likely errors x of a sensor have under the model, and p = P x, the sum of p_i^2 over all
/// errors of one kind is tr P on the average, and about a chi-squared times a factor (Satterthwaite). It is a
/// contradiction beyond `max_misfit` deviations and if the sigma is half as large again at least. Cells that were taken
/// for broken, because their readings fit in no position, count too. The worst quarter of the cells, one at least, is
/// left out of the sum, which then counts as the most that a healthy sum has left without them: single sensors are
/// judged by themselves.
void nameUnlikelySensors(const SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings);

}  // namespace hexoderm
