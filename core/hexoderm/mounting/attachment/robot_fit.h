#pragma once

// All patches on their links, joints and base together.

#include "hexoderm/mounting/attachment/link_fit.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace hexoderm {

/// A patch on a link that it is taken to be on.
struct PatchOnKnownLink {
  const SeenByPatch* patch = nullptr;
  std::size_t link = 0;
  Eigen::Matrix3d R_l_o = Eigen::Matrix3d::Identity();  ///< about
};

struct RobotFit {
  std::vector<Eigen::Matrix3d> R_l_o;
  std::vector<std::size_t> joints;  ///< the free joints that turn any of the links, ascending
  std::vector<double> zeros;        ///< of these, rad
  double zero_sigma_rad = 0;        ///< how large zeros were taken to be; at least the prior
  Eigen::Vector3d up_w = Eigen::Vector3d::UnitZ();
  /// Of the errors of each turn (3), the zeros, and up_w (3, of rank 2).
  Eigen::MatrixXd covariance;
  GravityMisfit misfit;
  /// Logarithm of how probable what the patches saw is, but for a constant; of use for comparing covariances of the
  /// same patches.
  double log_evidence = 0;

  struct PoseTurn {
    std::size_t place = 0;
    std::size_t joint = 0;
    double turn_rad = 0;
    double sigma_rad = 0;
  };
  std::vector<PoseTurn> pose_turns;  ///< of each joint in each pose: see JointResidual
};

/// Maximum likelihood. How large the zeros of this robot are is not taken from the prior alone: all of them share a
/// scale (Student's t with one degree of freedom, so that a robot with zeros of 2 degrees is improbable but not
/// impossible), which is estimated by expectation and maximisation and never below the prior; the base's tilt likewise.
RobotFit fitRobot(std::span<const PatchOnKnownLink> patches, const RobotModel& robot,
                  std::span<const JointAngles> angles, const Eigen::Vector3d& up_w, const RobotPriors& priors);

}  // namespace hexoderm
