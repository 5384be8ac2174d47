#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The first of the most severe findings: what to look at before anything else. Null if none is a warning or an error.
const Finding* worstFinding(const Reconstruction& reconstruction);

/// A finding by which the model of the patch of its cells (of all patches, where it names none) is wrong as a whole:
/// what is stated of it by that model means nothing.
bool refutesModel(FindingCode code);

/// Takes back what a result that is not to be trusted states about the uncertainty of its cells: of the patches that a
/// finding refutes, or of all where none does alone.
void withdrawUncertainties(Reconstruction& reconstruction);

/// The uncertainty of the worst of the measured cells; cells placed through their links are named by findings of their
/// own. Of all cells if none was measured.
Uncertainty95 worstUncertainty(const PatchReconstruction& patch);
/// Which of `count` cells that counts: those that were measured, or all if none was. `measured`: of each.
std::vector<std::size_t> countedCells(std::size_t count, const std::function<bool(std::size_t)>& measured);
/// The worst of covariances as in CellPlacement::cov_t_r.
Uncertainty95 worstUncertainty(std::span<const Matrix6d> covariances);

/// The cells that this is the uncertainty of, over all patches: the one whose position is least certain, and where it
/// is another one, the one whose orientation is. Empty where no uncertainty is stated, or all are zero.
std::vector<CellId> worstCells(const Reconstruction& reconstruction);

/// What the largest patch would be known to with readings that it has not got.
struct Forecast {
  Uncertainty95 now;                ///< at the worst measured cell, as for the others
  Uncertainty95 with_pose;          ///< with another pose as advised
  Uncertainty95 with_all_readings;  ///< if every measured cell had a reading in every pose
  std::vector<CellId> lacking;      ///< measured cells without a usable reading in some pose
  std::vector<PoseId> retake;       ///< the poses in which they lack them
};

/// Neither is above the goal.
inline bool meets(const Uncertainty95& known, const Goal& goal) {
  return known.orientation_rad <= goal.orientation_rad && known.position_m <= goal.position_m;
}

/// Assesses a finished reconstruction; it needs everything else of it to be in place. Made of the covariance of the
/// estimate and of findings alone: the number of poses does not matter, what they tell does.
///
/// `forecast`: absent where the solver can't tell; then the advised pose is taken to improve all orientations alike.
Assessment assess(const Reconstruction& reconstruction, const std::optional<Forecast>& forecast);

/// The finding that belongs to an assessment by which too few directions make a result useless.
std::optional<Finding> describeTooFewDirections(const Reconstruction& reconstruction);

}  // namespace hexoderm
