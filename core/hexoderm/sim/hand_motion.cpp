#include "hexoderm/sim/hand_motion.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr int kWavesPerAxis = 6;
constexpr double kLowestTremor_hz = 4;
constexpr double kHighestTremor_hz = 12;
constexpr double kDriftsOneWay_s = 3;  // before the person notices and comes back, as far beyond the middle

/// Seconds of drift that are left after so long a time, and whether it goes forth (1) or back (-1).
struct Drift {
  double seconds = 0;
  double way = 0;
};
Drift driftAfter(double time_s) {
  if (time_s < 0) return {};
  const double phase_s = std::fmod(time_s + kDriftsOneWay_s, 4 * kDriftsOneWay_s);
  if (phase_s < 2 * kDriftsOneWay_s) return {phase_s - kDriftsOneWay_s, 1};
  return {3 * kDriftsOneWay_s - phase_s, -1};
}

}  // namespace

HandMotion::HandMotion(const Eigen::Vector3d& up_b) : R_w_b_(shortestRotation(up_b, Eigen::Vector3d::UnitZ())) {}

HandMotion::HandMotion(const Eigen::Vector3d& up_b, const SimulatedSkinOptions& options, std::mt19937_64& random)
    : HandMotion(up_b) {
  std::normal_distribution<double> normal;
  // Drawn one after the other: the order of evaluation inside a call would be the compiler's choice.
  const double miss_y = normal(random);
  const double miss_x = normal(random);
  const Eigen::Vector3d miss = options.hand_orientation_sigma_rad * Eigen::Vector3d(miss_x, miss_y, 0);
  R_w_b_ = expSO3(miss) * R_w_b_;
  Eigen::Vector3d drift{normal(random), normal(random), normal(random)};
  drift_rad_s_ = options.drift_rad_per_s * drift.normalized();
  turn_ = drawWaves(options.tremor_angle_sigma_rad, random);
  shake_ = drawWaves(options.tremor_acceleration_g, random);
  moves_ = true;
}

HandMotion::Axes HandMotion::drawWaves(double rms, std::mt19937_64& random) {
  std::uniform_real_distribution<double> rate(2 * kPi * kLowestTremor_hz, 2 * kPi * kHighestTremor_hz);
  std::uniform_real_distribution<double> phase(0, 2 * kPi);
  Axes axes;
  for (std::vector<Wave>& waves : axes) {
    for (int k = 0; k < kWavesPerAxis; ++k) {
      const double rate_rad_s = rate(random);
      waves.push_back({rms * std::sqrt(2.0 / kWavesPerAxis), rate_rad_s, phase(random)});
    }
  }
  return axes;
}

void HandMotion::arriveFrom(const Eigen::Matrix3d& R_w_b, double fastest_rad_s) {
  way_rad_ = logSO3(R_w_b * (expSO3(turnAt(0)) * R_w_b_).transpose());
  arrival_s_ = kPeakOverMean * way_rad_.norm() / fastest_rad_s;
}

HandMotion::Approach HandMotion::approachAt(double time_s) const {
  if (time_s >= arrival_s_) return {};
  const double x = std::max(time_s, 0.0) / arrival_s_;
  const double done = minimumJerk(x);
  const double rate = 30 * x * x * (1 - x) * (1 - x) / arrival_s_;
  const double acceleration = 60 * x * (1 - x) * (1 - 2 * x) / (arrival_s_ * arrival_s_);
  return {(1 - done) * way_rad_, -rate * way_rad_, -acceleration * way_rad_};
}

Eigen::Vector3d HandMotion::turnAt(double time_s) const {
  // Drift begins when the part is there.
  Eigen::Vector3d turn = drift_rad_s_ * driftAfter(time_s - arrival_s_).seconds;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Wave& wave : turn_.at(static_cast<std::size_t>(axis))) {
      turn(axis) += wave.amplitude * std::sin(wave.rate_rad_s * time_s + wave.phase_rad);
    }
  }
  return turn;
}

Eigen::Matrix3d HandMotion::orientationAt(double time_s) const {
  return expSO3(approachAt(time_s).left_rad) * expSO3(turnAt(time_s)) * R_w_b_;
}

BodyMotion HandMotion::at(double time_s) const {
  if (!moves_ && time_s >= arrival_s_) return {R_w_b_.transpose() * Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero()};
  const Approach approach = approachAt(time_s);
  const Eigen::Vector3d turn = turnAt(time_s);
  Eigen::Vector3d rate = drift_rad_s_ * driftAfter(time_s - arrival_s_).way;
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::UnitZ();
  for (int axis = 0; axis < 3; ++axis) {
    for (const Wave& wave : turn_.at(static_cast<std::size_t>(axis))) {
      const double angle = wave.rate_rad_s * time_s + wave.phase_rad;
      rate(axis) += wave.amplitude * wave.rate_rad_s * std::cos(angle);
      acceleration(axis) -= wave.amplitude * wave.rate_rad_s * wave.rate_rad_s * std::sin(angle);
    }
    for (const Wave& wave : shake_.at(static_cast<std::size_t>(axis))) {
      force(axis) += wave.amplitude * std::sin(wave.rate_rad_s * time_s + wave.phase_rad);
    }
  }
  // Angular velocity and acceleration of exp(turn), to second order in the small turn; those of the way to the pose
  // come on top.
  const Eigen::Matrix3d still_to_go = expSO3(approach.left_rad);
  const Eigen::Vector3d omega = approach.rate_rad_s + still_to_go * (rate + turn.cross(rate) / 2);
  const Eigen::Vector3d alpha =
      approach.acceleration_rad_s2 + still_to_go * (acceleration + turn.cross(acceleration) / 2);
  const Eigen::Matrix3d R_b_w = (still_to_go * expSO3(turn) * R_w_b_).transpose();
  const Eigen::Matrix3d field_w = (skew(alpha) + skew(omega) * skew(omega)) / kStandardGravity;
  return {R_b_w * force, R_b_w * field_w * R_b_w.transpose()};
}

}  // namespace hexoderm
