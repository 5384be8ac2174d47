#pragma once

// How a robot stands in a pose, and how it comes there.

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/hand_motion.h"
#include "hexoderm/sim/simulated_skin.h"

#include <array>
#include <cstddef>
#include <vector>

namespace hexoderm {

/// A robot while one pose is held: its joints stand still, and the whole of it moves as its base does. Frames: `w` the
/// base, `b` a body that a link carries, `v` the world, whose z is up.
class RobotHold {
 public:
  /// `angles`: where the joints truly stand. `base`: how the base is held and moved, about the point `hand_w`.
  RobotHold(RobotModel robot, JointAngles angles, HandMotion base, const Eigen::Vector3d& hand_w);

  /// Begins where `before` was at that time of its own. From there all joints move at once, smoothly and no faster than
  /// 60 degrees or 0.1 m a second, and the base is turned as HandMotion::arriveFrom() has it.
  void arriveFrom(const RobotHold& before, double time_s);
  [[nodiscard]] double arrival_s() const;

  [[nodiscard]] JointAngles anglesAt(double time_s) const;
  /// R_v_w.
  [[nodiscard]] Eigen::Matrix3d orientationAt(double time_s) const { return base_.orientationAt(time_s); }
  /// Of a body with the placement T_l_b on a link. While joints move, its acceleration is the difference quotient of
  /// where it is 1 ms before and after.
  [[nodiscard]] BodyMotion motionOf(std::size_t link, const SE3& T_l_b, double time_s) const;
  /// The point of the body that motionOf() refers to: the one that is in the hand once all joints stand.
  [[nodiscard]] Eigen::Vector3d handIn(std::size_t link, const SE3& T_l_b) const;

 private:
  struct Stance {
    Eigen::Matrix3d R_v_w;
    std::vector<SE3> T_w_l;
  };
  /// Before, at and after that time.
  [[nodiscard]] const std::array<Stance, 3>& around(double time_s) const;

  RobotModel robot_;
  JointAngles angles_;
  HandMotion base_;
  Eigen::Vector3d hand_w_;
  std::vector<SE3> T_w_l_;  ///< once all joints stand
  JointAngles from_;
  double joints_arrive_s_ = 0;
  // All bodies are asked for at one time, and the links are where they are for all of them.
  mutable double around_s_ = -1;
  mutable std::array<Stance, 3> around_;
};

}  // namespace hexoderm
