#pragma once

// The direction of gravity that a robot's links are expected to see.

#include "hexoderm/robots/robot_model.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace hexoderm {

/// The up direction in the frame of every link in P poses of a robot on a base that stands, and how it changes with the
/// joints' zeros and the base's tilt:
///   h_l,p = R_w_l(q_p + z)^T g_w.
/// A zero z is what has to be added to the angle that a free joint reports, rad; a joint that mimics another one turns
/// with it, unless the angles name it. Joints that slide turn nothing.
class LinkGravity {
 public:
  /// `angles`: of the poses; `zeros`: rad, by index in RobotModel::joints(), or empty for none; `up_w`: unit.
  LinkGravity(const RobotModel& robot, std::span<const JointAngles> angles, const Eigen::Vector3d& up_w,
              std::span<const double> zeros = {});

  [[nodiscard]] std::size_t poses() const { return T_w_l_.size(); }
  [[nodiscard]] Eigen::Vector3d up(std::size_t link, std::size_t pose) const {
    return T_w_l_[pose][link].R.transpose() * up_w_;
  }
  [[nodiscard]] const Eigen::Vector3d& upOfBase() const { return up_w_; }
  /// The change of up() with that of the base's, of small changes d_w of up_w.
  [[nodiscard]] Eigen::Matrix3d byUp(std::size_t link, std::size_t pose) const {
    return T_w_l_[pose][link].R.transpose();
  }
  /// The free joints that turn the link, ascending by index.
  [[nodiscard]] const std::vector<std::size_t>& jointsTo(std::size_t link) const { return joints_to_[link]; }
  /// The change of up() with the zero of a free joint, per rad.
  [[nodiscard]] Eigen::Vector3d byZero(std::size_t link, std::size_t pose, std::size_t joint) const;

 private:
  /// A joint on the way to a link, and how far it turns with the free one that it follows.
  struct Step {
    std::size_t joint = 0;
    std::size_t follows = 0;
    double multiplier = 1;
  };

  const RobotModel& robot_;
  Eigen::Vector3d up_w_;
  std::vector<std::vector<SE3>> T_w_l_;      // [pose][link]
  std::vector<std::vector<Step>> steps_to_;  // [link]
  std::vector<std::vector<std::size_t>> joints_to_;
};

}  // namespace hexoderm
