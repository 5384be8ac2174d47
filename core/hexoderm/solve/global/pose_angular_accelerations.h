#pragma once

#include "hexoderm/solve/global/global_cost.h"

#include <span>
#include <vector>

namespace hexoderm {

/// The spread of angular accelerations per axis, rad/s^2, from estimates of them and what is not known of these,
/// weighed against a usual tremor.
double accelerationSpread(const std::vector<Eigen::Vector3d>& accelerations,
                          const std::vector<Eigen::Matrix3d>& covariances);

/// The angular accelerations of poses, found in turn with everything else: for so many poses that their columns in the
/// joint equations would cost more than they are worth. Every cell's placement rests on many poses then, and every
/// pose's acceleration on many cells, so that turns are few.
struct PoseAngularAccelerations {
  std::vector<Eigen::Vector3d> acceleration_o;  ///< per pose, rad/s^2, patch frame
  std::vector<Eigen::Matrix3d> covariance;      ///< of these, for given placements, (rad/s^2)^2
  std::vector<Eigen::Vector3d> force_change_o;  ///< by how much the pose's force moves with it, g

  /// None, known to nobody.
  static PoseAngularAccelerations unknown(std::size_t poses, double sigma);
  /// Rms over poses and axes of the difference.
  [[nodiscard]] double distanceTo(const PoseAngularAccelerations& other) const;
};

/// The most probable accelerations for given placements and sensors, with each pose's force free and the prior
/// `sigma` per axis. `problem`: its readings are freed from the accelerations `now`. `sensors`: fitted to them at
/// `state`. A pose without readings keeps its prior.
PoseAngularAccelerations findAngularAccelerations(const GlobalProblem& problem, const GlobalState& state,
                                                  std::span<const SensorState> sensors,
                                                  const PoseAngularAccelerations& now, double sigma);

/// What the accelerations add to each reading of a cell at its place, in the accelerometer's axes, g; and what their
/// own error adds to the reading's variance per axis, g^2.
struct AngularAccelerationInReading {
  Eigen::Vector3d added_g;
  double variance_g2 = 0;
};
AngularAccelerationInReading swingInReading(const GlobalProblem& problem, const GlobalState& state, std::size_t cell,
                                            const AccelerometerFit& sensor, const PoseAngularAccelerations& swings,
                                            std::size_t pose);

}  // namespace hexoderm
