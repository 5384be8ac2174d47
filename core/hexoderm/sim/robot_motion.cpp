#include "hexoderm/sim/robot_motion.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kReach_rad = 60 * kDegree;
constexpr double kShortestStay_s = 3;
constexpr double kLongestStay_s = 8;
// Readings 50 ms apart then correlate by 0.3, as those of the real leg do by 0 to 0.4.
constexpr double kCorrelation_s = 0.04;

/// Van der Corput's sequence in base 2, 0 to 1: every number far from those before it.
double spread(std::size_t number) {
  double value = 0;
  for (double share = 0.5; number > 0; number /= 2, share /= 2) value += share * static_cast<double>(number % 2);
  return value;
}

Eigen::Vector3d upAt(double angle_rad) { return {0, std::sin(angle_rad), std::cos(angle_rad)}; }

}  // namespace

RobotMotion::RobotMotion(const SimulatedSkinOptions& options, std::size_t cells) {
  std::mt19937_64 random = randomStream(options.seed, Stream::Vibration);
  std::uniform_real_distribution<double> rms(options.least_vibration_g, options.most_vibration_g);
  cells_.reserve(cells);
  for (std::size_t k = 0; k < cells; ++k) {
    const double x = rms(random);
    const double y = rms(random);
    cells_.push_back({{x, y, rms(random)}});
  }
}

Eigen::Vector3d RobotMotion::upOf(std::size_t hold) {
  // Upright, at one end, at the other, and then in between.
  if (hold == 0) return upAt(0);
  if (hold <= 2) return upAt(hold == 1 ? kReach_rad : -kReach_rad);
  return upAt(kReach_rad * (1 - 2 * spread(hold - 1)));
}

Eigen::Vector3d RobotMotion::nearestTo(const Eigen::Vector3d& up_b) {
  return upAt(std::clamp(std::atan2(up_b.y(), up_b.z()), -kReach_rad, kReach_rad));
}

double RobotMotion::staysFor_s(std::size_t hold) {
  return kLongestStay_s - (kLongestStay_s - kShortestStay_s) * spread(hold);
}

Eigen::Vector3d RobotMotion::vibration(std::size_t cell, double step_s, const Eigen::Vector3d& unit) {
  Shaken& shaken = cells_[cell];
  // Noise through a low pass of first order, stationary from its first value on.
  const double kept = shaken.has_begun ? std::exp(-step_s / kCorrelation_s) : 0;
  shaken.now = kept * shaken.now + std::sqrt(1 - kept * kept) * unit;
  shaken.has_begun = true;
  return shaken.rms_g.cwiseProduct(shaken.now);
}

}  // namespace hexoderm
