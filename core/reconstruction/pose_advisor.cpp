#include "hexoderm/reconstruction/pose_advisor.h"

#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// What an edge's rotation is known to with these up directions: rms over the three axes, radians.
double predictedSigma(const CellModel& model, const std::vector<Eigen::Vector3d>& directions) {
  // Of a difference of two cells, per axis; the floor is tremor's, which averaging does not take away.
  const double noise = 0.003 * std::sqrt(2.0);
  const double gain = model.accelerometer.scale_sigma * std::sqrt(2.0);
  const double noise_sq = noise * noise + gain * gain;
  const double offset = std::max(model.accelerometer.offset_sigma_g, 1e-6) * std::sqrt(2.0);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d shift = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& g : directions) {
    const Eigen::Matrix3d G = skew(g);
    information += G.transpose() * G;
    shift += G;
  }
  const double poses = static_cast<double>(directions.size());
  // Offsets are a nuisance of known size: the Schur complement takes out what they may have caused.
  information -= shift.transpose() * shift / (poses + noise_sq / (offset * offset));
  const double prior_sq = (model.bend_sigma_rad * model.bend_sigma_rad + model.twist_sigma_rad * model.twist_sigma_rad +
                           model.yaw_sigma_rad * model.yaw_sigma_rad) /
                          3;
  const Eigen::Matrix3d posterior = information / noise_sq + Eigen::Matrix3d::Identity() / prior_sq;
  return std::sqrt(posterior.inverse().trace() / 3);
}

/// Points spread evenly over the sphere (a Fibonacci lattice).
std::vector<Eigen::Vector3d> sphereCandidates() {
  constexpr int kCount = 400;
  const double golden = kPi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> candidates;
  for (int k = 0; k < kCount; ++k) {
    const double z = 1 - (2 * k + 1.0) / kCount;
    const double r = std::sqrt(1 - z * z);
    candidates.emplace_back(r * std::cos(golden * k), r * std::sin(golden * k), z);
  }
  return candidates;
}

}  // namespace

PoseAdvice adviseNextPose(const CellModel& model, const std::vector<Eigen::Vector3d>& seen) {
  PoseAdvice advice;
  advice.sigma_now_rad = predictedSigma(model, seen);
  advice.sigma_then_rad = advice.sigma_now_rad;
  std::vector<Eigen::Vector3d> with = seen;
  with.push_back(Eigen::Vector3d::UnitZ());
  if (seen.empty()) {
    advice.sigma_then_rad = predictedSigma(model, with);
    return advice;
  }
  bool found = false;
  for (const Eigen::Vector3d& candidate : sphereCandidates()) {
    with.back() = candidate;
    const double sigma = predictedSigma(model, with);
    if (found && sigma >= advice.sigma_then_rad) continue;
    found = true;
    advice.sigma_then_rad = sigma;
    advice.up = candidate;
  }
  return advice;
}

std::string adviceInWords(const PoseAdvice& advice, const Reconstruction& reconstruction) {
  const PatchReconstruction* largest = nullptr;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (largest == nullptr || patch.cells.size() > largest->cells.size()) largest = &patch;
  }
  if (largest == nullptr || largest->cells.empty()) return {};
  const CellPlacement* chosen = nullptr;
  double most_upright = 0;
  for (const CellPlacement& cell : largest->cells) {
    const double upright = cell.T_o_u.R.col(2).dot(advice.up);
    if (chosen == nullptr || std::abs(upright) > std::abs(most_upright) + 1e-9) {
      chosen = &cell;
      most_upright = upright;
    }
  }
  const std::string name = "cell " + toString(chosen->cell);
  const double off = toDegrees(std::acos(std::min(1.0, std::abs(most_upright))));
  // On a nearly flat patch no cell may face up or down: then its edge does, and the wall is what it faces.
  constexpr double kClearly = 45;
  if (off > kClearly) return "Turn the part so that " + name + " faces a wall, its side towards the ceiling.";
  return "Turn the part so that " + name + (most_upright > 0 ? " faces the ceiling." : " faces the floor.");
}

}  // namespace hexoderm
