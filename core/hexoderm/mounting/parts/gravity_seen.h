#pragma once

// Gravity as one rigid body sees it, what patches, parts and links are compared by.

#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// Two unit vectors at right angles to `up` (unit) and to each other: small errors of a direction have two components.
/// The same for the same `up`.
Eigen::Matrix<double, 3, 2> acrossBasis(const Eigen::Vector3d& up);

/// Axes all around (either sign being the same), evenly.
std::vector<Eigen::Vector3d> axesAllAround(int count);

/// The direction of gravity (up, unit) in P poses in the frame of one rigid body. Errors are across the directions: up
/// + acrossBasis(up) e, and e of all poses are jointly normal.
struct GravitySeen {
  std::vector<PoseId> poses;        ///< each once
  std::vector<Eigen::Vector3d> up;  ///< per pose
  Eigen::MatrixXd covariance;       ///< 2P x 2P, rad^2, positive definite

  [[nodiscard]] std::size_t size() const { return poses.size(); }
  /// Of a pose, along the worst direction across `up`.
  [[nodiscard]] double worstDeviation(std::size_t pose) const;
};

/// Of a patch in a fresh result of the global solver, in those of its poses (indices of PatchReconstruction::gravity,
/// each pose once). A body that is turned while it is sampled feels another force at
/// every point. Between patches whose places on the body are not known that is noise: `lever_m` is how far, 1 sigma an
/// axis, a patch's middle is from the point at which the body's gravity is meant. `tremor_share`: of the variance that
/// a hand's tremor brings about, which the solver grants each reading (meanHandShare()).
GravitySeen gravityOf(const PatchReconstruction& patch, std::span<const std::size_t> used, double lever_m,
                      double tremor_share = 1);

/// Whether all directions lie along one line, either way, within 15 degrees of it: a turn about it doesn't show.
bool lieOnOneLine(const std::vector<Eigen::Vector3d>& up);

/// The poses at these indices.
GravitySeen onlyPoses(const GravitySeen& seen, std::span<const std::size_t> indices);

/// The poses that both have, as indices into a and b.
struct CommonPoses {
  std::vector<std::size_t> in_a;
  std::vector<std::size_t> in_b;
};
CommonPoses commonPoses(const GravitySeen& a, const GravitySeen& b);

}  // namespace hexoderm
