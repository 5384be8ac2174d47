#include "hexoderm/mounting/parts/compared_poses.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/mounting/parts/farthest_first.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace hexoderm {
namespace {

/// What a patch sees in a pose; of a pose that is there twice the first.
using UpByPose = std::map<PoseId, Eigen::Vector3d>;

UpByPose upByPose(const PatchReconstruction& patch) {
  UpByPose up;
  for (const GravityDirection& gravity : patch.gravity) up.emplace(gravity.pose, gravity.g_o);
  return up;
}

/// A pose counts as different from another one by what the patch that tells them apart best sees.
double differenceOf(const std::vector<UpByPose>& patches, PoseId a, PoseId b) {
  double largest = 0;
  for (const UpByPose& up : patches) {
    const auto at_a = up.find(a);
    const auto at_b = up.find(b);
    if (at_a != up.end() && at_b != up.end()) largest = std::max(largest, angleBetween(at_a->second, at_b->second));
  }
  return largest;
}

}  // namespace

std::vector<PoseId> posesOf(const std::vector<const PatchReconstruction*>& patches) {
  std::vector<PoseId> poses;
  for (const PatchReconstruction* patch : patches) {
    for (const GravityDirection& gravity : patch->gravity) poses.push_back(gravity.pose);
  }
  std::ranges::sort(poses);
  poses.erase(std::unique(poses.begin(), poses.end()), poses.end());
  return poses;
}

std::vector<PoseId> differentPoses(const std::vector<const PatchReconstruction*>& patches,
                                   const std::vector<PoseId>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<UpByPose> up;
  for (const PatchReconstruction* patch : patches) up.push_back(upByPose(*patch));
  std::vector<PoseId> chosen;
  const auto difference = [&](std::size_t a, std::size_t b) { return differenceOf(up, all[a], all[b]); };
  for (const std::size_t k : farthestFirst(all.size(), most, 0, difference)) chosen.push_back(all[k]);
  std::ranges::sort(chosen);
  return chosen;
}

GravitySeen gravityIn(const PatchReconstruction& patch, const std::vector<PoseId>& poses, double lever_m,
                      double tremor_share) {
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < patch.gravity.size(); ++k) {
    const PoseId pose = patch.gravity[k].pose;
    const bool is_first = std::ranges::none_of(used, [&](std::size_t u) { return patch.gravity[u].pose == pose; });
    if (is_first && std::ranges::binary_search(poses, pose)) used.push_back(k);
  }
  return gravityOf(patch, used, lever_m, tremor_share);
}

double meanHandShare(const std::function<double(double hand_share)>& log_evidence) {
  constexpr std::array<double, 7> kShares = {1, 1. / 2, 1. / 4, 1. / 8, 1. / 16, 1. / 32, 1. / 64};
  std::array<double, kShares.size()> evidence{};
  std::ranges::transform(kShares, evidence.begin(), log_evidence);
  const double most = *std::ranges::max_element(evidence);
  double sum = 0;
  double weights = 0;
  for (std::size_t k = 0; k < kShares.size(); ++k) {
    const double weight = std::exp(evidence[k] - most);
    sum += weight * kShares[k];
    weights += weight;
  }
  return sum / weights;
}

}  // namespace hexoderm
