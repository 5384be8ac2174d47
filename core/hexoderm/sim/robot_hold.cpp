#include "hexoderm/sim/robot_hold.h"

#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kFastestJoint_rad_s = 60 * kDegree;
constexpr double kFastestSlide_m_s = 0.1;
constexpr double kQuotientStep_s = 1e-3;

/// The motion of a body that the robot carries, from that of the base.
BodyMotion seenFrom(const Eigen::Matrix3d& R_w_b, const BodyMotion& motion_w) {
  return {R_w_b.transpose() * motion_w.up_b, R_w_b.transpose() * motion_w.field_b * R_w_b};
}

template <class Value>
Value secondDerivative(const Value& before, const Value& now, const Value& after) {
  return (before - 2.0 * now + after) / (kQuotientStep_s * kQuotientStep_s);
}

}  // namespace

RobotHold::RobotHold(RobotModel robot, JointAngles angles, HandMotion base, const Eigen::Vector3d& hand_w)
    : robot_(std::move(robot)),
      angles_(std::move(angles)),
      base_(std::move(base)),
      hand_w_(hand_w),
      T_w_l_(robot_.forward(angles_)),
      from_(angles_) {}

void RobotHold::arriveFrom(const RobotHold& before, double time_s) {
  base_.arriveFrom(before.orientationAt(time_s));
  from_ = before.anglesAt(time_s);
  joints_arrive_s_ = 0;
  for (const auto& [name, position] : angles_.positions) {
    const bool slides = robot_.joints()[robot_.jointNamed(name)].type == JointType::Prismatic;
    const double way = std::abs(position - from_.positions.at(name));
    joints_arrive_s_ =
        std::max(joints_arrive_s_, kPeakOverMean * way / (slides ? kFastestSlide_m_s : kFastestJoint_rad_s));
  }
}

double RobotHold::arrival_s() const { return std::max(joints_arrive_s_, base_.arrival_s()); }

JointAngles RobotHold::anglesAt(double time_s) const {
  if (time_s >= joints_arrive_s_) return angles_;
  const double left = 1 - minimumJerk(std::max(time_s, 0.0) / joints_arrive_s_);
  JointAngles angles = angles_;
  for (auto& [name, position] : angles.positions) position += left * (from_.positions.at(name) - position);
  return angles;
}

const std::array<RobotHold::Stance, 3>& RobotHold::around(double time_s) const {
  if (around_s_ == time_s) return around_;
  around_s_ = time_s;
  for (std::size_t k = 0; k < around_.size(); ++k) {
    const double then_s = time_s + (static_cast<double>(k) - 1) * kQuotientStep_s;
    around_[k] = {orientationAt(then_s), robot_.forward(anglesAt(then_s))};
  }
  return around_;
}

Eigen::Vector3d RobotHold::handIn(std::size_t link, const SE3& T_l_b) const {
  return (T_w_l_[link] * T_l_b).inverse() * hand_w_;
}

BodyMotion RobotHold::motionOf(std::size_t link, const SE3& T_l_b, double time_s) const {
  const BodyMotion base = base_.at(time_s);
  if (time_s >= joints_arrive_s_) return seenFrom((T_w_l_[link] * T_l_b).R, base);
  const Eigen::Vector3d hand_b = handIn(link, T_l_b);
  std::array<Eigen::Matrix3d, 3> R_v_b;
  std::array<Eigen::Vector3d, 3> place_v;
  const std::array<Stance, 3>& stances = around(time_s);
  for (std::size_t k = 0; k < stances.size(); ++k) {
    const SE3 T_w_b = stances[k].T_w_l[link] * T_l_b;
    R_v_b[k] = stances[k].R_v_w * T_w_b.R;
    place_v[k] = stances[k].R_v_w * (T_w_b * hand_b - hand_w_);
  }
  const Eigen::Vector3d acceleration_v = secondDerivative(place_v[0], place_v[1], place_v[2]);
  const Eigen::Matrix3d turning_v = secondDerivative(R_v_b[0], R_v_b[1], R_v_b[2]);
  const Eigen::Vector3d force_v = stances[1].R_v_w * base.up_b + acceleration_v / kStandardGravity;
  return {R_v_b[1].transpose() * force_v, R_v_b[1].transpose() * turning_v / kStandardGravity};
}

}  // namespace hexoderm
