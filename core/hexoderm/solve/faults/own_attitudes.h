#pragma once

// What the readings of every cell of a patch say about its attitude.

#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/rigidity.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// Variance of an angle of which nothing is known, rad^2.
inline constexpr double kUnknownVariance = kPi * kPi / 3;

/// The specific forces of one pose on a patch, in its frame.
struct PatchForce {
  std::size_t pose = 0;  ///< of the snapshot
  Eigen::Vector3d at_origin_o = Eigen::Vector3d::Zero();
  Eigen::Vector3d swing_o = Eigen::Vector3d::Zero();  ///< force(x) = at_origin + swing x x
  /// Of the swing, g^2/m^2, where it was found by findOwnAttitudes().
  Eigen::Matrix3d swing_covariance_o = Eigen::Matrix3d::Zero();
};

/// A cell as its own readings have it.
struct OwnCell {
  bool known = false;                                     ///< it has readings
  Eigen::Matrix3d R_o_u = Eigen::Matrix3d::Identity();    ///< where it is not known, the estimate's
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of its error e in R_true = R exp(e), cell frame, rad^-2
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();   ///< the inverse of that
  std::vector<CellReading> readings;  ///< without the lot's errors, if they are known; poses are indices of forces
  std::vector<Eigen::Vector3d> f_o;   ///< per reading
};

struct OwnAttitudes {
  AccelerometerPrior prior;  ///< of the sensors' errors
  std::vector<OwnCell> cells;
  std::vector<PatchForce> forces;
};

/// The attitude of every cell in `cells` (of the graph) at which its readings are most probable, errors of its sensor
/// granted (findAttitude(), several at a time). `placements`: per cell, where it lies and where the search starts.
/// `lot`: what the sensors share, as it was estimated with the forces. Null: it is not known, and the forces are of
/// sensors as they read, held still. Then each pose's force, and how a hand swings the part meanwhile, are found in
/// turn with the attitudes: far from the middle cells read another force than near it.
OwnAttitudes findOwnAttitudes(const SkinLinks& skin, std::span<const std::size_t> cells, std::vector<PatchForce> forces,
                              std::span<const SE3> placements, const SensorLot* lot);

}  // namespace hexoderm
