#include "hexoderm/mounting/parts/gravity_seen.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/units.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace hexoderm {
namespace {

/// Angular acceleration, rms per axis, that counts where none is estimated: a usual tremor's in a mean over 0.1 s.
constexpr double kTremor_g_m = 0.6 / kStandardGravity;
/// No direction is known better than this; keeps covariances of noiseless data positive definite.
constexpr double kMinSigma_rad = 1e-6;

/// What a swing does to the force at a point whose place is known to `lever_m` an axis only: per pose the lever arm's
/// matrix, and the variance that the swing's own error adds.
struct SwingNoise {
  std::vector<Eigen::Matrix3d> arms;
  std::vector<Eigen::Matrix3d> own;
};

SwingNoise swingNoise(const PatchReconstruction& patch, double lever_m) {
  SwingNoise noise;
  for (std::size_t pose = 0; pose < patch.gravity.size(); ++pose) {
    const std::optional<Eigen::Matrix3d> known = patch.gravity_covariance->swing(pose);
    const Eigen::Matrix3d C = known.value_or(Eigen::Matrix3d::Identity() * kTremor_g_m * kTremor_g_m);
    const auto& force = patch.gravity[pose].force;
    noise.arms.push_back(lever_m * skew(known && force ? force->swing_o : Eigen::Vector3d::Zero()));
    // E [s]x [s]x^T = (s s) I - s s^T
    noise.own.push_back(lever_m * lever_m * (C.trace() * Eigen::Matrix3d::Identity() - C));
  }
  return noise;
}

Eigen::Index blockOf(std::size_t pose) { return static_cast<Eigen::Index>(2 * pose); }

}  // namespace

Eigen::Matrix<double, 3, 2> acrossBasis(const Eigen::Vector3d& up) {
  Eigen::Index smallest = 0;
  up.cwiseAbs().minCoeff(&smallest);
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = up.cross(Eigen::Vector3d::Unit(smallest)).normalized();
  basis.col(1) = up.cross(basis.col(0));
  return basis;
}

std::vector<Eigen::Vector3d> axesAllAround(int count) {
  const double golden = kPi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> axes;
  for (int k = 0; k < count; ++k) {
    const double z = (k + 0.5) / count;
    const double s = std::sqrt(1 - z * z);
    axes.emplace_back(s * std::cos(golden * k), s * std::sin(golden * k), z);
  }
  return axes;
}

double GravitySeen::worstDeviation(std::size_t pose) const {
  const auto at = static_cast<Eigen::Index>(2 * pose);
  Eigen::Matrix3d padded = Eigen::Matrix3d::Zero();
  padded.topLeftCorner<2, 2>() = covariance.block<2, 2>(at, at);
  return largestDeviation(padded);
}

GravitySeen gravityOf(const PatchReconstruction& patch, std::span<const std::size_t> used, double lever_m,
                      double tremor_share) {
  GravitySeen seen;
  for (const std::size_t k : used) {
    seen.poses.push_back(patch.gravity[k].pose);
    seen.up.push_back(patch.gravity[k].g_o);
  }
  const SwingNoise noise = swingNoise(patch, lever_m);
  const std::shared_ptr<const GravityCovariance> quiet =
      tremor_share < 1 ? patch.gravity_covariance->withoutTremor() : nullptr;
  seen.covariance.setZero(blockOf(used.size()), blockOf(used.size()));
  for (std::size_t a = 0; a < used.size(); ++a) {
    const Eigen::Matrix<double, 3, 2> across_a = acrossBasis(seen.up[a]);
    for (std::size_t b = a; b < used.size(); ++b) {
      Eigen::Matrix3d C = patch.gravity_covariance->forces(used[a], used[b]);
      if (quiet != nullptr) C = tremor_share * C + (1 - tremor_share) * quiet->forces(used[a], used[b]);
      C += noise.arms[used[a]] * noise.arms[used[b]].transpose();
      if (a == b) C += noise.own[used[a]] + kMinSigma_rad * kMinSigma_rad * Eigen::Matrix3d::Identity();
      const Eigen::Matrix2d block = across_a.transpose() * C * acrossBasis(seen.up[b]);
      seen.covariance.block<2, 2>(blockOf(a), blockOf(b)) = block;
      seen.covariance.block<2, 2>(blockOf(b), blockOf(a)) = block.transpose();
    }
  }
  return seen;
}

bool lieOnOneLine(const std::vector<Eigen::Vector3d>& up) {
  constexpr double kOnOneLine_rad = 15 * kDegree;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& g : up) spread += g * g.transpose();
  const Eigen::Vector3d line = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  return std::ranges::all_of(up,
                             [&](const Eigen::Vector3d& g) { return line.cross(g).norm() < std::sin(kOnOneLine_rad); });
}

GravitySeen onlyPoses(const GravitySeen& seen, std::span<const std::size_t> indices) {
  GravitySeen result;
  result.covariance.resize(blockOf(indices.size()), blockOf(indices.size()));
  for (std::size_t a = 0; a < indices.size(); ++a) {
    result.poses.push_back(seen.poses[indices[a]]);
    result.up.push_back(seen.up[indices[a]]);
    for (std::size_t b = 0; b < indices.size(); ++b) {
      result.covariance.block<2, 2>(blockOf(a), blockOf(b)) =
          seen.covariance.block<2, 2>(blockOf(indices[a]), blockOf(indices[b]));
    }
  }
  return result;
}

CommonPoses commonPoses(const GravitySeen& a, const GravitySeen& b) {
  std::unordered_map<PoseId, std::size_t> places;
  for (std::size_t k = 0; k < b.size(); ++k) places.emplace(b.poses[k], k);
  CommonPoses common;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto found = places.find(a.poses[k]);
    if (found == places.end()) continue;
    common.in_a.push_back(k);
    common.in_b.push_back(found->second);
  }
  return common;
}

}  // namespace hexoderm
