#include "hexoderm/solve/estimate/forecast.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

/// Uncertainty at the worst cell that counts if the patch's cells had these covariances.
Uncertainty95 worstOf(const SkinLinks& skin, const PatchSolver& patch, const std::vector<Matrix6d>& covariances) {
  const auto measured = [&](std::size_t k) { return skin.readings().measured(patch.cells()[k]); };
  std::vector<Matrix6d> counted;
  for (const std::size_t k : countedCells(covariances.size(), measured)) counted.push_back(covariances[k]);
  return worstUncertainty(counted);
}

std::vector<Matrix6d> covariancesOf(const PatchSolver& patch) {
  std::vector<Matrix6d> covariances;
  covariances.reserve(patch.cells().size());
  for (const std::size_t cell : patch.cells()) covariances.push_back(patch.joint()->covarianceOf(cell));
  return covariances;
}

std::vector<Eigen::Vector3d> forceDirections(const GlobalRefinement& joint) {
  std::vector<Eigen::Vector3d> seen;
  for (const Eigen::Vector3d& force_o : joint.solution().state.force_o) seen.emplace_back(force_o.normalized());
  return seen;
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

std::optional<Forecast> forecastOf(const SkinLinks& skin, std::span<const PatchSolver> patches) {
  const auto largest = std::ranges::max_element(patches, {}, [](const PatchSolver& p) { return p.cells().size(); });
  if (largest == patches.end() || largest->cells().size() < 2) return std::nullopt;
  const GlobalRefinement* joint = largest->joint();
  if (joint == nullptr || joint->poses().empty()) return std::nullopt;
  Forecast forecast;
  forecast.now = worstOf(skin, *largest, covariancesOf(*largest));
  if (meets(forecast.now, skin.options().goal)) return std::nullopt;
  const PoseAdvice advice = adviseNextPose(skin.model(), forceDirections(*joint));
  forecast.with_pose = worstOf(skin, *largest, joint->covariancesWithPose(advice.up));
  findLackingReadings(skin, *largest, forecast);
  forecast.with_all_readings = forecast.now;
  if (!forecast.retake.empty()) {
    forecast.with_all_readings = worstOf(skin, *largest, joint->covariancesWithAllReadings());
  }
  return forecast;
}

}  // namespace hexoderm
