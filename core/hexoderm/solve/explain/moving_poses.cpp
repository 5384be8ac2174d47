#include "hexoderm/base/median.h"
#include "hexoderm/solve/explain/explainer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

struct MovingPose {
  std::size_t pose = 0;  ///< of the snapshot
  double times = 1;      ///< the limit that it passes furthest
};

/// Per pose of the joint estimate: what it leaves unexplained of the reading of the middle one of all cells, in
/// standard deviations. A few bad cells do not count.
std::vector<double> middleMisfits(const SkinLinks& skin, const PatchSolver& patch) {
  const GlobalRefinement& joint = *patch.joint();
  std::vector<std::vector<double>> of_cells(joint.poses().size());
  for (const std::size_t cell : patch.cells()) {
    for (std::size_t k = 0; k < joint.readingsOf(cell).size(); ++k) {
      const std::size_t pose = joint.readingsOf(cell)[k].pose;
      const double variance_g2 = skin.table().at(cell, joint.poses()[pose]).variance_g2;
      of_cells[pose].push_back(joint.sensorOf(cell).residual_g[k].norm() / std::sqrt(3 * variance_g2));
    }
  }
  std::vector<double> middle;
  for (std::vector<double>& misfits : of_cells) middle.push_back(misfits.empty() ? 0 : median(std::move(misfits)));
  return middle;
}

/// A pose beyond all limits: no pose of 480 simulated skins of 13 shapes, in a hand and on a robot, comes near.
void findMovingPose(const SkinLinks& skin, const PatchSolver& patch, std::optional<MovingPose>& worst) {
  constexpr std::size_t kFewestPoses = 3;
  constexpr double kMaxMisfit = 0.7;
  constexpr double kTimesOthers = 3;
  const GlobalRefinement& joint = *patch.joint();
  if (joint.poses().size() < kFewestPoses) return;
  const std::vector<double> misfits = middleMisfits(skin, patch);
  const double limit = std::max(kMaxMisfit, kTimesOthers * median(misfits));
  for (std::size_t k = 0; k < misfits.size(); ++k) {
    const double times = misfits[k] / limit;
    if (times > (worst ? worst->times : 1)) worst = MovingPose{joint.poses()[k], times};
  }
}

std::optional<Explanation> explainMovingPoses(const Estimate& estimate) {
  std::optional<MovingPose> worst;
  for (const PatchSolver& patch : estimate.patches()) {
    if (patch.joint() != nullptr) findMovingPose(estimate.skin(), patch, worst);
  }
  if (!worst) return std::nullopt;
  Explanation found;
  found.poses = {worst->pose};
  const PoseId id = estimate.skin().poseId(worst->pose);
  found.findings = {makeFinding(FindingCode::InconsistentPose,
                                message("In pose {} the cells do not feel one and the same gravity, as they do in the "
                                        "others: the part was in motion. The pose is not used; take it again.",
                                        id),
                                {}, {}, {id})};
  return found;
}

}  // namespace

Explainer makeMovingPoseExplainer() { return {Estimate::Stage::Patches, explainMovingPoses}; }

}  // namespace hexoderm
