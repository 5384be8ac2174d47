#include "hexoderm/reconstruction/patch/forecast.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

/// Uncertainty at the worst measured cell if the cells had these covariances.
Uncertainty95 worstWith(const PatchReconstruction& patch, const std::vector<Matrix6d>& covariances) {
  PatchReconstruction with = patch;
  for (std::size_t k = 0; k < with.cells.size(); ++k) with.cells[k].cov_t_r = covariances[k];
  return worstUncertainty(with);
}

void findLackingReadings(const SkinLinks& skin, const PatchSolver& patch, Forecast& forecast) {
  std::set<PoseId> retake;
  for (const std::size_t cell : patch.cells()) {
    if (!skin.readings().measured(cell)) continue;
    const std::size_t before = forecast.lacking.size();
    for (const std::size_t pose : patch.joint()->poses()) {
      if (skin.table().at(cell, pose).usable) continue;
      retake.insert(skin.poseId(pose));
      if (forecast.lacking.size() == before) forecast.lacking.push_back(skin.graph().cells()[cell].id);
    }
  }
  forecast.retake.assign(retake.begin(), retake.end());
}

}  // namespace

std::optional<Forecast> forecastOf(const SkinLinks& skin, std::span<const PatchSolver> patches,
                                   const Reconstruction& reconstruction) {
  const PatchReconstruction* largest = largestPatch(reconstruction);
  if (largest == nullptr || largest->cells.size() < 2 || largest->gravity.empty()) return std::nullopt;
  const PatchSolver& patch = patches[largest->id.value()];
  if (patch.joint() == nullptr) return std::nullopt;
  Forecast forecast;
  forecast.now = worstUncertainty(*largest);
  if (forecast.now.orientation_rad <= kGoodOrientation_rad && forecast.now.position_m <= kGoodPosition_m) {
    return std::nullopt;
  }
  const PoseAdvice advice = adviseNextPose(skin.model(), directionsSeen(reconstruction));
  forecast.with_pose = worstWith(*largest, patch.joint()->covariancesWithPose(advice.up));
  findLackingReadings(skin, patch, forecast);
  forecast.with_all_readings = forecast.now;
  if (!forecast.retake.empty()) {
    forecast.with_all_readings = worstWith(*largest, patch.joint()->covariancesWithAllReadings());
  }
  return forecast;
}

}  // namespace hexoderm
