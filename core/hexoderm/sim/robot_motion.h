#pragma once

// How a robot with its motors on holds and turns a body part.

#include "hexoderm/base/units.h"
#include "hexoderm/sim/random_streams.h"
#include "hexoderm/sim/simulated_skin.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace hexoderm {

/// A single joint about the body's x axis, which is level, and vibration. Where it goes and for how long it stays
/// follow from the number of the hold.
class RobotMotion {
 public:
  RobotMotion(const SimulatedSkinOptions& options, std::size_t cells);

  static constexpr double kFastest_rad_s = 20 * kDegree;
  /// The direction that points up in a hold, body frame, counted from 0.
  static Eigen::Vector3d upOf(std::size_t hold);
  /// The reachable direction that is nearest to `up_b`.
  static Eigen::Vector3d nearestTo(const Eigen::Vector3d& up_b);
  /// For how long the part is held.
  static double staysFor_s(std::size_t hold);

  /// What vibration adds to a cell's reading at its next tick, g, `step_s` after the one before. `unit` is drawn anew
  /// for every tick: three normal numbers of variance 1.
  Eigen::Vector3d vibration(std::size_t cell, double step_s, const Eigen::Vector3d& unit);

 private:
  struct Shaken {
    Eigen::Vector3d rms_g;
    Eigen::Vector3d now = Eigen::Vector3d::Zero();  ///< of variance 1
    bool has_begun = false;
  };
  std::vector<Shaken> cells_;
};

}  // namespace hexoderm
