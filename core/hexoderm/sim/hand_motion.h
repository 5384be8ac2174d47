#pragma once

// How a person holds a body part.

#include "hexoderm/sim/simulated_skin.h"

#include <Eigen/Core>
#include <array>
#include <random>
#include <vector>

namespace hexoderm {

/// The smoothest way between two rests (minimum jerk): the share of it that is done after the share `x` of the time.
inline double minimumJerk(double x) { return x * x * x * (10 - 15 * x + 6 * x * x); }
/// Its highest rate over its mean one.
inline constexpr double kPeakOverMean = 1.875;

/// No hand turns a part faster than 120 degrees per second.
inline constexpr double kFastestTurn_rad_s = 120 * kDegree;

/// Orientation and motion of a part while one pose is held. On a table: `up_b` is up, and nothing moves. In a hand: up
/// to within a few degrees, with tremor of turn and position (every axis a sum of sinusoids of 4 to 12 Hz, whose rms
/// over a long time is the option's value) and a slow drift about a random axis, which goes to and fro: people notice a
/// drift after a while, and a held pose never becomes another one.
class HandMotion {
 public:
  /// On a table.
  explicit HandMotion(const Eigen::Vector3d& up_b);
  /// Holds the part in a hand.
  HandMotion(const Eigen::Vector3d& up_b, const SimulatedSkinOptions& options, std::mt19937_64& random);

  /// Begins elsewhere: from `R_w_b` the part is turned the shortest way to where it is to be held, smoothly and no
  /// faster than `fastest_rad_s`; it is there after arrival_s().
  void arriveFrom(const Eigen::Matrix3d& R_w_b, double fastest_rad_s = kFastestTurn_rad_s);
  [[nodiscard]] double arrival_s() const { return arrival_s_; }

  [[nodiscard]] BodyMotion at(double time_s) const;
  /// Orientation in the world, whose z is up.
  [[nodiscard]] Eigen::Matrix3d orientationAt(double time_s) const;

 private:
  /// The way from the start, in world axes: what is left of it, its rate and acceleration.
  struct Approach {
    Eigen::Vector3d left_rad = Eigen::Vector3d::Zero();
    Eigen::Vector3d rate_rad_s = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration_rad_s2 = Eigen::Vector3d::Zero();
  };
  [[nodiscard]] Approach approachAt(double time_s) const;
  [[nodiscard]] Eigen::Vector3d turnAt(double time_s) const;

  struct Wave {
    double amplitude;
    double rate_rad_s;
    double phase_rad;
  };
  using Axes = std::array<std::vector<Wave>, 3>;
  static Axes drawWaves(double rms, std::mt19937_64& random);

  Eigen::Matrix3d R_w_b_;  ///< the held orientation, before tremor and drift
  bool moves_ = false;
  Axes turn_;   ///< rad
  Axes shake_;  ///< g
  Eigen::Vector3d drift_rad_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d way_rad_ = Eigen::Vector3d::Zero();  ///< from the end to the start, world axes
  double arrival_s_ = 0;
};

}  // namespace hexoderm
